#pragma once
/// The chart of each face as plain text, for other programs.

#include <filesystem>
#include <span>
#include <string>

#include "core/base/index.h"
#include "core/model/mesh.h"

namespace chartflood {

/// One line per face of the input file, in its order: the chart's number, or -1 for a face that was
/// dropped on reading or is still free.
/// \param label chart of each face of the mesh, kNone while free; one entry a face
std::string labelsText(const Mesh& mesh, std::span<const Index> label);

/// Writes labelsText() to a file. \throws WriteError; the old file is then as it was.
void writeLabels(const std::filesystem::path& file, const Mesh& mesh, std::span<const Index> label);

}  // namespace chartflood
