// What the documents say against what is there: options, commands, packages, generated tables.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string>

#include "app/cli/option_table.h"
#include "app/cli/parameter_page.h"
#include "core/io/mesh_formats.h"
#include "tests/layering/source_tree.h"

namespace chartflood {
namespace {

std::string fileText(const std::string& path) {
  const std::vector<SourceFile> files = sourceFiles(path);
  return files.empty() ? "" : files.front().text;
}

TEST(Readme, NamesOnlyOptionsThatExist) {
  std::set<std::string> known;
  for (const OptionInfo& option : optionTable()) {
    known.insert(option.name);
  }
  const std::string text = fileText("README.md");
  const std::regex option("--([a-z][a-z0-9-]*)");
  std::size_t found = 0;
  for (std::sregex_iterator it(text.begin(), text.end(), option), end; it != end; ++it) {
    EXPECT_TRUE(known.contains((*it)[1])) << "README.md names " << it->str();
    ++found;
  }
  EXPECT_GT(found, 10u);
}

/// The page that holds the program against the paper names options and tests of each difference.
TEST(PaperPage, NamesOnlyOptionsAndTestsThatExist) {
  std::set<std::string> options, tests;
  for (const OptionInfo& option : optionTable()) options.insert(option.name);
  const std::regex test(R"(TEST(?:_F|_P)?\((\w+),\s*(\w+)\))");
  for (const SourceFile& file : sourceFiles("tests")) {
    for (std::sregex_iterator it(file.text.begin(), file.text.end(), test), end; it != end; ++it) {
      tests.insert((*it)[1].str() + "." + (*it)[2].str());
    }
  }
  const std::string text = fileText("assets/docs/paper.md");
  const std::regex option("--([a-z][a-z0-9-]*)"), name(R"(`([A-Z]\w*\.[A-Z]\w*)`)");
  std::size_t named = 0;
  for (std::sregex_iterator it(text.begin(), text.end(), option), end; it != end; ++it) {
    EXPECT_TRUE(options.contains((*it)[1])) << it->str();
  }
  for (std::sregex_iterator it(text.begin(), text.end(), name), end; it != end; ++it, ++named) {
    EXPECT_TRUE(tests.contains((*it)[1])) << it->str();
  }
  EXPECT_GT(named, 10u);
}

/// Holds what README.md has between two marks against what the program says; writes it anew where
/// CHARTFLOOD_WRITE_README=1 is set.
void checkGenerated(const std::string& what, const std::string& made) {
  const std::string begin = "<!-- " + what + ": made from the program's table -->\n";
  const std::string end = "<!-- end of " + what + " -->\n";
  std::string text = fileText("README.md");
  const std::size_t from = text.find(begin), to = text.find(end);
  ASSERT_NE(from, std::string::npos);
  ASSERT_NE(to, std::string::npos);
  const std::size_t start = from + begin.size();
  if (std::getenv("CHARTFLOOD_WRITE_README") != nullptr) {
    text.replace(start, to - start, "\n" + made + "\n");
    std::ofstream(sourceRoot() / "README.md", std::ios::binary) << text;
    GTEST_SKIP() << "README.md was written";
  }
  EXPECT_EQ(text.substr(start, to - start), "\n" + made + "\n");
}

/// Set CHARTFLOOD_WRITE_README=1 to write the table anew after a change of the parameters.
TEST(Readme, ParameterTableIsTheProgramsOwn) { checkGenerated("parameters", parameterPage()); }

TEST(Readme, FormatTableIsTheProgramsOwn) { checkGenerated("formats", formatTable()); }

TEST(Readme, NamesEveryLibraryPackage) {
  std::istringstream lines(fileText("apt-packages.txt"));
  const std::string readme = fileText("README.md");
  std::size_t packages = 0;
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line.starts_with('#')) continue;
    std::istringstream words(line);
    std::string package, kind, reason;
    words >> package >> kind >> reason;
    EXPECT_TRUE(kind == "run" || kind == "build" || kind == "test") << line;
    EXPECT_NE(reason, "") << package << " has no reason";
    EXPECT_NE(readme.find("`" + package + "`"), std::string::npos) << package;
    ++packages;
  }
  EXPECT_GT(packages, 20u);
}

TEST(Readme, NamesOnlyFilesThatExist) {
  const std::string text = fileText("README.md");
  const std::regex link("\\]\\(([^)#:]+)\\)");
  std::size_t found = 0;
  for (std::sregex_iterator it(text.begin(), text.end(), link), end; it != end; ++it) {
    EXPECT_TRUE(std::filesystem::exists(sourceRoot() / (*it)[1].str())) << it->str();
    ++found;
  }
  EXPECT_GT(found, 2u);
}

TEST(Scripts, MayBeRun) {
  for (const char* script : {"run.sh", "test.sh", ".ci/run"}) {
    const auto permissions = std::filesystem::status(sourceRoot() / script).permissions();
    EXPECT_NE(permissions & std::filesystem::perms::owner_exec, std::filesystem::perms::none)
        << script;
  }
}

/// Places of one machine have no business in the tree.
TEST(Tree, NamesNoPlaceOfThisMachine) {
  std::vector<std::string> places{
      sourceRoot().string(), std::filesystem::path(CHARTFLOOD_MESHES).lexically_normal().string()};
  if (const char* home = std::getenv("HOME"); home != nullptr && *home != '\0') {
    places.push_back(std::string(home) + "/");
  }
  std::size_t files = 0;
  for (const char* top :
       {"core", "render", "shaders", "app", "tests", "assets", "CMakeLists.txt",
        "CMakePresets.json", "README.md", "CHANGELOG.md", "CONTRIBUTING.md", "CITATION.cff",
        "run.sh", "test.sh", "apt-packages.txt", ".ci/run", ".clang-format", ".clang-tidy"}) {
    for (const SourceFile& file : sourceFiles(top)) {
      ++files;
      for (const std::string& place : places) {
        EXPECT_EQ(file.text.find(place), std::string::npos) << file.path << " names " << place;
      }
    }
  }
  EXPECT_GT(files, 100u);
}

}  // namespace
}  // namespace chartflood
