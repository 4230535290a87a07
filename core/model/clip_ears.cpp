#include "core/model/clip_ears.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace chartflood {

namespace {

/// Areas below count as none: points are moved into the unit square first.
constexpr double kFlat = 1e-13;

}  // namespace

EarClipper::EarClipper(std::vector<glm::dvec2> points, std::vector<Index> vertex)
    : point_(std::move(points)), vertex_(std::move(vertex)), gone_(point_.size(), false),
      owner_(point_.size(), kNone), left_(point_.size()) {
  glm::dvec2 low(std::numeric_limits<double>::infinity()), high(-low);
  for (const glm::dvec2& p : point_) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  const double extent = std::max(high.x - low.x, high.y - low.y);
  for (glm::dvec2& p : point_) p = extent > 0 ? (p - low) / extent : glm::dvec2(0);
  const Index count = static_cast<Index>(point_.size());
  for (Index i = 0; i < count; ++i) {
    previous_.push_back(i == 0 ? count - 1 : i - 1);
    next_.push_back(i + 1 == count ? 0 : i + 1);
  }
  buildGrid();
}

double EarClipper::area(Index a, Index b, Index c) const {
  const glm::dvec2 ab = point_[b] - point_[a], ac = point_[c] - point_[a];
  return ab.x * ac.y - ab.y * ac.x;
}

bool EarClipper::isReflex(Index corner) const {
  return area(previous_[corner], corner, next_[corner]) <= kFlat;
}

/// Only corners that are reflex or flat can lie in an ear, and no other becomes so.
void EarClipper::buildGrid() {
  std::vector<Index> reflex;
  for (Index i = 0; i < point_.size(); ++i) {
    if (isReflex(i)) reflex.push_back(i);
  }
  cells_ = std::max<std::size_t>(1, static_cast<std::size_t>(std::sqrt(reflex.size())));
  const auto cellOf = [&](Index i) {
    const auto along = [&](double x) {
      return std::min(cells_ - 1, static_cast<std::size_t>(x * static_cast<double>(cells_)));
    };
    return along(point_[i].y) * cells_ + along(point_[i].x);
  };
  cellStart_.assign(cells_ * cells_ + 1, 0);
  for (const Index i : reflex) ++cellStart_[cellOf(i) + 1];
  for (std::size_t c = 0; c < cells_ * cells_; ++c) cellStart_[c + 1] += cellStart_[c];
  inCell_.resize(reflex.size());
  std::vector<Index> at(cellStart_.begin(), cellStart_.end() - 1);
  for (const Index i : reflex) inCell_[at[cellOf(i)]++] = i;
}

/// Whether the outline at a corner runs into the inside of an ear: the corner is inside, or on its
/// rim with a neighbour on the inner side. Twins of the ear's own corners count like others.
bool EarClipper::enters(Index corner, const std::array<Index, 3>& ear) const {
  bool inside = true, toPrevious = true, toNext = true;
  for (std::size_t i = 0; i < 3; ++i) {
    const Index a = ear[i], b = ear[(i + 1) % 3];
    const double here = area(a, b, corner);
    if (here < -kFlat) return false;
    if (here > kFlat) continue;
    inside = false;
    toPrevious = toPrevious && area(a, b, previous_[corner]) > kFlat;
    toNext = toNext && area(a, b, next_[corner]) > kFlat;
  }
  return inside || toPrevious || toNext;
}

bool EarClipper::isBlocked(Index corner) const {
  const std::array<Index, 3> ear = {previous_[corner], corner, next_[corner]};
  glm::dvec2 low = point_[corner], high = low;
  for (const Index i : ear) {
    low = glm::min(low, point_[i]);
    high = glm::max(high, point_[i]);
  }
  const auto along = [&](double x) {
    return std::min(cells_ - 1, static_cast<std::size_t>(x * static_cast<double>(cells_)));
  };
  for (std::size_t y = along(low.y); y <= along(high.y); ++y) {
    const std::size_t first = y * cells_ + along(low.x), last = y * cells_ + along(high.x);
    for (Index at = cellStart_[first]; at < cellStart_[last + 1]; ++at) {
      const Index q = inCell_[at];
      if (gone_[q] || q == ear[0] || q == ear[1] || q == ear[2] || !isReflex(q)) continue;
      if (enters(q, ear)) return true;
    }
  }
  return false;
}

