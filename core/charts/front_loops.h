#pragma once
/// The fronts of a region that grows over a chart face by face.

#include <functional>
#include <vector>

#include "core/charts/chart_surface.h"
#include "core/model/handle_record.h"

namespace chartflood {

/// A chart whose boundary loops are closed by lids. *Side* s + sideCount() is the lid's side at
/// boundary side s; *face* numbers are those of a polygon's first triangle, then of the lids.
class LiddedSurface {
 public:
  explicit LiddedSurface(const ChartSurface& surface);

  Index sideCount() const { return static_cast<Index>(surface_.opposite.size()); }
  std::size_t faceCount() const { return faceSide_.size(); }
  bool isLid(Index face) const { return face >= surface_.triangleCount(); }
  bool onLid(Index side) const { return side >= sideCount(); }
  Index opposite(Index side) const {
    if (onLid(side)) return side - sideCount();
    const Index other = surface_.opposite[side];
    return other == kNone ? side + sideCount() : other;
  }
  /// The next side of the same face, counter-clockwise.
  Index next(Index side) const;
  Index faceOf(Index side) const {
    return onLid(side) ? lidOf_[side - sideCount()] : faceOfTriangle_[side / 3];
  }
  /// Sides of a face in order.
  std::vector<Index> sidesOf(Index face) const;
  /// Triangles of a face that is no lid, ascending.
  std::vector<Index> trianglesOf(Index face) const;
  /// Length of an edge, 0 on the boundary.
  double length(Index side) const;
  /// Mean of the centres of a face's triangles.
  glm::dvec3 centreOf(Index face) const;
  /// False when some polygon is no disk, so that its sides are not one chain.
  bool regular() const { return regular_; }

 private:
  const ChartSurface& surface_;
  std::vector<Index> faceOfTriangle_;
  std::vector<Index> lidOf_;     ///< of each side of the surface, kNone inside
  std::vector<Index> lidNext_;   ///< for the lid's side at each boundary side
  std::vector<Index> faceSide_;  ///< a side of each face, kNone for later triangles of polygons
  bool regular_ = true;
};

/// The front that passes a side, as it was when the faces with a step of at most `step` were taken:
/// sides in order, the region on their left.
/// \param stepOfFace kNone for faces not taken
std::vector<Index> traceFront(const LiddedSurface& surface, const std::vector<Index>& stepOfFace,
                              Index step, Index side);

/// Keeps the fronts as chains of sides. Taking a face glues it to the region edge by edge; each
/// edge joins two places of one front, which may split it, or two fronts, which finds a handle.
class FrontLoops {
 public:
  explicit FrontLoops(const LiddedSurface& surface);

  /// Adds a face; all but the first must touch the region along an edge. Calls `happened` for every
  /// split, close and touch, with the fronts' numbers filled in.
  void take(Index face, const std::function<void(const HandleEvent&)>& happened);

  /// Fronts changed by take() since the last call, ascending by number, `step` unset; closed ones
  /// are left out.
  std::vector<FrontState> changed();
  Index frontCount() const { return fronts_; }

 private:
  /// Sides of one front share a slot; of two parts of a front the shorter one changes slots.
  struct Slot {
    Index front = kNone;
    Index side = kNone;
    double length = 0;
  };

  bool onFront(Index side) const { return slotOf_[side] != kNone; }
  void link(Index a, Index b) {
    next_[a] = b;
    previous_[b] = a;
  }
  void attach(Index side, double faceLength);
  void glue(Index side, const std::function<void(const HandleEvent&)>& happened);
  void split(Index slot, Index a, Index b, const std::function<void(const HandleEvent&)>& happened);
  void join(Index a, Index b, Index from, Index to,
            const std::function<void(const HandleEvent&)>& happened);
  bool firstIsShorter(Index a, Index b) const;
  double moveTo(Index slot, Index side);

  const LiddedSurface& surface_;
  std::vector<Index> next_, previous_, slotOf_;
  std::vector<Slot> slots_;
  std::vector<Index> changed_;
  Index fronts_ = 0;
};

}  // namespace chartflood
