#include "core/segment/borders/pair_cut.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace chartflood {

namespace {

constexpr std::size_t kPrices = 7;
constexpr double kFine = 1e9;        // whole numbers a unit of energy
constexpr double kMost = 1e15;       // of one amount: sums stay below the largest number
constexpr double kLeastFall = 1e-9;  // least fall of energy that counts

int defects(const SeamSums& a, const SeamSums& b) {
  return diskDefect(a.euler) + diskDefect(b.euler);
}

MaxFlow::Amount amountOf(double energy) {
  return static_cast<MaxFlow::Amount>(std::llround(std::clamp(energy * kFine, -kMost, kMost)));
}

}  // namespace

bool PairCut::run(SeamState& state, const SeamBalance& balance, Index a, Index b,
                  const Progress& progress) {
  state_ = &state;
  balance_ = &balance;
  a_ = a;
  b_ = b;
  candidateCount_ = 0;
  if (candidates_.empty()) candidates_.resize(kPrices);
  const bool found = findBand(state, a, b, heap_, band_);
  bool better = false;
  if (found) {
    prepareNodes();
    tryPrices(progress);
    better = !progress.cancelled() && choose();
  }
  release();
  return better;
}

void PairCut::prepareNodes() {
  SeamState& s = *state_;
  const SeamLevel& level = *s.level;
  start_.resize(band_.size());
  priced_.resize(band_.size());
  owned_.assign(band_.size(), 0);
  for (std::size_t v = 0; v < band_.size(); ++v) {
    const Index i = band_[v];
    start_[v] = s.label[i] == a_;
    double value = level.value[i];
    for (Index arc = level.arcBegin[i]; arc < level.arcBegin[i + 1]; ++arc) {
      if (inPair(level.arcHead[arc])) value += level.arcValue[arc] / 2;
    }
    priced_[v] = value;
    for (Index k = level.faceBegin[i]; s.price != nullptr && k < level.faceBegin[i + 1]; ++k) {
      owned_[v] += s.price->of(level.faceOfNode[k], a_) - s.price->of(level.faceOfNode[k], b_);
    }
  }
  inA_ = start_;
  now_ = {0, s.charts[a_], s.charts[b_], 0, 0};
}

/// The graph of the open nodes; what surrounds them pulls at their terminals.
void PairCut::buildGraph(double price) {
  SeamState& s = *state_;
  const SeamLevel& level = *s.level;
  numberInGraph_.assign(band_.size(), kNone);
  for (std::size_t v = 0; v < open_.size(); ++v) numberInGraph_[open_[v]] = static_cast<Index>(v);
  flow_.reset(open_.size());
  paid_.assign(open_.size(), 0);
  for (Index v = 0; v < open_.size(); ++v) {
    flow_.beginNode();
    const Index i = band_[open_[v]];
    for (Index arc = level.arcBegin[i]; arc < level.arcBegin[i + 1]; ++arc) {
      const Index j = level.arcHead[arc];
      if (!inPair(j)) continue;
      const MaxFlow::Amount length = amountOf(level.arcLength[arc] * s.unit);
      const Index to = s.local[j] == kNone ? kNone : numberInGraph_[s.local[j]];
      if (to == kNone) {
        flow_.addTerminal(v, isInA(j, inA_) ? length : -length);
        continue;
      }
      s.localArc[arc] = flow_.addArc(to, length);
      if (to > v) continue;
      flow_.setReverse(s.localArc[arc], s.localArc[level.arcTwin[arc]]);
      flow_.setReverse(s.localArc[level.arcTwin[arc]], s.localArc[arc]);
    }
  }
  flow_.endNodes();
  setPrice(price);
}

void PairCut::setPrice(double price) {
  for (Index v = 0; v < open_.size(); ++v) {
    const MaxFlow::Amount paid = amountOf(-price * priced_[open_[v]] - owned_[open_[v]]);
    flow_.addTerminal(v, paid - paid_[v]);
    paid_[v] = paid;
  }
}

/// Moves the open nodes to the sides of the minimum cut.
void PairCut::solve() {
  flow_.solve();
  for (Index v = 0; v < open_.size(); ++v) {
    if (flow_.onSourceSide(v) != (inA_[open_[v]] != 0)) flip(open_[v]);
  }
}

bool PairCut::inPair(Index node) const {
  const Index chart = labelOf(*state_, node);
  return chart == a_ || chart == b_;
}

