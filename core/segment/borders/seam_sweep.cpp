#include "core/segment/borders/seam_sweep.h"

#include <algorithm>

#include "core/base/parallel.h"
#include "core/base/parallel_pairs.h"

namespace chartflood {

namespace {

/// Sorts the nodes of two charts into theirs by their labels.
void shareNodes(SeamState& state, Index a, Index b, std::vector<Index>& merged) {
  std::vector<Index>& nodesA = state.charts[a].nodes;
  std::vector<Index>& nodesB = state.charts[b].nodes;
  merged.resize(nodesA.size() + nodesB.size());
  std::merge(nodesA.begin(), nodesA.end(), nodesB.begin(), nodesB.end(), merged.begin());
  nodesA.clear();
  nodesB.clear();
  for (const Index node : merged) (state.label[node] == a ? nodesA : nodesB).push_back(node);
}

/// The neighbouring pairs of which one chart changed, ascending.
void listPairs(const SeamState& state, std::span<const std::uint8_t> changed,
               std::vector<std::pair<Index, Index>>& pairs) {
  const SeamLevel& level = *state.level;
  pairs.clear();
  for (Index i = 0; i < level.nodeCount(); ++i) {
    const Index a = state.label[i];
    for (Index arc = level.arcBegin[i]; arc < level.arcBegin[i + 1]; ++arc) {
      const Index b = state.label[level.arcHead[arc]];
      if (a < b && (changed[a] || changed[b])) pairs.emplace_back(a, b);
    }
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
}

}  // namespace

void SeamSweep::begin(const SeamState& state, const SeamBalance& balance,
                      std::span<const std::uint8_t> changed) {
  balance_ = balance;
  values_.clear();
  for (const SeamChart& chart : state.charts) values_.push_back(chart.value);
  listPairs(state, changed, waiting_);
  pairs_.clear();
  std::vector<std::uint8_t> used(state.charts.size());
  while (!waiting_.empty()) {
    used.assign(used.size(), 0);
    std::size_t kept = 0;
    for (const auto& [a, b] : waiting_) {
      if (used[a] || used[b]) {
        waiting_[kept++] = {a, b};
      } else {
        used[a] = used[b] = 1;
        pairs_.emplace_back(a, b);
      }
    }
    waiting_.resize(kept);
  }
  done_.assign(pairs_.size(), 0);
  steps_.assign(pairs_.size(), {});
}

bool SeamSweep::run(SeamState& state, const Progress& progress) {
  std::vector<std::size_t> left;
  std::vector<std::pair<Index, Index>> pairs;
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    if (done_[i]) continue;
    left.push_back(i);
    pairs.push_back(pairs_[i]);
  }
  workers_.resize(threadCount());
  parallelPairs(pairs, state.charts.size(), [&](std::size_t i, std::size_t worker) {
    return cutPair(state, workers_[worker], left[i], progress);
  });
  return std::find(done_.begin(), done_.end(), 0) == done_.end();
}

/// As at the beginning of the pass, but for the two charts: what others did meanwhile depends on
/// the threads.
SeamBalance SeamSweep::balanceFor(const SeamState& state, Index a, Index b) const {
  SeamBalance balance = balance_;
  for (const Index chart : {a, b}) {
    balance.remove(values_[chart]);
    balance.add(state.charts[chart].value);
  }
  return balance;
}

bool SeamSweep::cutPair(SeamState& state, Worker& worker, std::size_t pair,
                        const Progress& progress) {
  if (progress.cancelled()) return false;
  const auto [a, b] = pairs_[pair];
  const bool better = worker.cut.run(state, balanceFor(state, a, b), a, b, progress);
  if (progress.cancelled()) return false;
  done_[pair] = 1;
  Step& step = steps_[pair];
  step.a = a;
  step.b = b;
  if (!better) return true;
  step.toB.assign(worker.cut.toB().begin(), worker.cut.toB().end());
  step.toA.assign(worker.cut.toA().begin(), worker.cut.toA().end());
  for (const Index node : step.toB) setLabel(state, node, b);
  for (const Index node : step.toA) setLabel(state, node, a);
  static_cast<SeamSums&>(state.charts[a]) = worker.cut.chartA();
  static_cast<SeamSums&>(state.charts[b]) = worker.cut.chartB();
  shareNodes(state, a, b, worker.merged);
  return true;
}

}  // namespace chartflood
