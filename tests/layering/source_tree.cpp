#include "tests/layering/source_tree.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <sstream>

namespace chartflood {

namespace {

SourceFile readSource(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::filesystem::relative(file, sourceRoot()).generic_string(),
          std::string(std::istreambuf_iterator<char>(stream), {})};
}

bool isText(const std::filesystem::path& file) {
  static const std::array<std::string, 15> kEndings{".h",    ".cpp",  ".in",  ".txt",  ".cmake",
                                                    ".md",   ".json", ".sh",  ".frag", ".vert",
                                                    ".glsl", ".cff",  ".svg", ".cf",   ""};
  const std::string ending = file.extension().string();
  return std::find(kEndings.begin(), kEndings.end(), ending) != kEndings.end();
}

}  // namespace

std::filesystem::path sourceRoot() { return CHARTFLOOD_SOURCE_ROOT; }

std::vector<SourceFile> sourceFiles(const std::string& folder) {
  const std::filesystem::path start = sourceRoot() / folder;
  std::vector<SourceFile> files;
  if (std::filesystem::is_regular_file(start)) return {readSource(start)};
  for (const auto& entry : std::filesystem::recursive_directory_iterator(start)) {
    if (entry.is_regular_file() && isText(entry.path())) files.push_back(readSource(entry.path()));
  }
  std::sort(files.begin(), files.end(),
            [](const SourceFile& a, const SourceFile& b) { return a.path < b.path; });
  return files;
}

std::string folderOf(const std::string& path) { return path.substr(0, path.rfind('/')); }

bool isSource(const std::string& path) { return path.ends_with(".cpp") || path.ends_with(".h"); }

std::vector<Include> includesOf(const SourceFile& file) {
  std::vector<Include> includes;
  std::istringstream lines(file.text);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t hash = line.find_first_not_of(" \t");
    if (hash == std::string::npos || line[hash] != '#') continue;
    const std::size_t word = line.find_first_not_of(" \t", hash + 1);
    if (word == std::string::npos || line.compare(word, 7, "include") != 0) continue;
    const std::size_t open = line.find_first_of("\"<", word);
    if (open == std::string::npos) continue;
    const std::size_t close = line.find_first_of("\">", open + 1);
    includes.push_back({line.substr(open + 1, close - open - 1), line[open] == '"'});
  }
  return includes;
}

}  // namespace chartflood