bool EarClipper::mayClip(Index corner, Rule rule) const {
  const Index a = previous_[corner], c = next_[corner];
  const bool spike = vertex_[a] == vertex_[c];
  if (rule == Rule::Spike) return spike;
  if (spike || vertex_[a] == vertex_[corner] || vertex_[corner] == vertex_[c]) return false;
  const double twice = area(a, corner, c);
  switch (rule) {
  case Rule::Ear:
    return twice > kFlat && !isBlocked(corner);
  case Rule::FlatEar:
    return twice >= -kFlat && !isBlocked(corner);
  case Rule::Convex:
    return twice > kFlat;
  default:
    return true;
  }
}

/// Squared length of the diagonal that cuts a corner off.
double EarClipper::reach(Index corner) const {
  const glm::dvec2 diagonal = point_[next_[corner]] - point_[previous_[corner]];
  return glm::dot(diagonal, diagonal);
}

void EarClipper::push(Index corner) {
  heap_.emplace_back(reach(corner), corner);
  std::push_heap(heap_.begin(), heap_.end(), std::greater<>());
}

/// A triangle's side lies on the edge that starts at a corner of the outline.
void EarClipper::own(Index side, Index edge) {
  if (owner_[edge] != kNone) result_.diagonals.emplace_back(owner_[edge], side);
}

void EarClipper::clip(Index corner) {
  const Index a = previous_[corner], c = next_[corner];
  const Index side = static_cast<Index>(3 * result_.triangles.size());
  result_.triangles.push_back({a, corner, c});
  own(side, a);
  own(side + 1, corner);
  if (left_ == 3) own(side + 2, c);
  owner_[a] = side + 2;
  next_[a] = c;
  previous_[c] = a;
  gone_[corner] = true;
  --left_;
}

/// The two edges of a spike lie on each other; corner and one of its neighbours go.
void EarClipper::dropSpike(Index corner) {
  const Index a = previous_[corner], c = next_[corner];
  if (owner_[a] != kNone && owner_[corner] != kNone) {
    result_.diagonals.emplace_back(owner_[a], owner_[corner]);
  }
  gone_[corner] = gone_[c] = true;
  owner_[a] = owner_[c];
  next_[a] = next_[c];
  previous_[next_[c]] = a;
  left_ -= 2;
}

/// Clips one corner that the rule allows, that with the shortest diagonal first.
bool EarClipper::clipByRule(Rule rule) {
  while (!heap_.empty()) {
    const auto [length, corner] = heap_.front();
    std::pop_heap(heap_.begin(), heap_.end(), std::greater<>());
    heap_.pop_back();
    if (gone_[corner]) continue;
    if (reach(corner) != length) continue;  // an old entry
    if (!mayClip(corner, rule)) {
      waiting_.push_back(corner);
      continue;
    }
    const Index a = previous_[corner], c = next_[corner];
    if (rule == Rule::Spike) {
      dropSpike(corner);
    } else {
      clip(corner);
    }
    for (const Index neighbour : {a, c, next_[a]}) {
      if (left_ > 2 && !gone_[neighbour]) push(neighbour);
    }
    return true;
  }
  return false;
}

EarClipper::Result EarClipper::run() {
  for (Index i = 0; i < point_.size(); ++i) push(i);
  int rule = 0;
  bool clipped = false;  // anything since the heap was filled
  while (left_ > 2) {
    if (clipByRule(static_cast<Rule>(rule))) {
      clipped = true;
      rule = 0;
      continue;
    }
    // All were tried; what was clipped meanwhile may have made ears of others.
    rule = clipped ? 0 : rule + 1;
    if (rule > static_cast<int>(Rule::Spike)) break;
    clipped = false;
    std::sort(waiting_.begin(), waiting_.end());
    waiting_.erase(std::unique(waiting_.begin(), waiting_.end()), waiting_.end());
    for (const Index corner : std::exchange(waiting_, {})) {
      if (!gone_[corner]) push(corner);
    }
  }
  return std::move(result_);
}

}  // namespace chartflood
