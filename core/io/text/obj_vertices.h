#pragma once
/// The `v` lines that OBJ files share.

#include <span>
#include <string>

#include <glm/vec3.hpp>

namespace chartflood {

/// Appends one line a position, each number the shortest decimal that reads as the same double.
void appendObjVertices(std::string& text, std::span<const glm::dvec3> positions);

}  // namespace chartflood
