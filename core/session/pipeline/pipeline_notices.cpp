// What the user is told of a run.

#include <algorithm>
#include <string>
#include <utility>

#include "core/pack/layout_atlas.h"
#include "core/segment/fast/fast_flooding.h"
#include "core/segment/parts/part_shares.h"
#include "core/segment/parts/seeds.h"
#include "core/segment/registry.h"
#include "core/session/pipeline/pipeline.h"

namespace chartflood {

void Pipeline::tell(Notice::Kind kind, std::string text) const {
  listener_.onNotice({kind, std::move(text)});
}

void Pipeline::tellChartCount() {
  const std::size_t wanted = wantedCharts();
  const std::size_t locked = lockedFaces(document_.seeds).size();
  // Methods that come to their charts one by one begin with fewer seeds.
  const std::size_t seeds = segmenterOf(document_.parameters.method).beginsWithAllSeeds
                                ? run_.start.seeds.size()
                                : std::max(locked, run_.start.seeds.size());
  const std::size_t count = effectiveChartCount(*mesh_, wanted, seeds);
  const bool byFeatures = wanted < static_cast<std::size_t>(document_.parameters.charts);
  if ((count == wanted && !byFeatures) || count == toldCharts_) return;
  toldCharts_ = count;
  const std::string number = std::to_string(count);
  if (count == wanted) {
    tell(Notice::Kind::Info, "This model has " + number + (count == 1 ? " feature" : " features") +
                                 " (flat regions, parts), so K is " + number + ".");
  } else if (count < wanted) {
    tell(Notice::Kind::Warning, "Only " + number + " faces: K was set to " + number + ".");
  } else if (locked > wanted && locked >= mesh_->componentCount()) {
    tell(Notice::Kind::Warning,
         std::to_string(locked) + " seeds are locked, so K was raised to " + number + ".");
  } else if (mesh_->componentCount() > 1) {
    tellParts(wanted, number);
  }
}

void Pipeline::tellMargin() const {
  const Parameters& p = document_.parameters;
  const Atlas& atlas = *run_.flat.atlas;
  if (atlas.margin >= p.margin) return;
  const auto placed = [](const Placement& placement) { return placement.placed(); };
  const auto charts = static_cast<std::size_t>(
      std::count_if(atlas.placement.begin(), atlas.placement.end(), placed));
  tell(Notice::Kind::Warning,
       "A margin of " + std::to_string(p.margin) + " pixels leaves no room for " +
           std::to_string(charts) + " charts in a texture of " + std::to_string(p.textureSize) +
           " pixels a side: they keep " + std::to_string(atlas.margin) + "; a texture of " +
           std::to_string(textureSizeFor(charts, p.margin)) + " pixels keeps them all.");
}

void Pipeline::tellParts(std::size_t wanted, const std::string& number) {
  const PartCount parts = countWithParts(*mesh_, wanted);
  if (parts.charts == wanted) return;  // seeds are there that ask for more
  const std::string small = parts.small == parts.parts || parts.small == 0
                                ? ""
                                : ", and the " + std::to_string(parts.small) +
                                      (parts.small == 1 ? " small one takes" : " small ones take") +
                                      " none from the others";
  tell(Notice::Kind::Warning, std::to_string(parts.parts) +
                                  " separate parts: each gets at least one chart" + small +
                                  ", so K was raised to " + number + ".");
}

void Pipeline::tellTooSmall() {
  if (std::exchange(toldLiteral_, true)) return;
  tell(Notice::Kind::Info, "The fast search needs " + std::to_string(kFastFacesPerChart) +
                               " faces a chart; this mesh is searched literally.");
}

void Pipeline::tellOutcome() {
  if (run_.start.creases) return tell(Notice::Kind::Info, "Charts begin from the model's creases.");
  const auto rounds = std::to_string(run_.stepper->history().size());
  const auto kept = "round " + std::to_string(run_.stepper->state()->iteration + 1) + " of " +
                    rounds + " is kept.";
  switch (run_.stepper->stopReason()) {
  case StopReason::Converged:
    return tell(Notice::Kind::Info, "Stopped: all seeds rest; " + kept);
  case StopReason::Cycle:
    return tell(Notice::Kind::Info, "Stopped: the seeds returned to an earlier place; " + kept);
  case StopReason::MaxIterations:
    return tell(Notice::Kind::Info, "Stopped after the most iterations allowed; " + kept);
  case StopReason::NoImprovement:
    if (!segmenterOf(document_.parameters.method).balances) {
      return tell(Notice::Kind::Info, "Stopped: more rounds bring no better fit; " + kept);
    }
    if (run_.start.fast) {
      return tell(Notice::Kind::Info,
                  "Stopped: more floods around the seams bring no better balance; " + kept);
    }
    return tell(Notice::Kind::Info, "Stopped: no better balance for " +
                                        std::to_string(document_.parameters.patience) +
                                        " rounds; " + kept);
  case StopReason::Balanced:
    return tell(Notice::Kind::Info, "Stopped: the charts are even; " + kept);
  case StopReason::NotStopped:
  case StopReason::Cancelled:
    return;
  }
}

}  // namespace chartflood
