#pragma once
/// What each file of the collection of broken and unusual meshes must come to.

#include <cstddef>
#include <span>

namespace chartflood::test {

enum class Outcome { Refused, Loaded, Repaired };

struct BadMesh {
  const char* file;
  Outcome outcome;
  std::size_t triangles, vertices;  ///< after building; vertices that faces use
  const char* reason;               ///< why it differs from what the collection suggests, or ""
};

std::span<const BadMesh> badMeshes();

}  // namespace chartflood::test