bool PairCut::isInA(Index node, std::span<const std::uint8_t> inA) const {
  const Index v = state_->local[node];
  return v == kNone ? state_->label[node] == a_ : inA[v] != 0;
}

/// Gives a node to the other chart and keeps the sums exact.
void PairCut::flip(Index bandNode) {
  const SeamState& s = *state_;
  const SeamLevel& level = *s.level;
  const Index i = band_[bandNode];
  const bool wasA = inA_[bandNode] != 0;
  SeamSums& from = wasA ? now_.a : now_.b;
  SeamSums& to = wasA ? now_.b : now_.a;
  from.value -= level.value[i];
  from.area -= level.area[i];
  from.euler -= level.euler[i];
  to.value += level.value[i];
  to.area += level.area[i];
  to.euler += level.euler[i];
  for (Index arc = level.arcBegin[i]; arc < level.arcBegin[i + 1]; ++arc) {
    const Index j = level.arcHead[arc];
    if (!inPair(j)) continue;
    const bool leaves = isInA(j, inA_) == wasA;
    now_.length += leaves ? level.arcLength[arc] : -level.arcLength[arc];
    SeamSums& chart = leaves ? from : to;
    chart.value += leaves ? -level.arcValue[arc] : level.arcValue[arc];
    chart.euler += leaves ? -level.arcEuler[arc] : level.arcEuler[arc];
  }
  for (Index k = level.cornerBegin[i]; k < level.cornerBegin[i + 1]; ++k) {
    const Index corner = level.nodeCorner[k];
    bool inFrom = true, inTo = true;
    for (Index n = level.cornerNodeBegin[corner]; n < level.cornerNodeBegin[corner + 1]; ++n) {
      const Index j = level.cornerNode[n];
      if (j == i) continue;
      const bool pair = inPair(j);
      const bool withOld = pair && isInA(j, inA_) == wasA;
      inFrom = inFrom && withOld;
      inTo = inTo && pair && !withOld;
      if (!inFrom && !inTo) break;
    }
    if (inFrom) {
      from.value -= level.cornerValue[corner];
      --from.euler;
    } else if (inTo) {
      to.value += level.cornerValue[corner];
      ++to.euler;
    }
  }
  now_.own += wasA ? -owned_[bandNode] : owned_[bandNode];
  inA_[bandNode] = wasA ? 0 : 1;
}

/// Keeps the present sides as a candidate.
const PairCut::Figures& PairCut::judge() {
  SeamBalance after = *balance_;
  after.remove(state_->charts[a_].value);
  after.remove(state_->charts[b_].value);
  after.add(now_.a.value);
  after.add(now_.b.value);
  now_.energy = now_.length * state_->unit + now_.own + after.energy() - balance_->energy();
  now_.energy +=
      state_->defect * (defects(now_.a, now_.b) - defects(state_->charts[a_], state_->charts[b_]));
  Candidate& candidate = candidates_[candidateCount_++];
  candidate.figures = now_;
  candidate.inA = inA_;
  return candidate.figures;
}

/// Chart a shrinks as its price rises, so nodes on the same side at a lower and at a higher price
/// are decided for all prices between; one of the two is the present cut. True when some are open.
bool PairCut::narrow(const Candidate& low, const Candidate& high) {
  open_.clear();
  for (Index v = 0; v < band_.size(); ++v) {
    if (low.inA[v] != high.inA[v]) open_.push_back(v);
  }
  return !open_.empty();
}

/// Minimum cuts at several prices, closing in on the one that the resulting balance asks for. Ends
/// when no seam can be better than the best found by the least gain that counts.
void PairCut::tryPrices(const Progress& progress) {
  open_.resize(band_.size());
  for (Index v = 0; v < band_.size(); ++v) open_[v] = v;
  const double start = balance_->price(now_.a.value, now_.b.value);
  double price = start;
  buildGraph(price);
  std::size_t low = kNone, high = kNone;  // candidates at the ends of the bracket
  double lowPrice = 0, highPrice = 0;
  // What the energy may fall by beside the cut.
  const double saved = state_->defect * defects(state_->charts[a_], state_->charts[b_]);
  double best = 0, bound = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < kPrices && !progress.cancelled(); ++i) {
    solve();
    const Figures& found = judge();
    if (allowed(found)) best = std::min(best, found.energy);
    bound = std::max(bound, lowerBound(price, start));
    if (best - (bound - saved) <= state_->leastGain) return;
    SeamBalance after = *balance_;
    after.sum += now_.a.value + now_.b.value - state_->charts[a_].value - state_->charts[b_].value;
    const double asked = after.price(now_.a.value, now_.b.value);
    if (i + 1 == kPrices || std::abs(asked - price) <= 1e-12 * std::abs(price)) return;
    if (asked > price) {
      low = i;
      lowPrice = price;
    } else {
      high = i;
      highPrice = price;
    }
    if (low == kNone || high == kNone) {
      price = (price + asked) / 2;
      setPrice(price);
      continue;
    }
    price = (lowPrice + highPrice) / 2;
    if (!narrow(candidates_[low], candidates_[high])) return;
    buildGraph(price);
  }
}

