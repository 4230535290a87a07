#pragma once
/// Painted edges as a text file.

#include <filesystem>
#include <string>

#include "core/model/edge_hints.h"
#include "core/model/mesh.h"

namespace chartflood {

/// Reads lines "cut A B" and "never A B", A and B the numbers of an edge's vertices in the mesh's
/// file, the first vertex 0; # begins a comment. A later line wins over an earlier one.
/// \throws ReadError that names the line: not of that form, or no edge of the mesh
EdgeHints readHints(const std::filesystem::path& file, const Mesh& mesh);

/// The text that readHints() reads back.
std::string hintsText(const EdgeHints& hints);

}  // namespace chartflood
