// Time and density of packing, by number of charts. Run it on a quiet machine:
//   build/release/tests/bench_pack
// `covered` is the share of the texture that charts cover: 2048 pixels a side, margin 4.

#include <benchmark/benchmark.h>

#include "core/pack/layout_atlas.h"
#include "tests/core/pack/laid_charts.h"

namespace chartflood {
namespace {

void pack(benchmark::State& state) {
  test::LaidCharts laid;
  Rng rng(1);
  for (int i = 0; i < state.range(0); ++i) laid.addBlob(0.05 + 0.001 * rng.below(100), rng);
  double covered = 0;
  for (auto _ : state) {
    covered = laid.layout({LayoutOptions::Kind::Packed, 2048, 4})->efficiency;
  }
  state.counters["covered"] = covered;
}

BENCHMARK(pack)
    ->Arg(20)
    ->Arg(100)
    ->Arg(300)
    ->Arg(1000)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

}  // namespace
}  // namespace chartflood

BENCHMARK_MAIN();
