#pragma once
/// The parts of a GLB file: JSON and one buffer (glTF 2.0 specification, section 4.4).

#include <cstdint>
#include <string_view>

#include "core/io/text/source.h"

namespace chartflood {

struct GlbChunks {
  std::uint32_t version = 2;
  std::string_view json;    ///< empty for other versions than 2
  std::string_view binary;  ///< empty when the file has none
};

/// True for content that begins as GLB files do.
bool isGlb(std::string_view bytes);

/// Takes the file apart; nothing is copied. \throws ReadError when a part reaches beyond the file
GlbChunks readGlbChunks(const Source& source);

}  // namespace chartflood
