#include "core/segment/max_flow.h"

#include <algorithm>

namespace chartflood {

void MaxFlow::reset(std::size_t nodes) {
  begin_.clear();
  head_.clear();
  reverse_.clear();
  rest_.clear();
  terminal_.assign(nodes, 0);
  level_.resize(nodes);
  next_.resize(nodes);
}

Index MaxFlow::addArc(Index head, Amount capacity) {
  head_.push_back(head);
  rest_.push_back(capacity);
  reverse_.push_back(kNone);
  return static_cast<Index>(head_.size() - 1);
}

/// Breadth-first from the source over arcs with something left, to the level of the first sink.
/// True when a sink was reached.
bool MaxFlow::findLevels() {
  std::fill(level_.begin(), level_.end(), kNone);
  queue_.clear();
  for (Index v = 0; v < terminal_.size(); ++v) {
    if (terminal_[v] <= 0) continue;
    level_[v] = 0;
    queue_.push_back(v);
  }
  Index last = kNone;
  for (std::size_t i = 0; i < queue_.size(); ++i) {
    const Index v = queue_[i];
    if (level_[v] >= last) break;
    for (Index arc = begin_[v]; arc < begin_[v + 1]; ++arc) {
      const Index to = head_[arc];
      if (rest_[arc] <= 0 || level_[to] != kNone) continue;
      level_[to] = level_[v] + 1;
      if (terminal_[to] < 0) last = level_[to];
      queue_.push_back(to);
    }
  }
  return last != kNone;
}

/// Sends flow along paths of rising levels until the source's share or its ways are used up.
void MaxFlow::sendFrom(Index source) {
  path_.clear();
  Index v = source;
  while (terminal_[source] > 0) {
    if (terminal_[v] < 0) {
      Amount amount = std::min(terminal_[source], -terminal_[v]);
      for (const Index arc : path_) amount = std::min(amount, rest_[arc]);
      terminal_[source] -= amount;
      terminal_[v] += amount;
      std::size_t keep = path_.size();
      for (std::size_t i = path_.size(); i-- > 0;) {
        rest_[path_[i]] -= amount;
        rest_[reverse_[path_[i]]] += amount;
        if (rest_[path_[i]] == 0) keep = i;
      }
      if (keep < path_.size()) {
        v = head_[reverse_[path_[keep]]];
        path_.resize(keep);
      }
      continue;
    }
    bool moved = false;
    for (Index& arc = next_[v]; arc < begin_[v + 1]; ++arc) {
      if (rest_[arc] <= 0 || level_[head_[arc]] != level_[v] + 1) continue;
      path_.push_back(arc);
      v = head_[arc];
      moved = true;
      break;
    }
    if (moved) continue;
    if (path_.empty()) return;
    v = head_[reverse_[path_.back()]];
    path_.pop_back();
    ++next_[v];
  }
}

void MaxFlow::solve() {
  while (findLevels()) {
    for (Index v = 0; v < terminal_.size(); ++v) next_[v] = begin_[v];
    for (Index v = 0; v < terminal_.size(); ++v) {
      if (terminal_[v] > 0) sendFrom(v);
    }
  }
}

}  // namespace chartflood
