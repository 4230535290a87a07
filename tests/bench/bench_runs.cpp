// Time of what begins or steers runs beyond one flood: charts from creases, several generator
// seeds, and edges painted by hand. Counts stand beside the times:
//   build/release/tests/bench_runs
// One thread unless CHARTFLOOD_THREADS says otherwise; the runs of best_of go side by side.

#include <cstdlib>
#include <memory>
#include <string>
#include <utility>

#include <benchmark/benchmark.h>

#include "core/base/parallel.h"
#include "core/charts/crease_share.h"
#include "core/flood/build_flood_graph.h"
#include "core/gauss/compute_gauss_area.h"
#include "core/model/build_mesh.h"
#include "core/segment/borders/hint_factors.h"
#include "core/segment/borders/seam_cuts.h"
#include "core/segment/creases/crease_regions.h"
#include "core/segment/creases/crease_start.h"
#include "core/segment/registry.h"
#include "core/session/pipeline/run_set.h"
#include "core/session/session.h"
#include "tests/bench/prepared_mesh.h"

namespace chartflood {
namespace {

constexpr Index kCharts = 20;

struct Prepared {
  SegmentInputs in;
  FaceValues faceGauss;
  std::shared_ptr<const Segmentation> flooded;  ///< ten rounds, borders as flooded

