#pragma once
/// The header of a PLY file: which elements with which properties follow, in which encoding.

#include <cstddef>
#include <string>
#include <vector>

#include "core/io/text/source.h"

namespace chartflood {

enum class PlyType { Int8, UInt8, Int16, UInt16, Int32, UInt32, Float32, Float64 };

/// Bytes of a value in binary files.
std::size_t plySize(PlyType type);
/// True for the types without fraction.
inline bool plyIsWhole(PlyType type) { return type < PlyType::Float32; }

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::Float32;  ///< of the value, or of the list's entries
  bool list = false;
  PlyType countType = PlyType::UInt8;  ///< of a list's length
};

struct PlyElement {
  std::string name;
  std::size_t count = 0;
  std::vector<PlyProperty> properties;

  /// Place of a property in the row, or properties.size().
  std::size_t find(std::string_view property) const;
  bool hasList() const;
  /// Bytes of a binary row in which every list is empty.
  std::size_t smallestRow() const;
};

struct PlyHeader {
  enum class Encoding { Ascii, LittleEndian, BigEndian } encoding = Encoding::Ascii;
  std::vector<PlyElement> elements;
  const char* data = nullptr;  ///< first byte after the header
};

/// \throws ReadError with the line of the header that is wrong, or when there is no end_header.
PlyHeader readPlyHeader(const Source& source);

}  // namespace chartflood
