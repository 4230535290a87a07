#pragma once
/// The samples' shapes, each made with edges of about a given length.

#include <cstddef>

#include "core/model/input_mesh.h"

namespace chartflood {

// Sizes are about 1 to 5 units; `edge` is the wanted length of the triangles' edges.

/// Unit sphere: a subdivided icosahedron or octahedron, whichever comes closer.
InputMesh makeSphere(double edge);
/// Torus with radii 1 and 0.4.
InputMesh makeTorus(double edge);
/// Smooth surface of genus 2.
InputMesh makeDoubleTorus(double edge);
/// How many triangles that one has, without the time that it takes to make.
std::size_t countDoubleTorus(double edge);
/// Closed cylinder, radius 0.6, height 2.
InputMesh makeCylinder(double edge);
/// The same without its ends.
InputMesh makeTube(double edge);
/// Cone without base, radius 1, height 2: Gauss area 2 pi (1 - sin(atan(r / h))).
InputMesh makeCone(double edge);
/// Cube with sides of length 1.
InputMesh makeCube(double edge);
/// Three cubes in the shape of an L.
InputMesh makeLBlock(double edge);
/// Flat square with sides of length 2.
InputMesh makePlane(double edge);
/// The square with hills and hollows.
InputMesh makeBumps(double edge);
/// Toy rocket with three swept fins, a nozzle with a lip, a nose with a ledge, and portholes.
InputMesh makeRocket(double edge);
/// Gear wheel with a bore, a hub with fillets and sixteen teeth.
InputMesh makeGear(double edge);
/// Band with four sharp edges that twists along a trefoil knot.
InputMesh makeKnot(double edge);

}  // namespace chartflood
