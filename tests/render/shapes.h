#pragma once
/// Small meshes for the renderer's tests.

#include <memory>

#include "core/model/mesh.h"

namespace chartflood::test {

/// A cube with each side cut into n x n squares of two triangles, n x n squares after another; the
/// sides come in the order -x, +x, -y, +y, -z, +z.
std::shared_ptr<const Mesh> cube(int n);
/// The same as quads: one face a square.
std::shared_ptr<const Mesh> quadCube(int n);
/// A cube blown up to a ball.
std::shared_ptr<const Mesh> ball(int n);
/// The same with all triangles facing inwards.
std::shared_ptr<const Mesh> ballInsideOut(int n);

/// A flat plate of columns x rows unit squares in the xy plane, seen from +z; two triangles a
/// square, row by row.
std::shared_ptr<const Mesh> plate(int columns, int rows);

}  // namespace chartflood::test
