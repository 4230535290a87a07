// Time per face of laying charts flat: single disks of growing size, then all charts of real
// meshes. Run it on a quiet machine:
//   build/release/tests/bench_unwrap

#include <cstdlib>
#include <filesystem>
#include <map>
#include <memory>
#include <string>

#include <benchmark/benchmark.h>

#include "core/base/parallel.h"
#include "core/charts/chart_surface.h"
#include "core/charts/cut_charts.h"
#include "core/flood/build_flood_graph.h"
#include "core/gauss/compute_gauss_area.h"
#include "core/io/read_mesh.h"
#include "core/model/build_mesh.h"
#include "core/param/chart_shape.h"
#include "core/param/circle_map.h"
#include "core/param/free_map.h"
#include "core/param/free_start.h"
#include "core/param/stretch.h"
#include "core/param/unwrap_charts.h"
#include "core/samples/samples.h"
#include "core/segment/registry.h"

namespace chartflood {
namespace {

void perFace(benchmark::State& state, std::size_t faces) {
  state.counters["ns/face"] = benchmark::Counter(static_cast<double>(faces) * 1e-9,
                                                 benchmark::Counter::kIsIterationInvariantRate |
                                                     benchmark::Counter::kInvert);
  state.counters["faces"] = static_cast<double>(faces);
}

/// A square with hills, one disk.
const ChartSurface& hills(std::size_t triangles) {
  static std::map<std::size_t, ChartSurface> made;
  ChartSurface& surface = made[triangles];
  if (surface.triangles.empty()) {
    const auto mesh = buildMesh(makeSample("bumps", triangles));
    const std::vector<Index> label(mesh->faceCount(), 0);
    surface = extractCharts(*mesh, label, 1).front();
  }
  return surface;
}

void order(benchmark::State& state) {
  const ChartSurface& s = hills(static_cast<std::size_t>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(ChartShape(s));
  perFace(state, s.triangleCount());
}

void conformal(benchmark::State& state) {
  const ChartSurface& s = hills(static_cast<std::size_t>(state.range(0)));
  const ChartShape shape(s);
  for (auto _ : state) benchmark::DoNotOptimize(conformalMap(shape));
  perFace(state, s.triangleCount());
}

void circle(benchmark::State& state) {
  const ChartSurface& s = hills(static_cast<std::size_t>(state.range(0)));
  const ChartShape shape(s);
  for (auto _ : state) benchmark::DoNotOptimize(circleMap(shape, CircleWeights::Conformal));
  perFace(state, s.triangleCount());
}

void free(benchmark::State& state) {
  const ChartSurface& s = hills(static_cast<std::size_t>(state.range(0)));
  const ChartShape shape(s);
  Progress progress;
  for (auto _ : state) benchmark::DoNotOptimize(freeMap(shape, progress));
  perFace(state, s.triangleCount());
}

void stretch(benchmark::State& state) {
  const ChartSurface& s = hills(static_cast<std::size_t>(state.range(0)));
  const auto uv = circleMap(ChartShape(s), CircleWeights::Conformal);
  for (auto _ : state) benchmark::DoNotOptimize(triangleDistortion(s, uv));
  perFace(state, s.triangleCount());
}

/// A mesh with its 20 charts cut to disks.
struct Prepared {
  std::shared_ptr<const Mesh> mesh;
  std::shared_ptr<const ChartSet> charts;

  explicit Prepared(const std::filesystem::path& file) : mesh(buildMesh(readMesh(file))) {
    SegmentInputs in;
    in.mesh = mesh;
    in.gaussArea = std::make_shared<GaussArea>(computeGaussArea(*mesh, 45));
    in.floodGraph = std::make_shared<FloodGraph>(buildFloodGraph(*mesh, *in.gaussArea, {}));
    const auto stepper = findSegmenter("t-flooding")->make(in, {});
    Progress progress;
    stepper->advance(StepUnit::Converged, 1, progress);
    charts = cutCharts(*mesh, *stepper->state(), {}, progress);
  }
};

void wholeMesh(benchmark::State& state, const std::string& file, UnwrapOptions::Boundary boundary) {
  static std::map<std::string, std::unique_ptr<Prepared>> made;
  std::unique_ptr<Prepared>& p = made[file];
  if (!p) p = std::make_unique<Prepared>(std::filesystem::path(CHARTFLOOD_MESHES) / file);
  UnwrapOptions options;
  options.boundary = boundary;
  for (auto _ : state) {
    Progress progress;
    benchmark::DoNotOptimize(unwrapCharts(*p->mesh, p->charts, options, progress));
  }
  perFace(state, p->mesh->triangleCount());
}

BENCHMARK(order)->Arg(2000)->Arg(7500)->Arg(20000)->Arg(53000)->Unit(benchmark::kMillisecond);
BENCHMARK(conformal)->Arg(2000)->Arg(7500)->Arg(20000)->Arg(53000)->Unit(benchmark::kMillisecond);
BENCHMARK(circle)->Arg(2000)->Arg(7500)->Arg(20000)->Arg(53000)->Unit(benchmark::kMillisecond);
BENCHMARK(free)->Arg(2000)->Arg(7500)->Arg(20000)->Arg(53000)->Unit(benchmark::kMillisecond);
BENCHMARK(stretch)->Arg(2000)->Arg(7500)->Arg(20000)->Arg(53000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace chartflood

int main(int argc, char** argv) {
  using chartflood::UnwrapOptions;
  // One thread unless asked: figures of one thread compare between machines.
  const char* threads = std::getenv("CHARTFLOOD_THREADS");
  chartflood::setThreadCount(threads != nullptr ? static_cast<unsigned>(std::atoi(threads)) : 1);
  for (const char* file : {"stanford-bunny.obj", "igea-151558.ply"}) {
    if (!std::filesystem::exists(std::filesystem::path(CHARTFLOOD_MESHES) / file)) continue;
    for (const auto boundary : {UnwrapOptions::Boundary::Circle, UnwrapOptions::Boundary::Free}) {
      const char* name = boundary == UnwrapOptions::Boundary::Free ? "free/" : "circle/";
      benchmark::RegisterBenchmark((std::string("unwrap/") + name + file).c_str(),
                                   [file, boundary](benchmark::State& state) {
                                     chartflood::wholeMesh(state, file, boundary);
                                   })
          ->Unit(benchmark::kMillisecond)
          ->UseRealTime();
    }
  }
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
