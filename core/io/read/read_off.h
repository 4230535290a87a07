#pragma once
/// Geomview's Object File Format, as text.

#include "core/io/text/source.h"
#include "core/model/input_mesh.h"

namespace chartflood {

/// Reads OFF with any of the prefixes ST, C, N, 4 (the fourth coordinate divides the others). What
/// a row holds behind its position or corners (normals, colours) is left aside.
/// \throws ReadError with the line; for binary OFF and nOFF (other dimensions).
InputMesh readOff(const Source& source);

/// Whether a text begins like an OFF file.
bool looksLikeOff(std::string_view bytes);

}  // namespace chartflood
