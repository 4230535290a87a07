// What the built core library asks for, and whether each header stands on its own.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
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

std::vector<std::string> headersOf(const std::string& folder) {
  std::vector<std::string> headers;
  for (const SourceFile& file : sourceFiles(folder)) {
    if (file.path.ends_with(".h")) headers.push_back(file.path);
  }
  return headers;
}

class HeadersAlone : public testing::TestWithParam<const char*> {};

TEST_P(HeadersAlone, Compile) {
  const std::vector<std::string> headers = headersOf(GetParam());
  ASSERT_FALSE(headers.empty());
  for (const std::string& header : headers) {
    const Output output = shell("printf '#include \"" + header + "\"\\n#include \"" + header +
                                "\"\\n' | '" CHARTFLOOD_COMPILER
                                "' -std=c++20 -fsyntax-only -Wall -Wextra " CHARTFLOOD_HEADER_FLAGS
                                " -I '" CHARTFLOOD_SOURCE_ROOT "' -x c++ -");
    EXPECT_EQ(output.status, 0) << header << ":\n" << output.text;
    EXPECT_EQ(output.text, "") << header;
  }
}

INSTANTIATE_TEST_SUITE_P(Folders, HeadersAlone,
                         testing::Values("core/base", "core/model", "core/io", "core/gauss",
                                         "core/flood", "core/segment", "core/session", "render",
                                         "app/host", "app/cli", "app/gui"),
                         [](const auto& folder) {
                           std::string name = folder.param;
                           for (char& c : name) c = c == '/' ? '_' : c;
                           return name;
                         });

}  // namespace
}  // namespace chartflood
