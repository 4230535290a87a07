#pragma once
/// Programs of others that tests may use where they are installed.

#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string>

namespace chartflood::test {

/// The program's file, looked for as a shell would; empty when it is not there.
inline std::filesystem::path findTool(const std::string& name) {
  const char* const path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  std::error_code ignored;
  for (std::string folder; std::getline(folders, folder, ':');) {
    const std::filesystem::path file = std::filesystem::path(folder) / name;
    if (std::filesystem::is_regular_file(file, ignored)) return file;
  }
  return {};
}

}  // namespace chartflood::test
