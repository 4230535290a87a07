#include "core/charts/wavefront_handles.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include "core/base/rng.h"
#include "core/charts/make_cut.h"
#include "core/charts/shortest_handles.h"

namespace chartflood {

WavefrontHandles::WavefrontHandles(const ChartSurface& original, OpenSurface& open)
    : original_(original), open_(open), lidded_(original), fronts_(lidded_),
      stepOfFace_(lidded_.faceCount(), kNone), centre_(original.triangleCount()),
      distance_(original.triangleCount(), kNoWay) {}

void WavefrontHandles::run(std::uint32_t seed, bool onlyCuts, const Progress& progress) {
  progress_ = &progress;
  if (!lidded_.regular() || original_.triangleCount() == 0) return;
  Rng rng(seed);
  const Index triangle = rng.below(static_cast<std::uint32_t>(original_.triangleCount()));
  const Index start = lidded_.faceOf(3 * triangle);
  centre_[start] = lidded_.centreOf(start);
  distance_[start] = 0;
  queue_.push(0, start);
  while (!queue_.empty() && !progress.cancelled() && !(onlyCuts && open_.genus() == 0)) {
    const auto [distance, face] = queue_.pop();
    if (stepOfFace_[face] != kNone) continue;
    takeWithLids(face);
    remember();
    pushNeighbours(face, distance);
    ++step_;
  }
}

void WavefrontHandles::takeFace(Index face) {
  stepOfFace_[face] = step_;
  fronts_.take(face, [&](const HandleEvent& event) { happened(event); });
}

/// A lid is taken as soon as the region reaches its boundary loop.
void WavefrontHandles::takeWithLids(Index face) {
  for (const Index t : lidded_.trianglesOf(face)) {
    record_.triangles.push_back(original_.meshTriangle[t]);
  }
  record_.stepEnd.push_back(static_cast<Index>(record_.triangles.size()));
  takeFace(face);
  for (const Index side : lidded_.sidesOf(face)) {
    const Index beyond = lidded_.faceOf(lidded_.opposite(side));
    if (lidded_.isLid(beyond) && stepOfFace_[beyond] == kNone) takeFace(beyond);
  }
}

void WavefrontHandles::pushNeighbours(Index face, double distance) {
  for (const Index side : lidded_.sidesOf(face)) {
    const Index beyond = lidded_.faceOf(lidded_.opposite(side));
    if (lidded_.isLid(beyond) || stepOfFace_[beyond] != kNone) continue;
    if (!(distance_[beyond] < kNoWay)) centre_[beyond] = lidded_.centreOf(beyond);
    const double way = distance + glm::length(centre_[beyond] - centre_[face]);
    if (!(way < distance_[beyond])) continue;
    distance_[beyond] = way;
    queue_.push(way, beyond);
  }
}

void WavefrontHandles::remember() {
  kept_.resize(fronts_.frontCount());
  for (FrontState state : fronts_.changed()) {
    state.step = step_;
    Kept& kept = kept_[state.front];
    if (kept.step == kNone || state.length < kept.length) kept = {step_, state.side, state.length};
    state.side = original_.meshSide(state.side % lidded_.sideCount());
    record_.states.push_back(state);
  }
}

void WavefrontHandles::happened(HandleEvent event) {
  event.step = step_;
  record_.events.push_back(event);
  if (event.kind == HandleEventKind::Touch && open_.genus() > 0) {
    openHandle(event.fronts[0], event.fronts[1]);
  }
}

/// Cuts the shorter of the loops that the two fronts remember, or the other one if that will not
/// do, or else the shortest loop there is.
void WavefrontHandles::openHandle(Index a, Index b) {
  kept_.resize(fronts_.frontCount());
  if (kept_[b].step != kNone && kept_[a].step != kNone && kept_[b].length < kept_[a].length) {
    std::swap(a, b);
  }
  if (!cutKept(a) && !cutKept(b)) cutShortest();
}

bool WavefrontHandles::cutKept(Index front) {
  const Kept& kept = kept_[front];
  if (kept.step == kNone) return false;
  std::vector<Index> walk = traceFront(lidded_, stepOfFace_, kept.step, kept.side);
  std::erase_if(walk, [&](Index side) { return lidded_.onLid(side); });
  const auto path = handlePath(open_, walk);
  if (!path) return false;
  recordCuts({HandleEventKind::Cut, step_, {front, kNone, kNone}}, *path);
  return true;
}

void WavefrontHandles::cutShortest() {
  ShortestHandles search(open_);
  const auto walk = search.find(*progress_);
  if (!walk) return;
  const auto path = handlePath(open_, *walk);
  if (!path) return;
  recordCuts({HandleEventKind::Fallback, step_, {kNone, kNone, kNone}}, *path);
}

void WavefrontHandles::recordCuts(HandleEvent event, const HandlePath& path) {
  event.firstCut = static_cast<Index>(record_.cuts.size());
  for (std::size_t i = 0; i < path.pieces.size(); ++i) {
    const CutReason reason = i + 1 < path.pieces.size() ? CutReason::Loop : CutReason::Handle;
    record_.cuts.push_back(makeCut(open_.surface(), reason, path.pieces[i]));
    open_.open(path.pieces[i]);
  }
  event.endCut = static_cast<Index>(record_.cuts.size());
  record_.events.push_back(event);
}

}  // namespace chartflood
