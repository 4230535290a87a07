#pragma once
/// Where the shapes of a layout touch or nearly touch, found once and then followed for some steps.

#include <span>
#include <utility>
#include <vector>

#include "core/pack/pack_layout.h"
#include "core/pack/pack_shape.h"

namespace chartflood {

/// Push on a shape, layout units.
struct ShapePush {
  double x = 0, y = 0, torque = 0;
};

/// The points of outlines that lie in, or within a small way (the skin) of, another shape or a
/// wall. Each is followed as a point against a straight line, the level line of the other shape's
/// field there, until its two shapes have moved as far as the skin; so a step costs some ten
/// operations a point, four points at a time, and few looks into fields. Reads the shapes, which
/// must live as long as the object does.
class Contacts {
 public:
  Contacts(std::span<const PackShape> shapes, const PackGaps& gaps);

  /// Forces of all contacts in the layout; points push with what they are deeper than the gaps
  /// allow. \param skin layout units; all contacts are looked for again when it is another than
  /// before
  void push(const PackLayout& layout, double skin);

  std::span<const ShapePush> pushes() const { return pushes_; }
  double energy() const { return energy_; }
  double sidePush() const { return sidePush_; }  ///< along the square's side
  double depth() const { return depth_; }        ///< of the deepest point, gaps counted
  /// Of each shape's deepest contact with a wall or a larger shape.
  std::span<const float> depths() const { return depths_; }

 private:
  struct Frame {
    float x, y, cos, sin;
  };
  /// Contacts of one shape's points with another's field or with the walls, and where both shapes
  /// were when they were found.
  struct Group {
    Index field, points;
    std::size_t begin;      ///< of the columns; there is room for all of the shape's points
    std::size_t count = 0;  ///< a multiple of four
  };
  struct Pair {
    Group first, second;  ///< each with the field that the other's points lie in
    Pose at[2];
  };
  struct Wall {
    Group group;
    Pose at;
    double side;
  };
  struct Columns {
    std::vector<float> x, y;    ///< of the point, about its shape's centre
    std::vector<float> length;  ///< of the outline that the point stands for
    std::vector<float> nx, ny,
        at;  ///< the line: distance = at + nx * x + ny * y, in the field's axes
    void set(std::size_t i, const PackShape::Point& p, float normalX, float normalY, float from);
    void resize(std::size_t count);
  };

  void setFrames(const PackLayout& layout);
  bool pairsHold(const PackLayout& layout) const;
  void findPairs(const PackLayout& layout);
  Group makeGroup(Index field, Index points);
  void findInField(Group& group);
  void findAtWalls(Group& group);
  void fill(Group& group, std::size_t end);
  void pushFromField(const Group& group);
  void pushFromWalls(const Group& group);
  double moved(Index shape, const Pose& from, const Pose& to) const;

  std::span<const PackShape> shapes_;
  PackGaps gaps_;
  std::vector<Frame> frames_;
  std::vector<Pair> pairs_;
  std::vector<Wall> walls_;
  std::vector<Pose> pairedAt_;
  double pairedSide_ = 0, skin_ = -1;
  Columns columns_;
  std::size_t columnCount_ = 0;
  std::vector<ShapePush> pushes_;
  std::vector<float> depths_;
  float gap_ = 0, wall_ = 0, depth_ = 0;
  double energy_ = 0, sidePush_ = 0;
};

}  // namespace chartflood