/// What no seam in the band can change the energy by more than, downwards, by the minimum cut at
/// this price: balance as a function of what a has is convex, so it lies above its tangent of that
/// slope. Up to the values at the seam itself, which prices share out between the sides.
double PairCut::lowerBound(double price, double start) const {
  const double cut =
      now_.length * state_->unit + now_.own + price * (now_.a.value - state_->charts[a_].value);
  if (price == start) return cut;
  const double curvature = balance_->curvature();
  if (!(curvature > 0)) return -std::numeric_limits<double>::infinity();
  return cut - (price - start) * (price - start) / (2 * curvature);
}

/// The best candidate that keeps the charts whole; true when there is one.
bool PairCut::choose() {
  for (;;) {
    Candidate* best = nullptr;
    for (std::size_t i = 0; i < candidateCount_; ++i) {
      Candidate& candidate = candidates_[i];
      if (!(candidate.figures.energy < -kLeastFall) || !allowed(candidate.figures)) continue;
      if (best == nullptr || candidate.figures.energy < best->figures.energy) best = &candidate;
    }
    if (best == nullptr) return false;
    if (!staysWhole(best->inA)) {
      best->figures.energy = 0;  // out of the contest
      continue;
    }
    best_ = best->figures;
    toA_.clear();
    toB_.clear();
    for (std::size_t v = 0; v < band_.size(); ++v) {
      if (best->inA[v] != start_[v]) (start_[v] ? toB_ : toA_).push_back(band_[v]);
    }
    return true;
  }
}

/// True when neither chart vanishes or falls into more pieces than before.
bool PairCut::staysWhole(std::span<const std::uint8_t> inA) {
  for (const bool ofA : {true, false}) {
    const std::size_t after = pieces(inA, ofA);
    if (after == 0 || (after > 1 && after > pieces(start_, ofA))) return false;
  }
  return true;
}

bool PairCut::allowed(const Figures& after) const {
  const SeamChart& a = state_->charts[a_];
  const SeamChart& b = state_->charts[b_];
  return defects(after.a, after.b) <= defects(a, b) &&
         after.a.area >= std::min(state_->leastArea, a.area) &&
         after.b.area >= std::min(state_->leastArea, b.area);
}

/// Connected parts of chart a (or b) with the band's nodes on the given sides.
std::size_t PairCut::pieces(std::span<const std::uint8_t> inA, bool ofA) {
  SeamState& s = *state_;
  const SeamLevel& level = *s.level;
  std::size_t count = 0;
  const auto belongs = [&](Index i) { return inPair(i) && isInA(i, inA) == ofA; };
  for (const Index chart : {a_, b_}) {
    for (const Index start : s.charts[chart].nodes) {
      if (s.seen[start] || !belongs(start)) continue;
      ++count;
      queue_.assign(1, start);
      s.seen[start] = 1;
      while (!queue_.empty()) {
        const Index i = queue_.back();
        queue_.pop_back();
        for (Index arc = level.arcBegin[i]; arc < level.arcBegin[i + 1]; ++arc) {
          const Index j = level.arcHead[arc];
          if (!belongs(j) || s.seen[j]) continue;
          s.seen[j] = 1;
          queue_.push_back(j);
        }
      }
    }
  }
  for (const Index chart : {a_, b_}) {
    for (const Index i : s.charts[chart].nodes) s.seen[i] = 0;
  }
  return count;
}

/// Leaves the scratch entries as the next pair expects them.
void PairCut::release() {
  for (const Index i : band_) state_->local[i] = kNone;
  band_.clear();
}

}  // namespace chartflood
