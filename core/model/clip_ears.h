#pragma once
/// Ear clipping for polygons in the plane that may touch themselves.

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>

#include "core/base/index.h"

namespace chartflood {

/// One polygon; made for a single run.
class EarClipper {
 public:
  /// \param points corners, counter-clockwise where the polygon has an inside
  /// \param vertex of each corner; corners of one vertex never share a triangle
  EarClipper(std::vector<glm::dvec2> points, std::vector<Index> vertex);

  struct Result {
    std::vector<std::array<Index, 3>> triangles;     ///< of corners
    std::vector<std::pair<Index, Index>> diagonals;  ///< sides 3 t + i that are one diagonal
  };
  Result run();

 private:
  /// What a corner must be to be clipped; the next one is tried where no corner is.
  enum class Rule { Ear, FlatEar, Convex, Any, Spike };

  double area(Index a, Index b, Index c) const;
  double reach(Index corner) const;
  bool isReflex(Index corner) const;
  bool mayClip(Index corner, Rule rule) const;
  bool isBlocked(Index corner) const;
  bool enters(Index corner, const std::array<Index, 3>& ear) const;
  void buildGrid();
  void push(Index corner);
  bool clipByRule(Rule rule);
  void clip(Index corner);
  void dropSpike(Index corner);
  void own(Index side, Index edge);

  std::vector<glm::dvec2> point_;
  std::vector<Index> vertex_, previous_, next_;
  std::vector<bool> gone_;
  std::vector<Index> owner_;  ///< side of the triangle behind the edge that starts at a corner
  std::vector<std::pair<double, Index>> heap_;  ///< shortest diagonal on top; old entries stay
  std::vector<Index> waiting_;                  ///< corners that were no ears when they were tried
  std::size_t left_;
  std::size_t cells_ = 1;                  ///< along each axis
  std::vector<Index> cellStart_, inCell_;  ///< corners that were reflex at the start
  Result result_;
};

}  // namespace chartflood
