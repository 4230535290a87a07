#include "render/passes/flood_layer.h"

#include <algorithm>
#include <span>

#include <glm/vec3.hpp>

namespace chartflood {

namespace {
constexpr std::size_t kBlock = 2048;  // triangles that are uploaded together
}

FloodLayer::FloodLayer(std::shared_ptr<const Mesh> mesh) : mesh_(std::move(mesh)) { dry(0); }

void FloodLayer::follow(std::shared_ptr<const FloodRecord> record) {
  record_ = std::move(record);
  dry(record_ ? mesh_->triangleCount() : 0);
}

void FloodLayer::prepare() {
  if (orderAndChart_.empty()) dry(mesh_->triangleCount());
}

/// Nothing is taken of so many triangles, which get their room.
void FloodLayer::dry(std::size_t triangles) {
  taken_ = 0;
  orderAndChart_.assign(triangles, glm::uvec2(kNone));
  timeOf_.assign(triangles, 0.0f);
  longestTime_.clear();
  changedBlocks_.assign(mesh_->triangleCount() / kBlock + 1, false);
  seamEnds_.clear();
  seamOrder_.clear();
  uploadedSeams_ = seamCapacity_ = 0;
  order_.upload<glm::uvec2>(GL_RG32UI, orderAndChart_, GL_DYNAMIC_DRAW);
  time_.upload<float>(GL_R32F, timeOf_, GL_DYNAMIC_DRAW);
  seams_.upload<glm::vec4>(GL_RGBA32F, {}, GL_DYNAMIC_DRAW);
}

bool FloodLayer::update(std::size_t recorded, std::size_t most) {
  if (!record_ || recorded <= taken_) return true;
  const std::size_t size = taken_ + std::min(most, recorded - taken_);
  if (size == taken_) return true;
  for (std::size_t i = taken_; i < size; ++i) take(i);
  taken_ = size;
  uploadChanges();
  return size == recorded;
}

void FloodLayer::take(std::size_t order) {
  const Incorporation& entry = (*record_)[order];
  const Index begin = mesh_->triangleBegin(entry.face), end = mesh_->triangleBegin(entry.face + 1);
  for (Index triangle = begin; triangle < end; ++triangle) {
    orderAndChart_[triangle] = {static_cast<Index>(order), entry.chart};
    timeOf_[triangle] = entry.time;
    changedBlocks_[triangle / kBlock] = true;
  }
  if (entry.chart >= longestTime_.size()) longestTime_.resize(entry.chart + 1, 0.0f);
  longestTime_[entry.chart] = std::max(longestTime_[entry.chart], entry.time);
  addSeams(entry.face, entry.chart, order);
}

void FloodLayer::addSeams(Index face, Index chart, std::size_t order) {
  for (Index side = 3 * mesh_->triangleBegin(face); side < 3 * mesh_->triangleBegin(face + 1);
       ++side) {
    const Index opposite = mesh_->opposite()[side];
    if (opposite == kNone) continue;
    const Index other = orderAndChart_[opposite / 3].y;
    if (other == kNone || other == chart) continue;
    seamEnds_.emplace_back(glm::vec3(mesh_->positions()[mesh_->sideStart(side)]), 0.0f);
    seamEnds_.emplace_back(glm::vec3(mesh_->positions()[mesh_->sideEnd(side)]), 0.0f);
    seamOrder_.push_back(static_cast<Index>(order));
  }
}

void FloodLayer::uploadChanges() {
  for (std::size_t first = 0; first < changedBlocks_.size(); ++first) {
    if (!changedBlocks_[first]) continue;
    std::size_t last = first;
    while (last < changedBlocks_.size() && changedBlocks_[last]) changedBlocks_[last++] = false;
    const std::size_t begin = first * kBlock;
    const std::size_t count = std::min(last * kBlock, orderAndChart_.size()) - begin;
    order_.update(begin, std::span<const glm::uvec2>(orderAndChart_).subspan(begin, count));
    time_.update(begin, std::span<const float>(timeOf_).subspan(begin, count));
    first = last;
  }
  if (seamEnds_.size() > seamCapacity_) {
    // Room to grow, so that a long flood moves its seams only a few times.
    seamCapacity_ = 2 * seamEnds_.size();
    std::vector<glm::vec4> roomy = seamEnds_;
    roomy.resize(seamCapacity_);
    seams_.upload<glm::vec4>(GL_RGBA32F, roomy, GL_DYNAMIC_DRAW);
  } else if (seamEnds_.size() > uploadedSeams_) {
    seams_.update(uploadedSeams_, std::span<const glm::vec4>(seamEnds_).subspan(uploadedSeams_));
  }
  uploadedSeams_ = seamEnds_.size();
}

std::size_t FloodLayer::seamCount(std::size_t playhead) const {
  return static_cast<std::size_t>(std::lower_bound(seamOrder_.begin(), seamOrder_.end(), playhead) -
                                  seamOrder_.begin());
}

}  // namespace chartflood
