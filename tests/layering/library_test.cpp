// What the built core library asks for, and whether each header stands on its own.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "tests/layering/source_tree.h"

namespace chartflood {
namespace {

struct Output {
  int status = -1;
  std::string text;
};

/// Runs a command of the shell and collects what it prints.
Output shell(const std::string& command) {
  Output output;
  std::FILE* pipe = popen((command + " 2>&1").c_str(), "r");
  if (pipe == nullptr) return output;
  std::array<char, 4096> buffer;
  for (std::size_t n; (n = std::fread(buffer.data(), 1, buffer.size(), pipe)) > 0;) {
    output.text.append(buffer.data(), n);
  }
  output.status = pclose(pipe);
  return output;
}

bool belongsToAWindow(const std::string& symbol) {
  const bool gl = symbol.starts_with("gl") && symbol.size() > 2 && std::isupper(symbol[2]) != 0;
  for (const char* beginning : {"glfw", "epoxy_", "egl", "OSMesa", "ImGui::", "CLI::"}) {
    if (symbol.starts_with(beginning)) return true;
  }
  return gl;
}

TEST(CoreLibrary, NeedsNothingOfAWindow) {
  const Output output = shell("nm --undefined-only --demangle '" CHARTFLOOD_CORE_LIBRARY "'");
  ASSERT_EQ(output.status, 0) << output.text;
  std::istringstream lines(output.text);
  std::size_t symbols = 0;
  for (std::string line; std::getline(lines, line);) {
    const std::size_t mark = line.find(" U ");
    if (mark == std::string::npos) continue;
    ++symbols;
    const std::string symbol = line.substr(mark + 3);
    EXPECT_FALSE(belongsToAWindow(symbol)) << symbol;
  }
  EXPECT_GT(symbols, 100u) << "nm lists no symbols";
}

TEST(CoreLibrary, SymbolCheckKnowsWhatItLooksFor) {
  EXPECT_TRUE(belongsToAWindow("glDrawArrays"));
  EXPECT_TRUE(belongsToAWindow("glfwInit"));
  EXPECT_TRUE(belongsToAWindow("ImGui::Begin(char const*, bool*, int)"));
  EXPECT_FALSE(belongsToAWindow("glm::length"));
  EXPECT_FALSE(belongsToAWindow("global"));
}

/// A header whose source file begins with it stands on its own: that file compiles.
bool isFirstInItsSource(const std::string& header) {
  const std::string source = header.substr(0, header.size() - 2) + ".cpp";
  if (!std::filesystem::exists(sourceRoot() / source)) return false;
  const std::vector<Include> includes = includesOf(sourceFiles(source).front());
  return !includes.empty() && includes.front().quoted && includes.front().name == header;
}

TEST(Headers, StandOnTheirOwn) {
  std::size_t bySource = 0, byCompiler = 0;
  for (const char* room : {"core", "render", "app"}) {
    for (const SourceFile& file : sourceFiles(room)) {
      if (!file.path.ends_with(".h")) continue;
      if (isFirstInItsSource(file.path)) {
        ++bySource;
        continue;
      }
      ++byCompiler;
      const std::string line = "#include \"" + file.path + "\"\\n";
      const Output output =
          shell("printf '" + line + line +
                "' | '" CHARTFLOOD_COMPILER
                "' -std=c++20 -fsyntax-only -Wall -Wextra " CHARTFLOOD_HEADER_FLAGS
                " -I '" CHARTFLOOD_SOURCE_ROOT "' -x c++ -");
      EXPECT_EQ(output.status, 0) << file.path << ":\n" << output.text;
      EXPECT_EQ(output.text, "") << file.path;
    }
  }
  EXPECT_GT(bySource, 100u);
  EXPECT_GT(byCompiler, 10u);
}

}  // namespace
}  // namespace chartflood
