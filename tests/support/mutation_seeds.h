#pragma once
/// Small good files of the formats that come from other programs, made here.

#include <string>
#include <vector>

#include "tests/support/zip_archive.h"

namespace chartflood::test {

struct SeedFile {
  std::string name;       ///< for messages
  std::string extension;  ///< without the dot
  std::string text;       ///< the file, unless it is an archive
  ZipFiles parts;         ///< of an archive, before they are packed
  std::string bytes() const { return parts.empty() ? text : zipArchive(parts); }
};

/// 3MF (components in two parts, with picture and transforms), X (plain and skinned), FBX (text
/// and binary), Collada, 3DS, X3D. What the
/// import library can write is written by it.
std::vector<SeedFile> mutationSeeds();

}  // namespace chartflood::test
