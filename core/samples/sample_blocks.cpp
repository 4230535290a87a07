/// Samples made of squares: plane, bumps, cube and the L of three cubes.

#include "core/samples/sample_blocks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

#include <glm/exponential.hpp>
#include <glm/geometric.hpp>

#include "core/samples/sample_shapes.h"
#include "core/samples/sample_surface.h"

namespace chartflood {

namespace {

using Cell = std::array<int, 3>;

/// The surface of a union of unit cubes. Each square is filled with rows of triangles; corners and
/// edges are shared by their place in half steps of the finest grid.
class BlockSurface {
 public:
  BlockSurface(std::vector<Cell> cells, double edge)
      : cells_(std::move(cells)), surface_(edge), steps_(static_cast<int>(surface_.edgesFor(1))) {}

  InputMesh make() {
    for (const Cell& cell : cells_) {
      for (int axis = 0; axis < 3; ++axis) {
        for (const int side : {0, 1}) {
          Cell neighbour = cell;
          neighbour[static_cast<std::size_t>(axis)] += side == 1 ? 1 : -1;
          if (std::find(cells_.begin(), cells_.end(), neighbour) == cells_.end()) {
            addSquare(cell, axis, side);
          }
        }
      }
    }
    return surface_.take();
  }

 private:
  void addSquare(const Cell& cell, int axis, int side) {
    // (axis, right, up) is right-handed for the far side and left-handed for the near one.
    const int right = (axis + (side == 1 ? 1 : 2)) % 3, up = (axis + (side == 1 ? 2 : 1)) % 3;
    Cell corner;
    for (std::size_t k = 0; k < 3; ++k) corner[k] = 2 * steps_ * cell[k];
    corner[static_cast<std::size_t>(axis)] += 2 * steps_ * side;
    Row last;
    for (int y = 0; y <= steps_; ++y) {
      const bool staggered = y % 2 == 1 && y < steps_;
      Row row;
      for (int x = 0; x <= 2 * steps_; x += x == 0 && staggered ? 1 : 2) {
        Cell place = corner;
        // The last step of a staggered row is a half one.
        place[static_cast<std::size_t>(right)] += x;
        place[static_cast<std::size_t>(up)] += 2 * y;
        row.push_back(vertex(place));
        if (staggered && x == 2 * steps_ - 1) {
          place[static_cast<std::size_t>(right)] += 1;
          row.push_back(vertex(place));
        }
      }
      if (y > 0) surface_.zip(last, row);
      last = std::move(row);
    }
  }

  Index vertex(const Cell& place) {
    const auto found = numbers_.find(place);
    if (found != numbers_.end()) return found->second;
    const double unit = 0.5 / steps_;
    const Index number = surface_.add({place[0] * unit, place[1] * unit, place[2] * unit});
    numbers_.emplace(place, number);
    return number;
  }

  std::vector<Cell> cells_;
  SampleSurface surface_;
  int steps_;
  std::map<Cell, Index> numbers_;
};

/// The square [-1, 1] x [-1, 1] with a height over each point.
template <class Height>
InputMesh makeSheet(double edge, Height&& height) {
  SampleSurface surface(edge);
  const std::size_t columns = surface.edgesFor(2), rows = surface.rowsFor(2);
  const auto point = [&](double x, double y) { return glm::dvec3(x, y, height(x, y)); };
  Row last;
  for (std::size_t i = 0; i <= rows; ++i) {
    const double y = -1 + 2 * static_cast<double>(i) / static_cast<double>(rows);
    const Index left = surface.add(point(-1, y)), right = surface.add(point(1, y));
    Row row = surface.between(left, right, columns, i % 2 == 1,
                              [&](double t) { return point(-1 + 2 * t, y); });
    if (i > 0) surface.zip(last, row);
    last = std::move(row);
  }
  return surface.take();
}

}  // namespace

InputMesh makeBlocks(const std::vector<std::array<int, 3>>& cells, double edge) {
  return BlockSurface(cells, edge).make();
}

InputMesh makeCube(double edge) { return makeBlocks({{0, 0, 0}}, edge); }

InputMesh makeLBlock(double edge) { return makeBlocks({{0, 0, 0}, {1, 0, 0}, {0, 0, 1}}, edge); }

InputMesh makePlane(double edge) {
  return makeSheet(edge, [](double, double) { return 0.0; });
}

InputMesh makeBumps(double edge) {
  struct Hill {
    double x, y, height, width;
  };
  constexpr std::array<Hill, 6> kHills = {{{-0.45, -0.4, 0.5, 0.26},
                                           {0.5, 0.45, 0.38, 0.3},
                                           {0.4, -0.5, -0.35, 0.24},
                                           {-0.5, 0.5, 0.3, 0.16},
                                           {0.0, 0.05, -0.22, 0.18},
                                           {-0.05, 0.7, 0.2, 0.13}}};
  return makeSheet(edge, [&](double x, double y) {
    double z = 0;
    for (const Hill& hill : kHills) {
      const double dx = x - hill.x, dy = y - hill.y;
      z += hill.height * std::exp(-(dx * dx + dy * dy) / (2 * hill.width * hill.width));
    }
    return z;
  });
}

}  // namespace chartflood
