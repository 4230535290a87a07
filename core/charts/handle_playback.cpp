#include "core/charts/handle_playback.h"

#include <algorithm>

#include "core/base/check.h"

namespace chartflood {

namespace {

Index localTriangle(const ChartSurface& surface, Index meshTriangle) {
  const auto& all = surface.meshTriangle;
  return static_cast<Index>(std::lower_bound(all.begin(), all.end(), meshTriangle) - all.begin());
}

}  // namespace

HandlePlayback::HandlePlayback(const ChartSurface& surface, const HandleRecord& record)
    : surface_(surface), record_(record), lidded_(surface),
      stepOfFace_(lidded_.faceCount(), kNone) {
  std::size_t i = 0;
  for (Index step = 0; step < record.steps(); ++step) {
    for (; i < record.stepEnd[step]; ++i) {
      const Index triangle = localTriangle(surface, record.triangles[i]);
      CF_CHECK(triangle < surface.triangleCount());
      stepOfFace_[lidded_.faceOf(3 * triangle)] = step;
      // A border is reached with the first triangle at it.
      for (Index side = 3 * triangle; side < 3 * triangle + 3; ++side) {
        const Index beyond = lidded_.faceOf(lidded_.opposite(side));
        if (lidded_.isLid(beyond)) stepOfFace_[beyond] = std::min(stepOfFace_[beyond], step);
      }
    }
  }
}

void HandlePlayback::seek(std::size_t steps) {
  if (steps < position_) {
    states_ = events_ = cuts_ = 0;
    live_.clear();
  }
  position_ = std::min(steps, record_.steps());
  // Within a step the fronts that are left get their states after all events.
  const auto& states = record_.states;
  const auto& events = record_.events;
  while (true) {
    const bool moreStates = states_ < states.size() && states[states_].step < position_;
    const bool moreEvents = events_ < events.size() && events[events_].step < position_;
    if (moreEvents && (!moreStates || events[events_].step <= states[states_].step)) {
      const HandleEvent& event = events[events_++];
      if (event.kind == HandleEventKind::Cut || event.kind == HandleEventKind::Fallback) {
        cuts_ = event.endCut;
        continue;
      }
      live_.erase(event.fronts[0]);
      if (event.kind == HandleEventKind::Touch) live_.erase(event.fronts[1]);
    } else if (moreStates) {
      const FrontState& state = states[states_++];
      const auto [entry, isNew] = live_.try_emplace(state.front, Live{state, state});
      entry->second.last = state;
      if (state.length < entry->second.kept.length) entry->second.kept = state;
    } else {
      return;
    }
  }
}

std::span<const Index> HandlePlayback::taken() const {
  return {record_.triangles.data(), position_ == 0 ? 0 : record_.stepEnd[position_ - 1]};
}

std::span<const HandleEvent> HandlePlayback::lastEvents() const {
  std::size_t first = events_;
  while (first > 0 && record_.events[first - 1].step + 1 == position_) --first;
  return {record_.events.data() + first, events_ - first};
}

std::vector<Index> HandlePlayback::sidesOf(const FrontState& state, Index step) const {
  Index side = 3 * localTriangle(surface_, state.side / 3) + state.side % 3;
  const Index taken = stepOfFace_[lidded_.faceOf(side)];
  if (taken == kNone || taken > step) side += lidded_.sideCount();
  std::vector<Index> sides = traceFront(lidded_, stepOfFace_, step, side);
  for (Index& s : sides) s = surface_.meshSide(s % lidded_.sideCount());
  return sides;
}

std::vector<FrontPicture> HandlePlayback::fronts() const {
  std::vector<FrontPicture> pictures;
  for (const auto& [number, live] : live_) {
    pictures.push_back({number, live.last.length,
                        sidesOf(live.last, static_cast<Index>(position_ - 1)), live.kept.length,
                        sidesOf(live.kept, live.kept.step)});
  }
  return pictures;
}

}  // namespace chartflood
