#include "core/pack/parting.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace chartflood {

namespace {

constexpr int kSettleSteps = 60;

}  // namespace

/// Settles the first charts, from the fitted scale on.
bool Parting::settleFirst(Fitted& fitted, std::size_t count, int steps,
                          std::vector<std::size_t>& stuck) const {
  Settled settled =
      settle(std::span(fitted.charts).first(count), gaps_, fitted.scale, steps, progress_);
  fitted.scale = settled.scale;
  stuck = std::move(settled.stuck);
  return settled.apart;
}

/// What the first charts leave free at the fitted scale.
FreeSpace Parting::spaceAround(const Fitted& fitted, std::size_t count, double cells) const {
  const double side = layoutScale_ / fitted.scale;
  FreeSpace space(side, gaps_.between * side, gaps_.border * side, side / cells,
                  FreeSpace::Overlap::Barred);
  for (std::size_t i = 0; i < count; ++i) {
    const Pose& pose = fitted.charts[i].pose;
    space.add(
        space.footprint(shapes_[i], {(pose.x - 0.5) * side, (pose.y - 0.5) * side, pose.angle}));
  }
  return space;
}

/// Puts a chart into a free place, if there is one.
bool Parting::tryPlace(Fitted& fitted, std::size_t chart, int turns, FreeSpace& space) const {
  const double side = layoutScale_ / fitted.scale;
  Pose& pose = fitted.charts[chart].pose;
  const Pose found = space.bestPose(shapes_[chart], pose.angle, turns);
  if (!space.fits(shapes_[chart], found)) return false;
  pose = {found.x / side + 0.5, found.y / side + 0.5, found.angle};
  space.add(space.footprint(shapes_[chart], found));
  return true;
}

void Parting::largeFirst(std::vector<std::size_t>& charts) const {
  std::stable_sort(charts.begin(), charts.end(),
                   [&](std::size_t a, std::size_t b) { return shapes_[a].area > shapes_[b].area; });
}

/// Charts stuck in bays of others are put into any free places that they fit.
/// \return whether all found one
bool Parting::replaceStuck(Fitted& fitted, std::size_t count,
                           std::vector<std::size_t> stuck) const {
  // Cells of a third of the gap are fine enough.
  constexpr double kMostCells = 1000, kLeastCells = 300;
  constexpr int kTurns = 16;
  const double cells = std::clamp(3 / std::max(gaps_.between, 1e-9), kLeastCells, kMostCells);
  // Those that find no other place stay, so that theirs is not free either.
  FreeSpace space = spaceAround(fitted, count, cells);
  largeFirst(stuck);
  bool all = true;
  for (const std::size_t i : stuck) all = tryPlace(fitted, i, kTurns, space) && all;
  return all;
}

/// Parts the first charts, by putting those that stay stuck elsewhere or, at last, by much more
/// room.
void Parting::settleSomehow(Fitted& fitted, std::size_t count) const {
  constexpr int kReplacings = 8;
  constexpr double kSmaller = 0.995;
  const Fitted before = fitted;
  std::vector<std::size_t> stuck;
  for (int i = 0; i <= kReplacings && !progress_.cancelled(); ++i) {
    const int steps = i < kReplacings ? kSettleSteps : 2 * kSettleSteps;
    if (settleFirst(fitted, count, steps, stuck)) return;
    if (fitted.scale < leastScale_) break;
    if (!replaceStuck(fitted, count, std::move(stuck))) fitted.scale *= kSmaller;
  }
  for (const double room : {0.97, 0.9, 0.75, 0.5}) {
    fitted = before;
    fitted.scale *= room;
    if (fitted.scale < leastScale_) break;
    if (settleFirst(fitted, count, 2 * kSettleSteps, stuck) || progress_.cancelled()) return;
  }
  fitted.scale = 0;
}

/// Puts crumbs into free places, all charts smaller from time to time until each crumb has one.
void Parting::placeCrumbs(Fitted& fitted, std::size_t crumbs) const {
  constexpr double kSmaller = 0.99, kCells = 500;
  constexpr int kTurns = 4, kTries = 40;
  std::vector<std::size_t> loose;
  for (std::size_t i = crumbs; i < fitted.charts.size(); ++i) loose.push_back(i);
  largeFirst(loose);
  for (int i = 0; i < kTries && !progress_.cancelled(); ++i) {
    FreeSpace space = spaceAround(fitted, crumbs, kCells);
    const bool all = std::all_of(loose.begin(), loose.end(), [&](std::size_t chart) {
      return tryPlace(fitted, chart, kTurns, space);
    });
    if (all || fitted.scale < leastScale_) return;
    fitted.scale *= kSmaller;
  }
}

void Parting::part(Fitted& fitted, std::size_t crumbs, std::vector<std::size_t> hanging) const {
  if (!hanging.empty()) replaceStuck(fitted, crumbs, std::move(hanging));
  settleSomehow(fitted, crumbs);
  if (crumbs == fitted.charts.size() || fitted.scale == 0 || progress_.cancelled()) return;
  placeCrumbs(fitted, crumbs);
  settleSomehow(fitted, fitted.charts.size());
}

void Parting::makeUpright(Fitted& fitted) const {
  constexpr double kQuarter = std::numbers::pi / 2, kNearly = 0.1;
  Fitted upright = fitted;
  bool turned = false;
  for (std::size_t i = 0; i < shapes_.size(); ++i) {
    double& angle = upright.charts[i].pose.angle;
    const double off = std::remainder(angle - shapes_[i].upright, kQuarter);
    if (!shapes_[i].boxy || std::abs(off) > kNearly) continue;
    angle -= off;
    turned = true;
  }
  if (!turned) return;
  std::vector<std::size_t> stuck;
  const bool apart = settleFirst(upright, upright.charts.size(), kSettleSteps, stuck);
  if (apart && upright.scale >= kUprightWorth * fitted.scale) fitted = std::move(upright);
}

}  // namespace chartflood
