// The stages after the labels: cuts, unwrap and texture.

#include <string>
#include <utility>

#include "core/base/stopwatch.h"
#include "core/charts/cut_charts.h"
#include "core/pack/layout_atlas.h"
#include "core/param/unwrap_charts.h"
#include "core/session/pipeline/pipeline.h"
#include "core/session/pipeline/stretch_limit.h"

namespace chartflood {

namespace {

template <class Work>
void timed(double& milliseconds, Work&& work) {
  const Stopwatch stopwatch;
  work();
  milliseconds = stopwatch.milliseconds();
}

}  // namespace

bool Pipeline::isFlat() const {
  Stage stage;
  const bool differs = firstDifference(shownFlat_.parameters, document_.parameters, stage);
  return shownFlat_.atlas && !stale() && shownFlat_.of == segmentation_ &&
         !(differs && stage >= Stage::Cut);
}

bool Pipeline::awaitsUnwrap() const {
  return complete() && !isFlat() && (finished() || unwrapAsked_);
}

void Pipeline::dropStaleFlat() {
  Stage stage = Stage::Layout;
  const bool changed = firstDifference(flat_.parameters, document_.parameters, stage);
  if (flat_.of != segmentation_ || (changed && stage <= Stage::Cut)) flat_ = {};
  if (changed && stage <= Stage::Unwrap) {
    flat_.charts.reset();
    flat_.unwrap.reset();
  }
  if (changed) flat_.atlas.reset();
  flat_.of = segmentation_;
  flat_.parameters = document_.parameters;
}

bool Pipeline::cutOpen(Progress& progress) {
  dropStaleFlat();
  if (flat_.cut) return true;
  progress.beginPhase("Cutting into disks");
  const Parameters& p = document_.parameters;
  CutOptions options{p.cutHandles, p.cutLoops, p.cutTips, p.tip};
  const bool wavefront = p.handleSearch == "wavefront";
  options.handleSearch = wavefront ? HandleSearch::Wavefront : HandleSearch::Shortest;
  options.seed = static_cast<std::uint32_t>(p.rngSeed);
  timed(timing_.cut, [&] { flat_.cut = cutCharts(*mesh_, *segmentation_, options, progress); });
  return flat_.cut != nullptr;
}

bool Pipeline::layFlat(Progress& progress) {
  if (!cutOpen(progress)) return false;
  if (!flat_.unwrap) {
    progress.beginPhase("Laying charts flat");
    const UnwrapOptions options = unwrapOptions(document_.parameters);
    timed(timing_.unwrap, [&] {
      UnwrapResult result = unwrapCharts(*mesh_, flat_.cut, options, progress);
      flat_.charts = std::move(result.charts);
      flat_.unwrap = std::move(result.unwrap);
    });
    if (!flat_.unwrap) return false;
  }
  return true;
}

bool Pipeline::unwrap(Progress& progress) {
  unwrapAsked_ = true;
  if (!layFlat(progress)) return false;
  const Parameters& p = document_.parameters;
  if (!flat_.atlas) {
    progress.beginPhase("Packing the texture");
    using Kind = LayoutOptions::Kind;
    const LayoutOptions options{p.layout == "square" ? Kind::Square : Kind::Packed, p.textureSize,
                                p.margin};
    timed(timing_.pack,
          [&] { flat_.atlas = layoutAtlas(*flat_.charts, *flat_.unwrap, options, progress); });
    if (!flat_.atlas) return false;
    tellMargin();
  }
  const bool cutAnew = shownFlat_.charts != flat_.charts;
  shownFlat_ = flat_;
  if (cutAnew) {
    tellNotFlat();
    tellAboveLimit();
  }
  return true;
}

void Pipeline::tellNotFlat() const {
  for (std::size_t c = 0; c < flat_.unwrap->charts.size(); ++c) {
    const std::string& problem = flat_.unwrap->charts[c].problem;
    if (problem.empty()) continue;
    tell(Notice::Kind::Warning,
         "Chart " + std::to_string(c) + " could not be flattened: " + problem);
  }
}

void Pipeline::tellAboveLimit() const {
  const double limit = stretchLimit(document_.parameters, false);
  const std::string text = aboveLimitText(limit, *flat_.unwrap);
  if (!text.empty()) tell(Notice::Kind::Warning, text);
}

}  // namespace chartflood
