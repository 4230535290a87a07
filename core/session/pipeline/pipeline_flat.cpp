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
  return run_.shownFlat.atlas && !stale() && run_.shownFlat.of == run_.segmentation &&
         !differWithin(run_.shownFlat.parameters, document_.parameters, Stage::Cut, Stage::Layout);
}

bool Pipeline::awaitsUnwrap() const {
  return complete() && !isFlat() && (finished() || run_.unwrapAsked);
}

void Pipeline::dropStaleFlat() {
  const Parameters made = run_.flat.parameters;
  const Parameters& now = document_.parameters;
  // The search for handles begins from the generator seed.
  const bool cutAnew =
      differWithin(made, now, Stage::Cut, Stage::Cut) || made.rngSeed != now.rngSeed;
  if (run_.flat.of != run_.segmentation || cutAnew) run_.flat = {};
  if (differWithin(made, now, Stage::Unwrap, Stage::Unwrap)) {
    run_.flat.charts.reset();
    run_.flat.unwrap.reset();
    run_.flat.atlas.reset();
  }
  if (differWithin(made, now, Stage::Layout, Stage::Layout)) run_.flat.atlas.reset();
  run_.flat.of = run_.segmentation;
  run_.flat.parameters = document_.parameters;
}

bool Pipeline::cutOpen(Progress& progress) {
  dropStaleFlat();
  if (run_.flat.cut) return true;
  progress.beginPhase("Cutting into disks");
  const Parameters& p = document_.parameters;
  CutOptions options{p.cutHandles, p.cutLoops, p.cutTips, p.tip};
  const bool wavefront = p.handleSearch == "wavefront";
  options.handleSearch = wavefront ? HandleSearch::Wavefront : HandleSearch::Shortest;
  options.seed = static_cast<std::uint32_t>(p.rngSeed);
  timed(run_.timing.cut,
        [&] { run_.flat.cut = cutCharts(*mesh_, *run_.segmentation, options, progress); });
  return run_.flat.cut != nullptr;
}

bool Pipeline::layFlat(Progress& progress) {
  if (!cutOpen(progress)) return false;
  if (!run_.flat.unwrap) {
    progress.beginPhase("Laying charts flat");
    UnwrapOptions options = unwrapOptions(document_.parameters);
    options.sketch = run_.depth == Depth::Sketch;
    timed(run_.timing.unwrap, [&] {
      UnwrapResult result = unwrapCharts(*mesh_, run_.flat.cut, options, progress);
      run_.flat.charts = std::move(result.charts);
      run_.flat.unwrap = std::move(result.unwrap);
    });
    if (!run_.flat.unwrap) return false;
  }
  return true;
}

bool Pipeline::unwrap(Progress& progress) {
  run_.unwrapAsked = true;
  if (!layFlat(progress)) return false;
  const Parameters& p = document_.parameters;
  if (!run_.flat.atlas) {
    progress.beginPhase("Packing the texture");
    using Kind = LayoutOptions::Kind;
    const LayoutOptions options{p.layout == "square" ? Kind::Square : Kind::Packed, p.textureSize,
                                p.margin};
    timed(run_.timing.pack, [&] {
      run_.flat.atlas = layoutAtlas(*run_.flat.charts, *run_.flat.unwrap, options, progress);
    });
    if (!run_.flat.atlas) return false;
    tellMargin();
  }
  const bool cutAnew = run_.shownFlat.charts != run_.flat.charts;
  run_.shownFlat = run_.flat;
  if (cutAnew && run_.depth == Depth::Whole) {
    tellNotFlat();
    tellAboveLimit();
  }
  return true;
}

void Pipeline::tellNotFlat() const {
  for (std::size_t c = 0; c < run_.flat.unwrap->charts.size(); ++c) {
    const std::string& problem = run_.flat.unwrap->charts[c].problem;
    if (problem.empty()) continue;
    tell(Notice::Kind::Warning,
         "Chart " + std::to_string(c) + " could not be flattened: " + problem);
  }
}

void Pipeline::tellAboveLimit() const {
  const double limit = stretchLimit(document_.parameters, false);
  const std::string text = aboveLimitText(limit, *run_.flat.unwrap);
  if (!text.empty()) tell(Notice::Kind::Warning, text);
}

}  // namespace chartflood
