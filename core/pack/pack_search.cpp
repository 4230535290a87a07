#include "core/pack/pack_search.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <cstdio>
#include <numbers>

#include "core/base/parallel.h"
#include "core/base/rng.h"
#include "core/pack/free_space.h"

extern "C" float gD0, gC;
namespace chartflood {

double envd(const char* n, double d) { const char* s = getenv(n); return s ? atof(s) : d; }

namespace {

double unit(Rng& rng) { return (rng.below(1u << 24) + 0.5) / (1u << 24); }

}  // namespace

PackLayout searchLayout(std::span<const PackShape> shapes, const PackGaps& gaps,
                        const SearchOptions& options, Progress& progress) {
  std::vector<PackLayout> starts(static_cast<std::size_t>(options.starts));
  const double fill0 = envd("FILL", 0.8);
  const double sigma = envd("SIGMA", 0.3);
  gD0 = (float)envd("D0", 0.0001); gC = (float)envd("DC", 10);
  std::vector<double> depths; { double d = envd("PMAX", 4); for (; d > envd("PMIN", 0.02); d /= envd("PDIV", 8)) depths.push_back(d); }
  const int turns = (int)envd("TURNS", 16);
  std::atomic<int> done{0};
  parallelFor(starts.size(), [&](std::size_t k) {
    Rng rng(options.seed + static_cast<std::uint32_t>(k));
    std::vector<std::pair<double, Index>> order;
    for (Index i = 0; i < shapes.size(); ++i) {
      order.emplace_back(-std::log(shapes[i].area + 1e-12) + sigma * (unit(rng) - 0.5) * 2, i);
    }
    std::sort(order.begin(), order.end());
    const double side = std::sqrt(1 / fill0);
    PackLayout layout{side, std::vector<Pose>(shapes.size())};
    FreeSpace space(side, gaps.between * side, gaps.border * side);
    for (const auto& [key, i] : order) {
      layout.poses[i] = space.bestPose(shapes[i], 2 * std::numbers::pi * unit(rng), turns);
      space.add(shapes[i], layout.poses[i]);
    }
    Squeezer squeezer(shapes, gaps);
    const double px = side / 1024;
    if (getenv("NOSQ") == nullptr) {
      for (const double depth : depths) {
        squeezer.run(layout, {4 * depth * px * envd("PRESS", 1), (int)envd("STEPS", 100)}, progress);
        if (getenv("VERB")) printf("  start %zu depth %g: side %.4f eff %.4f depth %g true %.4f\n", k, depth, layout.side, 1 / (layout.side * layout.side), squeezer.depth()/px, std::pow(layout.side*(1+squeezer.depth()/.2),-2));
      }
      layout.side *= 1 + squeezer.depth() / 0.2;
    }
    starts[k] = layout;
  });
  std::sort(starts.begin(), starts.end(), [](const PackLayout& a, const PackLayout& b) { return a.side < b.side; });
  if (getenv("VERB")) for (auto& l : starts) printf("start %.4f\n", 1 / (l.side * l.side));
  const int chains = (int)envd("CHAINS", 2), rounds = (int)envd("ROUNDS", 20);
  std::vector<double> rdepths; { double d = envd("RMAX", 2); for (; d > envd("RMIN", 0.02); d /= envd("RDIV", 8)) rdepths.push_back(d); }
  const int rsteps = (int)envd("RSTEPS", 80), kmin = (int)envd("KMIN", 2), kmax = (int)envd("KMAX", 4);
  starts.resize(chains);
  parallelFor(starts.size(), [&](std::size_t k) {
    Rng rng(1000 + options.seed + static_cast<std::uint32_t>(k));
    PackLayout best = starts[k];
    const Index n = static_cast<Index>(shapes.size());
    for (int round = 0; round < rounds && !progress.cancelled(); ++round) {
      progress.setFraction(0.3f + 0.6f * (float)done++ / (float)(chains * rounds));
      PackLayout layout = best;
      const int take = std::min<int>(n, kmin + rng.below(kmax - kmin + 1));
      // an item and its neighbours
      const Index first = rng.below(n);
      std::vector<std::pair<double, Index>> near;
      const bool local = unit(rng) < envd("LOCAL", 0.5);
      for (Index i = 0; i < n; ++i) {
        double d = i == first ? -1 : local ? std::hypot(layout.poses[i].x - layout.poses[first].x, layout.poses[i].y - layout.poses[first].y) - shapes[i].radius: unit(rng);
        near.emplace_back(d, i);
      }
      std::sort(near.begin(), near.end());
      std::vector<bool> out(n, false);
      std::vector<std::pair<double, Index>> order;
      for (int i = 0; i < take; ++i) out[near[i].second] = true, order.emplace_back(-std::log(shapes[near[i].second].area + 1e-12) + envd("RSIG",.5) * 2 * (unit(rng) - .5), near[i].second);
      std::sort(order.begin(), order.end());
      const double side = layout.side * envd("RSHRINK", 0.99);
      for (auto& p : layout.poses) p.x *= side / layout.side, p.y *= side / layout.side;
      layout.side = side;
      FreeSpace space(side, gaps.between * side, gaps.border * side);
      for (Index i = 0; i < n; ++i) if (!out[i]) space.add(shapes[i], layout.poses[i]);
      for (const auto& [key, i] : order) {
        layout.poses[i] = space.bestPose(shapes[i], 2 * std::numbers::pi * unit(rng), turns);
        space.add(shapes[i], layout.poses[i]);
      }
      Squeezer squeezer(shapes, gaps);
      const double px = side / 1024;
      for (const double depth : rdepths) squeezer.run(layout, {4 * depth * px, rsteps}, progress);
      layout.side *= 1 + squeezer.depth() / 0.2;
      if (layout.side < best.side) {
        best = layout;
        if (getenv("VERB")) printf("chain %zu round %d: %.4f\n", k, round, 1 / (best.side * best.side));
      }
    }
    starts[k] = best;
  });
  PackLayout best = starts[0];
  for (const PackLayout& l : starts) if (l.side < best.side) best = l;
  return best;
}

}  // namespace chartflood
