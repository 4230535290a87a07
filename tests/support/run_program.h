#pragma once
/// Starts a program as a user would and collects what it says.

#include <filesystem>
#include <string>
#include <vector>

namespace chartflood {

struct ProgramRun {
  int exitCode = -1;  ///< 128 + number of the signal when one ended it
  std::string output, errors;
};

/// Runs `words` (the first is the program) in `folder` with an empty standard input and no display.
/// With `interruptAfter` >= 0 it gets SIGINT after so many milliseconds.
/// \throws std::runtime_error when it cannot be started
ProgramRun runProgramIn(const std::filesystem::path& folder, const std::vector<std::string>& words,
                        int interruptAfter = -1);

/// A new empty folder, removed with all it holds at the end.
class TemporaryFolder {
 public:
  TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder();
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

std::string readAll(const std::filesystem::path& file);
void writeAll(const std::filesystem::path& file, const std::string& text);

}  // namespace chartflood
