#include "core/pack/layout_atlas.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <glm/geometric.hpp>

#include "core/base/check.h"
#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/pack/grid_layout.h"
#include "core/pack/packed_layout.h"

namespace chartflood {

namespace {

/// Space to keep free, as shares of the texture. A chart may touch a pixel with its very border, so
/// that `margin` empty pixels need one more than that between two outlines. Half of it to the
/// texture's sides leaves a full margin where the texture repeats.
PackGaps gapsOf(int textureSize, int margin) {
  constexpr double kInside = 1e-6;
  if (margin == 0) return {kInside, kInside};
  const double pixel = 1.0 / textureSize;
  const int half = (margin + 1) / 2;
  return {(margin + 1 + kInside) * pixel, (half + kInside) * pixel};
}

/// Whether charts keep as much for themselves as lies between them, and a pixel at least.
bool leavesRoom(std::size_t charts, int textureSize, int margin) {
  const double cell = gridCell(charts, gapsOf(textureSize, margin)) * textureSize;
  return margin == 0 || cell >= std::max(1, margin / 2);
}

/// The margin asked for or, where so many charts would have no room, the largest that leaves some.
int marginFor(std::size_t charts, const LayoutOptions& options) {
  int margin = options.margin;
  while (!leavesRoom(charts, options.textureSize, margin)) --margin;
  return margin;
}

void checkOptions(const LayoutOptions& options) {
  if (options.textureSize < 1) {
    throw Error("A texture of " + std::to_string(options.textureSize) +
                " pixels a side cannot hold charts; it needs at least 1.");
  }
  if (options.margin < 0) {
    throw Error("A margin of " + std::to_string(options.margin) +
                " pixels is less than none; it must be at least 0.");
  }
}

/// Applies the placements to all vertices, and sums what the charts cover.
void finish(Atlas& atlas, const ChartSet& charts, const Unwrap& unwrap) {
  std::vector<double> covered(charts.charts.size(), 0);
  atlas.uv.resize(charts.charts.size());
  parallelFor(charts.charts.size(), [&](std::size_t k) {
    const Placement& placement = atlas.placement[k];
    if (!placement.placed()) return;
    std::vector<glm::dvec2>& uv = atlas.uv[k];
    uv.reserve(unwrap.charts[k].uv.size());
    for (const glm::dvec2& p : unwrap.charts[k].uv) uv.push_back(placement.at(p));
    for (const auto& [a, b, c] : charts.charts[k].surface.triangles) {
      const glm::dvec2 d = uv[b] - uv[a], e = uv[c] - uv[a];
      covered[k] += std::abs(d.x * e.y - d.y * e.x) / 2;
    }
  });
  for (const double area : covered) atlas.efficiency += area;
}

}  // namespace

int textureSizeFor(std::size_t charts, int margin) {
  int size = 1;
  while (!leavesRoom(charts, size, margin)) size *= 2;
  return size;
}

std::shared_ptr<const Atlas> layoutAtlas(const ChartSet& charts, const Unwrap& unwrap,
                                         const LayoutOptions& options, Progress& progress) {
  CF_CHECK(charts.charts.size() == unwrap.charts.size());
  checkOptions(options);
  progress.beginPhase("Packing charts");
  std::vector<ChartOutline> all(charts.charts.size());
  parallelFor(all.size(), [&](std::size_t k) {
    if (!progress.cancelled()) all[k] = outlineOf(charts.charts[k].surface, unwrap.charts[k].uv);
  });
  std::vector<std::size_t> chartOf;
  std::vector<ChartOutline> outlines;
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (all[k].empty()) continue;
    chartOf.push_back(k);
    outlines.push_back(std::move(all[k]));
  }
  auto atlas = std::make_shared<Atlas>();
  atlas->placement.resize(charts.charts.size());
  atlas->textureSize = options.textureSize;
  atlas->margin = marginFor(outlines.size(), options);
  const PackGaps gaps = gapsOf(options.textureSize, atlas->margin);
  const std::vector<Placement> placement = options.kind == LayoutOptions::Kind::Square
                                               ? gridLayout(outlines, gaps, false)
                                               : packedLayout(outlines, gaps, progress);
  if (progress.cancelled()) return nullptr;
  for (std::size_t i = 0; i < chartOf.size(); ++i) atlas->placement[chartOf[i]] = placement[i];
  finish(*atlas, charts, unwrap);
  progress.setFraction(1);
  return atlas;
}

}  // namespace chartflood
