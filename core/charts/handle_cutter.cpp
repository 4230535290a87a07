#include "core/charts/handle_cutter.h"

#include <utility>

#include "core/charts/make_cut.h"
#include "core/charts/open_surface.h"
#include "core/charts/shortest_handles.h"
#include "core/charts/wavefront_handles.h"

namespace chartflood {

namespace {

void cutShortest(OpenSurface& surface, std::vector<Cut>& cuts, const Progress& progress) {
  if (surface.genus() <= 0) return;
  ShortestHandles search(surface);
  while (surface.genus() > 0) {
    const auto walk = search.find(progress);
    if (!walk) return;
    const auto path = handlePath(surface, *walk);
    if (!path) return;
    for (std::size_t i = 0; i < path->pieces.size(); ++i) {
      const CutReason reason = i + 1 < path->pieces.size() ? CutReason::Loop : CutReason::Handle;
      cuts.push_back(makeCut(surface.surface(), reason, path->pieces[i]));
    }
    search.open(*walk, *path);
  }
}

}  // namespace

std::vector<Cut> cutHandles(ChartSurface& surface, HandleSearch search, std::uint32_t seed,
                            const Progress& progress) {
  std::vector<Cut> cuts;
  OpenSurface open(surface);
  if (open.genus() > 0 && search == HandleSearch::Wavefront) {
    const ChartSurface original = surface;
    WavefrontHandles wavefront(original, open);
    wavefront.run(seed, true, progress);
    cuts = std::move(wavefront.takeRecord().cuts);
  }
  cutShortest(open, cuts, progress);
  return cuts;
}

HandleRecord recordHandleCutter(const ChartSurface& surface, std::uint32_t seed,
                                const Progress& progress) {
  ChartSurface opened = surface;
  OpenSurface open(opened);
  WavefrontHandles wavefront(surface, open);
  wavefront.run(seed, false, progress);
  return wavefront.takeRecord();
}

}  // namespace chartflood
