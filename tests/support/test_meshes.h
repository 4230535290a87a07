#pragma once
/// Meshes for tests: built from lists, made by the program, or read from the folder of real meshes.

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "core/model/mesh.h"

namespace chartflood::test {

using Polygons = std::vector<std::vector<Index>>;

/// Mesh of the given vertices and faces.
std::shared_ptr<const Mesh> meshOf(std::vector<glm::dvec3> positions, const Polygons& faces);

/// A sample of the program with about so many triangles.
std::shared_ptr<const Mesh> sampleMesh(const std::string& id, std::size_t triangles);

/// A mesh of the folder of real meshes; null when the folder is absent.
std::shared_ptr<const Mesh> realMesh(const std::string& file);

/// Unit cube of six quads.
std::shared_ptr<const Mesh> quadCube();

/// Flat grid of n x n quads, each two triangles when `triangles`.
std::shared_ptr<const Mesh> grid(Index n, bool triangles);

/// Input of a mesh, to change and build again.
InputMesh copyInput(const Mesh& mesh);
std::shared_ptr<const Mesh> rebuild(InputMesh input);

/// How often the mesh reports a repair, 0 when it does not.
std::size_t repairCount(const Mesh& mesh, std::string_view what);

/// The same faces in another order, each beginning with another corner; by a generator's seed.
InputMesh shuffledFaces(const InputMesh& input, std::uint32_t seed);

}  // namespace chartflood::test
