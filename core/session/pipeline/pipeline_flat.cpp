// The stages after the labels: cuts, unwrap and texture.

#include <algorithm>
#include <span>
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

/// Whether values of these stages differ. Others may, too: of rounds that finished charts outlive.
bool differWithin(const Parameters& a, const Parameters& b, Stage first, Stage last) {
  const std::span<const ParameterInfo> table = parameterTable();
  return std::any_of(table.begin(), table.end(), [&](const ParameterInfo& info) {
    return info.stage >= first && info.stage <= last &&
           parameterValue(a, info) != parameterValue(b, info);
  });
}

}  // namespace

bool Pipeline::isFlat() const {
  return shownFlat_.atlas && !stale() && shownFlat_.of == segmentation_ &&
         !differWithin(shownFlat_.parameters, document_.parameters, Stage::Cut, Stage::Layout);
}

bool Pipeline::awaitsUnwrap() const {
  return complete() && !isFlat() && (finished() || unwrapAsked_);
}

void Pipeline::dropStaleFlat() {
  const Parameters made = flat_.parameters;
  const Parameters& now = document_.parameters;
  // The search for handles begins from the generator seed.
  const bool cutAnew =
      differWithin(made, now, Stage::Cut, Stage::Cut) || made.rngSeed != now.rngSeed;
  if (flat_.of != segmentation_ || cutAnew) flat_ = {};
  if (differWithin(made, now, Stage::Unwrap, Stage::Unwrap)) {
    flat_.charts.reset();
    flat_.unwrap.reset();
    flat_.atlas.reset();
  }
  if (differWithin(made, now, Stage::Layout, Stage::Layout)) flat_.atlas.reset();
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
