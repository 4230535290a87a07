#pragma once
/// A chart's outline made ready for packing: points along it, and its distance field. Everything is
/// in *layout units*, see layoutArea, about the shape's own centre.

#include <vector>

#include <glm/vec2.hpp>

#include "core/pack/chart_outline.h"

namespace chartflood {

/// Fineness of shapes, layout units.
struct ShapeDetail {
  float spacing = 0;    ///< between points along the outline
  float tolerance = 0;  ///< how far the outline may lie from the lines between points
  float cell = 0;       ///< of the distance field
  float reach = 0;      ///< how far outside the shape its field must be known
};

/// Signed distance to an outline on a grid, negative inside.
struct DistanceField {
  float x0 = 0, y0 = 0;  ///< place of the first node
  float cell = 0, perCell = 0;
  int nx = 0, ny = 0;
  std::vector<float> value;  ///< row by row

  /// \pre 0 <= i < nx, 0 <= j < ny
  float at(int i, int j) const {
    return value[static_cast<std::size_t>(j) * static_cast<std::size_t>(nx) +
                 static_cast<std::size_t>(i)];
  }
};

struct PackShape {
  struct Point {
    float x, y;
    float length;  ///< of the outline that the point stands for
  };
  /// A run of points and a circle around them.
  struct Run {
    float x, y, radius;
    unsigned begin, end;
  };
  std::vector<Point> points;  ///< along the outline
  std::vector<Point> inside;  ///< a coarse grid of points, none near the outline
  std::vector<Run> runs;
  DistanceField field;
  float radius = 0;     ///< of a circle about the centre around all points
  float perimeter = 0;  ///< sum of the points' lengths
  float area = 0;
  float around = 0;        ///< length of the convex hull's border
  Point deepest{0, 0, 0};  ///< farthest from the outline; its `length` is that distance
  glm::dvec2 center{0};    ///< in the chart's plane
  bool boxy = false;       ///< fills most of its smallest box
  double upright = 0;      ///< turn that makes that box upright
  double square = 0;       ///< side of the smallest square around it
  double inSquare = 0;     ///< turn that makes that square upright
};

/// \param scale layout units per unit of the chart's plane
PackShape makeShape(const ChartOutline& outline, double scale, const ShapeDetail& detail);

/// Distances of the nodes of a grid to the segments; exact near them, and elsewhere off by less
/// than a cell. Cost: linear in the nodes and in the length of the segments.
/// \param field its grid is filled in, its values are not
void fillField(DistanceField& field, const std::vector<Segment2>& segments);

}  // namespace chartflood
