#include "core/segment/fast/node_flood.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/base/parallel.h"

namespace chartflood {

namespace {
constexpr std::size_t kNodeBurst = 4096;     // faces between two looks at the cancel flag
constexpr std::size_t kNodeBlock = 1 << 16;  // faces

/// Clusters lie so unevenly that the first way to one is often not the shortest.
OfferRule ruleFor(const FloodGraph& graph) {
  return graph.packed() ? OfferRule::FirstIncidence : OfferRule::ShortestTimes;
}
}  // namespace

NodeFlood::NodeFlood(const Mesh& mesh, const NodeGraph& graph, std::size_t charts)
    : mesh_(mesh), graph_(graph), flood_(makeFlood(graph.flood, charts, ruleFor(graph.flood))),
      nodeLog_(std::make_shared<FloodRecord>(graph.nodeCount())) {}

void NodeFlood::start(std::span<const Index> seeds, std::span<const double> offsets, bool lookahead,
                      std::shared_ptr<FloodRecord> record) {
  nodeLog_->rewind();
  record_ = std::move(record);
  taken_ = nodesOut_ = outOfNext_ = 0;
  flood_->start(seeds, offsets, lookahead, nodeLog_);
}

std::size_t NodeFlood::take(std::size_t count, Progress* progress) {
  const std::size_t faces = graph_.nodeOfFace.size(), before = taken_;
  if (!record_ && count >= faces) {
    flood_->advance(count, progress);
    if (flood_->finished()) taken_ = faces;
    return taken_ - before;
  }
  if (!faces_) faces_ = std::make_unique<NodeFaces>(mesh_, graph_.nodeOfFace, graph_.nodeCount());
  while (taken_ - before < count && !finished()) {
    const std::size_t burst = std::min(count - (taken_ - before), kNodeBurst);
    for (std::size_t left = burst; left > 0 && !finished();) {
      if (nodesOut_ == nodeLog_->size()) flood_->advance(1, nullptr);
      left -= handOut(left);
    }
    if (record_) record_->publish();
    if (progress == nullptr) continue;
    progress->setFraction(static_cast<float>(taken_) / static_cast<float>(faces));
    if (progress->cancelled()) break;
  }
  return taken_ - before;
}

/// Faces of the next node in the log, up to `count`.
std::size_t NodeFlood::handOut(std::size_t count) {
  const Incorporation next = (*nodeLog_)[nodesOut_];
  const auto all = faces_->of(next.face);
  const std::size_t out = std::min(count, all.size() - outOfNext_);
  if (record_) {
    for (const Index face : all.subspan(outOfNext_, out)) {
      record_->append(face, next.chart, next.time);
    }
  }
  taken_ += out;
  outOfNext_ += out;
  if (outOfNext_ == all.size()) {
    ++nodesOut_;
    outOfNext_ = 0;
  }
  return out;
}

std::vector<Index> NodeFlood::nodeLabels() const {
  std::vector<Index> label;
  flood_->copyLabels(label);
  return label;
}

std::vector<Index> NodeFlood::labels() const {
  if (finished()) return projectLabels(graph_, nodeLabels());
  std::vector<Index> label(graph_.nodeOfFace.size(), kNone);
  if (taken_ == 0) return label;
  for (std::size_t i = 0; i <= nodesOut_ && i < nodeLog_->size(); ++i) {
    const auto all = faces_->of((*nodeLog_)[i].face);
    const std::size_t out = i < nodesOut_ ? all.size() : outOfNext_;
    for (const Index face : all.first(out)) label[face] = (*nodeLog_)[i].chart;
  }
  return label;
}

std::vector<Index> projectLabels(const NodeGraph& graph, std::span<const Index> nodeLabel) {
  std::vector<Index> label(graph.nodeOfFace.size());
  parallelBlocks(label.size(), kNodeBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f) label[f] = nodeLabel[graph.nodeOfFace[f]];
  });
  return label;
}

}  // namespace chartflood
