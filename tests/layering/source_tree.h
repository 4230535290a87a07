#pragma once
/// The files of the checkout, for tests that look at the sources themselves.

#include <filesystem>
#include <string>
#include <vector>

namespace chartflood {

struct SourceFile {
  std::string path;  ///< from the root, with '/'
  std::string text;
};

/// Root of the checkout.
std::filesystem::path sourceRoot();

/// Files below a folder of the checkout (or that one file), in the order of their paths. Without
/// generated files, pictures and hidden folders.
std::vector<SourceFile> sourceFiles(const std::string& folder);

/// "core/io" of "core/io/read_mesh.h".
std::string folderOf(const std::string& path);
/// Whether it is a header or source file of C++.
bool isSource(const std::string& path);

/// One `#include` line.
struct Include {
  std::string name;
  bool quoted = false;  ///< "name" rather than <name>
};
std::vector<Include> includesOf(const SourceFile& file);

}  // namespace chartflood
