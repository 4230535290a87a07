#pragma once
/// Developable bodies of thin triangles, made to order and turned out of the axes.

#include <memory>

#include "core/model/mesh.h"

namespace chartflood::test {

/// `rings` rows of `sides` rectangles around an axis, each two triangles; from radius 1/2 to
/// `tip` / 2 over `length`. A tip of 0 is one vertex.
struct ThinBody {
  Index sides = 3;
  double length = 1;
  double tip = 1;
  Index rings = 1;
  bool closed = false;  ///< with a polygon at each end
};
std::shared_ptr<const Mesh> thinBody(const ThinBody& body);

/// A rectangle of `length` x 1, cut across into `columns`, each two triangles.
std::shared_ptr<const Mesh> thinStrip(Index columns, double length);

/// A square with one side of `points` that bulges by `sag`, triangles from one of its corners.
std::shared_ptr<const Mesh> thinFan(Index points, double sag);

}  // namespace chartflood::test