  explicit Prepared(std::shared_ptr<const InputMesh> input) {
    in.mesh = buildMesh(std::move(input));
    in.gaussArea = std::make_shared<GaussArea>(computeGaussArea(*in.mesh, 45));
    in.floodGraph = std::make_shared<FloodGraph>(buildFloodGraph(*in.mesh, *in.gaussArea, {}));
    faceGauss = faceGaussArea(*in.mesh, *in.gaussArea);
    const auto stepper = findSegmenter("t-flooding")->make(in, {});
    Progress progress;
    stepper->advance(StepUnit::Flood, 10, progress);
    flooded = stepper->state();
  }
};

const Prepared& prepared(const std::string& name) { return preparedMesh<Prepared>(name); }

void perFace(benchmark::State& state, const Prepared& p) {
  const double faces = static_cast<double>(p.in.mesh->faceCount());
  state.counters["ns/face"] = benchmark::Counter(
      faces * 1e-9, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  state.counters["faces"] = faces;
}

/// The parts between sharp edges, before any is joined or split.
void regions(benchmark::State& state, const std::string& name) {
  const Prepared& p = prepared(name);
  std::size_t count = 0;
  for (auto _ : state) count = creaseRegions(*p.in.mesh, *p.in.gaussArea).count;
  perFace(state, p);
  state.counters["regions"] = static_cast<double>(count);
  state.counters["divided"] = dividedByCreases(*p.in.mesh, *p.in.gaussArea) ? 1 : 0;
}

/// Charts from creases: without their borders refined, and to the end.
template <RefineKind kRefine>
void creaseStart(benchmark::State& state, const std::string& name) {
  const Prepared& p = prepared(name);
  std::shared_ptr<const Segmentation> made;
  for (auto _ : state) {
    SegmentOptions options;
    options.charts = kCharts;
    options.record = false;
    options.refine.kind = kRefine;
    const auto stepper = makeCreaseStart(p.in, options);
    Progress progress;
    stepper->advance(StepUnit::Converged, 1, progress);
    made = stepper->state();
  }
  perFace(state, p);
  state.counters["charts"] = static_cast<double>(made->chartCount);
  state.counters["crease_share"] = creaseShare(*p.in.mesh, *p.in.gaussArea, made->label);
}

/// Whole runs with charts laid flat, as --best-of compares them; the figures show what the seeds
/// are worth.
template <int kSeeds>
void bestOf(benchmark::State& state, const std::string& name) {
  const Prepared& p = prepared(name);
  Session session(Session::Worker::Inline);
  Document document;
  document.parameters.charts = kCharts;
  document.parameters.bestOf = kSeeds;
  session.setDocument(document, Session::Answer::Nothing);
  session.openMesh(p.in.mesh);
  for (auto _ : state) {
    session.resetSeeds();
    session.step(StepUnit::Converged);
  }
  perFace(state, p);
  state.counters["runs"] = kSeeds;
  const auto set = session.results()->seedRuns;
  if (!set) return;
  const Run& best = set->runs[set->chosen];
  state.counters["seams"] = best.seams;
  state.counters["seams_first"] = set->runs.front().seams;
  state.counters["spread"] = best.spread.value_or(0);
}

/// Hints at every so-many-th border edge of the flooded charts.
EdgeHints hintsOnBorders(const Prepared& p, std::size_t every, HintKind kind) {
  const Mesh& mesh = *p.in.mesh;
  EdgeHints hints;
  std::size_t borders = 0;
  for (Index s = 0; s < mesh.opposite().size(); ++s) {
    const Index other = mesh.opposite()[s];
    if (other == kNone || other < s) continue;
    if (p.flooded->label[mesh.faceOf(s / 3)] == p.flooded->label[mesh.faceOf(other / 3)]) continue;
    if (borders++ % every != 0) continue;
    const Index from = mesh.inputVertex(mesh.sideStart(s)), to = mesh.inputVertex(mesh.sideEnd(s));
    addHint(hints, from, to, kind);
  }
  return hints;
}

/// Looking the hints up for every side of the mesh.
template <std::size_t kEvery>
void hintLookUp(benchmark::State& state, const std::string& name) {
  const Prepared& p = prepared(name);
  const EdgeHints hints = hintsOnBorders(p, kEvery, HintKind::Never);
  for (auto _ : state) benchmark::DoNotOptimize(hintFactors(*p.in.mesh, hints));
  perFace(state, p);
  state.counters["hints"] = static_cast<double>(hints.size());
}

/// Edges with hints between two charts.
std::size_t bordersOn(const Prepared& p, std::span<const Index> label,
                      const std::vector<double>* factor) {
  const Mesh& mesh = *p.in.mesh;
  std::size_t count = 0;
  for (Index s = 0; factor != nullptr && s < mesh.opposite().size(); ++s) {
    const Index other = mesh.opposite()[s];
    if (other == kNone || other < s || (*factor)[s] == 1) continue;
    count += label[mesh.faceOf(s / 3)] != label[mesh.faceOf(other / 3)];
  }
  return count;
}

enum class Hinted { None, Cut, Never };

/// Seam cuts with a hint at every third border edge, and without for comparison.
template <Hinted kHinted>
void hintedCuts(benchmark::State& state, const std::string& name) {
  const Prepared& p = prepared(name);
  EdgeHints hints;
  if (kHinted != Hinted::None) {
    hints = hintsOnBorders(p, 3, kHinted == Hinted::Cut ? HintKind::Cut : HintKind::Never);
  }
  const auto factor = hintFactors(*p.in.mesh, hints);
  SeamCuts::Options options{.eta = p.in.floodGraph->eta};
  if (factor) options.sideFactor = *factor;
  std::size_t after = 0, steps = 0;
  for (auto _ : state) {
    SeamCuts cuts(*p.in.mesh, *p.in.gaussArea, p.faceGauss, p.flooded->label, p.flooded->chartCount,
                  p.flooded->seeds, options);
    Progress progress;
    cuts.run(progress);
    after = bordersOn(p, cuts.labels(), factor.get());
    steps = cuts.record().steps.size();
  }
  perFace(state, p);
  state.counters["hints"] = static_cast<double>(hints.size());
  state.counters["borders_on_hints"] = static_cast<double>(after);
  state.counters["steps"] = static_cast<double>(steps);
}

using Stage = void (*)(benchmark::State&, const std::string&);

void registerOn(const std::string& mesh, std::initializer_list<std::pair<const char*, Stage>> all) {
  if (mesh.find('/') == std::string::npos &&
      !std::filesystem::exists(std::filesystem::path(CHARTFLOOD_MESHES) / mesh)) {
    return;
  }
  for (const auto& [name, stage] : all) {
    benchmark::RegisterBenchmark((std::string(name) + "/" + mesh).c_str(),
                                 [stage = stage, mesh](benchmark::State& s) { stage(s, mesh); })
        ->Unit(benchmark::kMillisecond)
        ->MeasureProcessCPUTime();
  }
}

}  // namespace
}  // namespace chartflood

int main(int argc, char** argv) {
  using namespace chartflood;
  const char* threads = std::getenv("CHARTFLOOD_THREADS");
  setThreadCount(threads != nullptr ? static_cast<unsigned>(std::atoi(threads)) : 1);
  for (const char* mesh : {"gear/10000", "gear/100000", "fandisk.obj", "casting.off"}) {
    registerOn(mesh, {{"crease_regions", regions},
                      {"crease_start", creaseStart<RefineKind::None>},
                      {"crease_charts", creaseStart<RefineKind::Cuts>}});
  }
  for (const char* mesh : {"bumps/20000", "fandisk.obj", "rocker-arm.obj", "stanford-bunny.obj"}) {
    registerOn(mesh, {{"best_of_1", bestOf<1>}, {"best_of_3", bestOf<3>}});
  }
  for (const char* mesh : {"bumps/20000", "bumps/150000", "stanford-bunny.obj"}) {
    registerOn(mesh, {{"hint_factors_few", hintLookUp<100>},
                      {"hint_factors_many", hintLookUp<1>},
                      {"cuts_without_hints", hintedCuts<Hinted::None>},
                      {"cuts_with_cut", hintedCuts<Hinted::Cut>},
                      {"cuts_with_never", hintedCuts<Hinted::Never>}});
  }
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
