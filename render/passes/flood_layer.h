#pragma once
/// The growing flood record on the graphics card: order, chart and time of each triangle, and the
/// seams in the order in which they appear. A playhead is then only a number.

#include <cstddef>
#include <memory>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "core/model/flood_record.h"
#include "core/model/mesh.h"
#include "render/gl/objects.h"

namespace chartflood {

class FloodLayer {
 public:
  /// Starts with a dry mesh.
  explicit FloodLayer(std::shared_ptr<const Mesh> mesh);

  /// Follows this record from its first entry, of which nothing is taken in yet; null dries
  /// everything.
  void follow(std::shared_ptr<const FloodRecord> record);
  /// Makes the arrays that bindOrder() and bindTime() show, which a dry mesh is without.
  void prepare();
  /// Uploads what is new of the record's first `recorded` entries, at most so many of them. Cost:
  /// the new part alone. \returns false when entries are left
  bool update(std::size_t recorded, std::size_t most);

  /// Number of faces taken so far.
  std::size_t size() const { return taken_; }
  /// Number of charts that took a face.
  std::size_t chartCount() const { return longestTime_.size(); }
  /// Largest local time of each chart.
  const std::vector<float>& longestTime() const { return longestTime_; }
  /// The (order, chart) of a triangle, kNone while dry.
  glm::uvec2 taken(Index triangle) const {
    return orderAndChart_.empty() ? glm::uvec2(kNone) : orderAndChart_[triangle];
  }

  void bindOrder(GLuint unit) const { order_.bind(unit); }
  void bindTime(GLuint unit) const { time_.bind(unit); }
  void bindSeams(GLuint unit) const { seams_.bind(unit); }
  /// How many of the seams exist once `playhead` faces are taken.
  std::size_t seamCount(std::size_t playhead) const;

 private:
  void dry(std::size_t triangles);
  void take(std::size_t order);
  void addSeams(Index face, Index chart, std::size_t order);
  void uploadChanges();

  std::shared_ptr<const Mesh> mesh_;
  std::shared_ptr<const FloodRecord> record_;
  std::size_t taken_ = 0;
  std::vector<glm::uvec2> orderAndChart_;
  std::vector<float> timeOf_;
  std::vector<float> longestTime_;
  std::vector<bool> changedBlocks_;
  std::vector<glm::vec4> seamEnds_;  // two a seam
  std::vector<Index> seamOrder_;     // the face that made each seam, ascending
  std::size_t uploadedSeams_ = 0, seamCapacity_ = 0;
  gl::TextureBuffer order_, time_, seams_;
};

}  // namespace chartflood
