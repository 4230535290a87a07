#include "core/segment/borders/max_flow.h"

#include <algorithm>
#include <limits>

namespace chartflood {

namespace {

constexpr Index kRoot = kNone - 1, kOrphan = kNone - 2;
constexpr unsigned kFar = std::numeric_limits<unsigned>::max();

}  // namespace

void MaxFlow::reset(std::size_t nodes) {
  arcs_.clear();
  nodes_.assign(nodes + 1, {});
  begun_ = 0;
}

Index MaxFlow::addArc(Index head, Amount capacity) {
  arcs_.push_back({capacity, head, kNone});
  return static_cast<Index>(arcs_.size() - 1);
}

/// Every node with something left at a terminal is the root of a tree.
void MaxFlow::plantTrees() {
  active_.clear();
  nextActive_ = 0;
  time_ = 0;
  for (Index v = 0; v + 1 < nodes_.size(); ++v) {
    Node& node = nodes_[v];
    node.tree = node.terminal > 0 ? kSource : node.terminal < 0 ? kSink : kFree;
    node.distance = 1;
    node.stamp = 0;
    node.active = false;
    node.parent = kRoot;
    if (node.tree != kFree) activate(v);
  }
}

void MaxFlow::activate(Index node) {
  if (nodes_[node].active) return;
  nodes_[node].active = true;
  active_.push_back(node);
}

/// The node whose turn it is to grow, kNone when none is left.
Index MaxFlow::nextActive() {
  while (nextActive_ < active_.size()) {
    const Index node = active_[nextActive_++];
    if (nextActive_ > 4096 && 2 * nextActive_ > active_.size()) {
      active_.erase(active_.begin(), active_.begin() + static_cast<std::ptrdiff_t>(nextActive_));
      nextActive_ = 0;
    }
    nodes_[node].active = false;
    if (nodes_[node].tree != kFree) return node;
  }
  return kNone;
}

/// Takes free neighbours into the node's tree. \return the arc from the source's tree to the sink's
/// that it found, kNone when all arcs were looked at
Index MaxFlow::grow(Index index) {
  const Node& node = nodes_[index];
  for (Index a = node.begin; a < nodes_[index + 1].begin; ++a) {
    const Arc& arc = arcs_[a];
    if (restAlong(arc, node.tree) <= 0) continue;
    Node& other = nodes_[arc.head];
    if (other.tree == kFree) {
      other.tree = node.tree;
      activate(arc.head);
    } else if (other.tree != node.tree) {
      return node.tree == kSource ? a : arc.reverse;
    } else if (other.stamp > node.stamp || other.distance <= node.distance + 1) {
      continue;  // no shorter way to the root
    }
    other.parent = arc.reverse;
    other.stamp = node.stamp;
    other.distance = node.distance + 1;
  }
  return kNone;
}

/// Sends what fits from root to root over the bridge; nodes that lose their parent become orphans.
void MaxFlow::augment(Index bridge) {
  Arc& middle = arcs_[bridge];
  const Index from = arcs_[middle.reverse].head, to = middle.head;
  Amount amount = middle.rest;
  Index v = from;
  while (nodes_[v].parent != kRoot) {
    const Arc& up = arcs_[nodes_[v].parent];
    amount = std::min(amount, arcs_[up.reverse].rest);
    v = up.head;
  }
  amount = std::min(amount, nodes_[v].terminal);
  v = to;
  while (nodes_[v].parent != kRoot) {
    const Arc& up = arcs_[nodes_[v].parent];
    amount = std::min(amount, up.rest);
    v = up.head;
  }
  amount = std::min(amount, -nodes_[v].terminal);

  const auto orphan = [this](Index node) {
    nodes_[node].parent = kOrphan;
    orphans_.push_back(node);
  };
  middle.rest -= amount;
  arcs_[middle.reverse].rest += amount;
  for (v = from; nodes_[v].parent != kRoot;) {
    Arc& up = arcs_[nodes_[v].parent];
    up.rest += amount;
    if ((arcs_[up.reverse].rest -= amount) == 0) orphan(v);
    v = up.head;
  }
  if ((nodes_[v].terminal -= amount) == 0) orphan(v);
  for (v = to; nodes_[v].parent != kRoot;) {
    Arc& up = arcs_[nodes_[v].parent];
    arcs_[up.reverse].rest += amount;
    if ((up.rest -= amount) == 0) orphan(v);
    v = up.head;
  }
  if ((nodes_[v].terminal += amount) == 0) orphan(v);
}

/// Steps from a node up to a root, kFar when its tree hangs on an orphan. Stamps what it passed.
unsigned MaxFlow::distanceToRoot(Index index) {
  unsigned distance = 0;
  for (Index v = index;; v = arcs_[nodes_[v].parent].head) {
    Node& node = nodes_[v];
    if (node.stamp == time_) {
      distance += node.distance;
      break;
    }
    if (node.parent == kOrphan) return kFar;
    ++distance;
    if (node.parent == kRoot) {
      node.stamp = time_;
      node.distance = 1;
      break;
    }
  }
  unsigned left = distance;
  for (Index v = index; nodes_[v].stamp != time_; v = arcs_[nodes_[v].parent].head) {
    nodes_[v].stamp = time_;
    nodes_[v].distance = left--;
  }
  return distance;
}

/// Hangs an orphan on the neighbour in its tree that is nearest to a root, or sets it free.
void MaxFlow::findParent(Index index) {
  Node& node = nodes_[index];
  const Index end = nodes_[index + 1].begin;
  const auto reaches = [&](const Arc& arc) { return restAlong(arcs_[arc.reverse], node.tree) > 0; };
  Index best = kNone;
  unsigned nearest = kFar;
  for (Index a = node.begin; a < end; ++a) {
    const Arc& arc = arcs_[a];
    if (nodes_[arc.head].tree != node.tree || !reaches(arc)) continue;
    const unsigned distance = distanceToRoot(arc.head);
    if (distance < nearest) nearest = distance, best = a;
  }
  if (best != kNone) {
    node.parent = best;
    node.stamp = time_;
    node.distance = nearest + 1;
    return;
  }
  for (Index a = node.begin; a < end; ++a) {
    const Arc& arc = arcs_[a];
    Node& other = nodes_[arc.head];
    if (other.tree != node.tree) continue;
    if (reaches(arc)) activate(arc.head);
    if (other.parent == arc.reverse) {
      other.parent = kOrphan;
      orphans_.push_back(arc.head);
    }
  }
  node.tree = kFree;
}

void MaxFlow::adopt() {
  for (std::size_t i = 0; i < orphans_.size(); ++i) findParent(orphans_[i]);
  orphans_.clear();
}

void MaxFlow::solve() {
  plantTrees();
  for (Index node = nextActive(); node != kNone;) {
    const Index bridge = grow(node);
    ++time_;
    if (bridge == kNone) {
      node = nextActive();
      continue;
    }
    augment(bridge);
    adopt();
    if (nodes_[node].tree == kFree) node = nextActive();  // else it may have more to find
  }
}

}  // namespace chartflood
