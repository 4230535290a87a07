#pragma once
/// The files that charts laid flat are taken home in, for window and command line alike.

#include <filesystem>
#include <span>
#include <string>

#include "core/session/session.h"

namespace chartflood {

/// Why these results cannot be exported yet; "" when they can.
std::string exportRefusal(const Results& results);

/// True when both names lead to one file, whatever their spelling: over the model itself an export
/// would drop what it does not carry, materials and animations among it.
bool isSameFile(const std::filesystem::path& target, const std::filesystem::path& input);

/// The mesh with texture coordinates and charts in the format of the file's extension.
/// \pre exportRefusal() is empty, here and below \throws UsageError for an unknown extension, Error
std::string exportedMesh(const Results& results, const std::filesystem::path& file);

/// Borders between charts and cuts as lines.
std::string exportedSeams(const Results& results);

/// The texture as SVG; charts in the colours of the palette with this id. `chartColors` are the
/// numbers that they begin with, see Renderer::setChartColors(); may be empty.
std::string exportedUvSvg(const Results& results, const std::string& palette,
                          std::span<const Index> chartColors);

}  // namespace chartflood
