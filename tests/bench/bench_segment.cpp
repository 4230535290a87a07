// Time per face of every stage from faces to charts, on growing meshes. Run it on a quiet machine:
//   build/release/tests/bench_segment
// `per_face` is what to compare; ratios of one run say more than single figures.

#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <memory>
#include <new>
#include <string>
#include <utility>

#include <benchmark/benchmark.h>

#include "core/base/parallel.h"
#include "core/charts/chart_stats.h"
#include "core/flood/build_flood_graph.h"
#include "core/flood/flood.h"
#include "core/gauss/compute_gauss_area.h"
#include "core/model/build_mesh.h"
#include "core/segment/borders/border_moves.h"
#include "core/segment/borders/seam_cuts.h"
#include "core/segment/fast/coarse_graph.h"
#include "core/segment/fast/seam_band.h"
#include "core/segment/parts/flood_cursor.h"
#include "core/segment/parts/seeds.h"
#include "core/segment/registry.h"
#include "tests/bench/prepared_mesh.h"

namespace chartflood {
namespace {

/// How often memory was asked for so far. What a benchmark prepares for itself counts too: a share
/// of one iteration of many.
std::atomic<std::uint64_t> allocations{0};

constexpr std::size_t kAll = std::numeric_limits<std::size_t>::max();

PartShares equalWeights(const Mesh& mesh) {
  return {std::vector<double>(mesh.componentCount(), 1.0), {}};
}

/// A mesh with every stage before the measured one done.
struct Prepared {
  std::shared_ptr<const InputMesh> input;
  SegmentInputs in;
  FaceValues faceGauss;
  std::vector<Index> seeds;
  std::vector<double> offsets;
  std::shared_ptr<const Segmentation> flooded;

  explicit Prepared(std::shared_ptr<const InputMesh> mesh) : input(std::move(mesh)) {
    in.mesh = buildMesh(input);
    in.gaussArea = std::make_shared<GaussArea>(computeGaussArea(*in.mesh, 45));
    in.floodGraph = std::make_shared<FloodGraph>(buildFloodGraph(*in.mesh, *in.gaussArea, {}));
    faceGauss = faceGaussArea(*in.mesh, *in.gaussArea);
    Rng rng(1);
    seeds =
        placeSeeds(*in.mesh, effectiveChartCount(*in.mesh, 20), {}, equalWeights(*in.mesh), rng);
    offsets.assign(seeds.size(), 0);
    const auto stepper = findSegmenter("t-flooding")->make(in, {});
    Progress progress;
    stepper->advance(StepUnit::Flood, 10, progress);
    flooded = stepper->state();
  }
  double faces() const { return static_cast<double>(in.mesh->faceCount()); }
};

const Prepared& prepared(const std::string& name) { return preparedMesh<Prepared>(name); }

void perFace(benchmark::State& state, const Prepared& p) {
  state.counters["ns/face"] =
      benchmark::Counter(p.faces() * 1e-9, benchmark::Counter::kIsIterationInvariantRate |
                                               benchmark::Counter::kInvert);
  state.counters["faces"] = p.faces();
}

void glue(benchmark::State& state, const std::string& name) {
  const Prepared& p = prepared(name);
  for (auto _ : state) benchmark::DoNotOptimize(buildMesh(p.input));
  perFace(state, p);
}

void gaussArea(benchmark::State& state, const std::string& name) {
  const Prepared& p = prepared(name);
  for (auto _ : state) benchmark::DoNotOptimize(computeGaussArea(*p.in.mesh, 45));
  perFace(state, p);
}

void floodGraph(benchmark::State& state, const std::string& name) {
  const Prepared& p = prepared(name);
  for (auto _ : state) {
    benchmark::DoNotOptimize(buildFloodGraph(*p.in.mesh, *p.in.gaussArea, {}));
  }
  perFace(state, p);
}

void seeds(benchmark::State& state, const std::string& name) {
  const Prepared& p = prepared(name);
  for (auto _ : state) {
    Rng rng(1);
    benchmark::DoNotOptimize(placeSeeds(*p.in.mesh, 20, {}, equalWeights(*p.in.mesh), rng));
  }
  perFace(state, p);
}

void oneFlood(benchmark::State& state, const std::string& name) {
  const Prepared& p = prepared(name);
  const auto flood = makeFlood(*p.in.floodGraph, p.seeds.size());
  for (auto _ : state) {
    flood->start(p.seeds, p.offsets, true, nullptr);
    flood->advance(kAll, nullptr);
  }
  perFace(state, p);
  state.counters["pushes/face"] = static_cast<double>(flood->counts().pushes) / p.faces();
  state.counters["pops/face"] = static_cast<double>(flood->counts().pops) / p.faces();
}

/// There and back over a whole log.
void cursor(benchmark::State& state, const std::string& name) {
  const Prepared& p = prepared(name);
  const auto record = std::make_shared<FloodRecord>(p.in.mesh->faceCount());
  const auto flood = makeFlood(*p.in.floodGraph, p.seeds.size());
  flood->start(p.seeds, p.offsets, true, record);
  flood->advance(kAll, nullptr);
  FloodCursor cursor(std::make_shared<FloodMeasures>(p.in.mesh, p.in.gaussArea));
  for (auto _ : state) {
    cursor.go(record, record->size());
    cursor.go(record, 0);
  }
  perFace(state, p);
}

void reposition(benchmark::State& state, const std::string& name) {
  const Prepared& p = prepared(name);
  const auto flood = makeFlood(*p.in.floodGraph, p.seeds.size());
  flood->start(p.seeds, p.offsets, true, nullptr);
  flood->advance(kAll, nullptr);
  for (auto _ : state) benchmark::DoNotOptimize(flood->farthestFromBorder(p.seeds));
  perFace(state, p);
  state.counters["relaxations/face"] = static_cast<double>(flood->counts().relaxations) / p.faces();
}

void borderMoves(benchmark::State& state, const std::string& name) {
  const Prepared& p = prepared(name);
  for (auto _ : state) {
    BorderMoves moves(*p.in.mesh, *p.in.gaussArea, p.faceGauss, p.flooded->label,
                      p.flooded->chartCount, p.flooded->seeds, {.eta = p.in.floodGraph->eta});
    Progress progress;
    moves.run(progress);
    benchmark::DoNotOptimize(moves.moves());
  }
  perFace(state, p);
}

/// On clusters first, and on single faces throughout: the energies tell what the clusters cost.
template <bool kClusters>
void seamCuts(benchmark::State& state, const std::string& name) {
  const Prepared& p = prepared(name);
  double energy = 0;
  for (auto _ : state) {
    SeamCuts cuts(*p.in.mesh, *p.in.gaussArea, p.faceGauss, p.flooded->label, p.flooded->chartCount,
                  p.flooded->seeds, {.eta = p.in.floodGraph->eta, .clusters = kClusters});
    Progress progress;
    cuts.run(progress);
    energy = cuts.energy();
  }
  perFace(state, p);
  state.counters["energy"] = energy;
}

void chartFigures(benchmark::State& state, const std::string& name) {
  const Prepared& p = prepared(name);
  for (auto _ : state) benchmark::DoNotOptimize(measureCharts(*p.in.mesh, *p.flooded));
  perFace(state, p);
}

NodeGraphSource nodeSource(const Prepared& p) {
  return {*p.in.mesh, *p.in.gaussArea, p.faceGauss, *p.in.floodGraph};
}

void coarseGraph(benchmark::State& state, const std::string& name) {
  const Prepared& p = prepared(name);
  const std::size_t size = coarseClusterSize(p.in.mesh->faceCount(), p.seeds.size());
  for (auto _ : state) {
    const CoarseGraph coarse = makeCoarseGraph(nodeSource(p), clusterFaces(*p.in.mesh, {}, size));
    state.counters["clusters"] = static_cast<double>(coarse.nodeCount());
  }
  perFace(state, p);
}

/// Heap operations, and what the graph of nodes occupies.
void countNodes(benchmark::State& state, const Prepared& p, const NodeGraph& graph,
                const FloodCounts& counts) {
  const FloodGraph& g = graph.flood;
  const std::size_t bytes = graph.nodeOfFace.size() * sizeof(Index) +
                            g.arcs.size() * (sizeof(FloodArc) + 8) +
                            g.faceCount * (32 + sizeof(float) + 3 * sizeof(Index) + 8);
  state.counters["nodes/face"] = static_cast<double>(graph.nodeCount()) / p.faces();
  state.counters["pushes/face"] = static_cast<double>(counts.pushes) / p.faces();
  state.counters["pops/face"] = static_cast<double>(counts.pops) / p.faces();
  state.counters["bytes/face"] = static_cast<double>(bytes) / p.faces();
}

/// One round of the fast search on clusters: flood and reposition.
void coarseRound(benchmark::State& state, const std::string& name) {
  const Prepared& p = prepared(name);
  const std::size_t size = coarseClusterSize(p.in.mesh->faceCount(), p.seeds.size());
  const CoarseGraph coarse = makeCoarseGraph(nodeSource(p), clusterFaces(*p.in.mesh, {}, size));
  Rng rng(1);
  const std::vector<Index> seeds = placeCoarseSeeds(
      coarse, p.in.mesh->componentCount(), p.seeds.size(), {}, equalWeights(*p.in.mesh), rng);
  const auto flood = makeFlood(coarse.nodes.flood, seeds.size(), OfferRule::ShortestTimes);
  for (auto _ : state) {
    flood->start(seeds, p.offsets, true, nullptr);
    flood->advance(kAll, nullptr);
    benchmark::DoNotOptimize(flood->farthestFromBorder(seeds));
  }
  perFace(state, p);
  countNodes(state, p, coarse.nodes, flood->counts());
}

/// A coarse round as the band begins with it.
struct CoarseCharts {
  CoarseGraph graph;
  std::vector<Index> seeds, label;

  explicit CoarseCharts(const Prepared& p)
      : graph(makeCoarseGraph(nodeSource(p), clusterFaces(*p.in.mesh, {},
                                                          coarseClusterSize(p.in.mesh->faceCount(),
                                                                            p.seeds.size())))) {
    Rng rng(1);
    seeds = placeCoarseSeeds(graph, p.in.mesh->componentCount(), p.seeds.size(), {},
                             equalWeights(*p.in.mesh), rng);
    const auto flood = makeFlood(graph.nodes.flood, seeds.size(), OfferRule::ShortestTimes);
    flood->start(seeds, p.offsets, true, nullptr);
    flood->advance(kAll, nullptr);
    flood->copyLabels(label);
  }
  SeamBand band(const Prepared& p) const {
    return makeSeamBand(nodeSource(p), graph.nodes, label, seeds, 2);
  }
};

void seamBand(benchmark::State& state, const std::string& name) {
  const Prepared& p = prepared(name);
  const CoarseCharts coarse(p);
  for (auto _ : state) {
    const SeamBand band = coarse.band(p);
    state.counters["free/face"] = static_cast<double>(band.freeFaces) / p.faces();
  }
  perFace(state, p);
}

/// One round of the fast search around the seams.
void bandRound(benchmark::State& state, const std::string& name) {
  const Prepared& p = prepared(name);
  const SeamBand band = CoarseCharts(p).band(p);
  const auto flood = makeFlood(band.nodes.flood, band.seeds.size());
  for (auto _ : state) {
    flood->start(band.seeds, p.offsets, true, nullptr);
    flood->advance(kAll, nullptr);
  }
  perFace(state, p);
  countNodes(state, p, band.nodes, flood->counts());
}

template <const char* const& kMethod, RefineKind kRefine = RefineKind::Cuts,
          SearchKind kSearch = SearchKind::Literal>
void wholeSegmentation(benchmark::State& state, const std::string& name) {
  const Prepared& p = prepared(name);
  std::size_t rounds = 0;
  for (auto _ : state) {
    SegmentOptions options;
    options.record = false;
    options.search = kSearch;
    options.refine.kind = kRefine;
    const auto stepper = findSegmenter(kMethod)->make(p.in, options);
    Progress progress;
    stepper->advance(StepUnit::Converged, 1, progress);
    rounds = stepper->history().size();
  }
  perFace(state, p);
  state.counters["rounds"] = static_cast<double>(rounds);
}

constexpr const char* kTFlooding = "t-flooding";
constexpr const char* kVsa = "vsa";
constexpr const char* kMcgim = "mcgim";

void registerAll(const std::string& mesh) {
  using Stage = void (*)(benchmark::State&, const std::string&);
  const std::pair<const char*, Stage> stages[] = {
      {"glue", glue},
      {"gauss_area", gaussArea},
      {"flood_graph", floodGraph},
      {"seeds", seeds},
      {"flood", oneFlood},
      {"cursor", cursor},
      {"reposition", reposition},
      {"moves", borderMoves},
      {"cuts", seamCuts<true>},
      {"cuts_full", seamCuts<false>},
      {"figures", chartFigures},
      {"segment", wholeSegmentation<kTFlooding>},
      {"coarse_graph", coarseGraph},
      {"coarse_round", coarseRound},
      {"seam_band", seamBand},
      {"band_round", bandRound},
      {"segment_moves", wholeSegmentation<kTFlooding, RefineKind::Moves>},
      {"fast_moves", wholeSegmentation<kTFlooding, RefineKind::Moves, SearchKind::Fast>},
      {"vsa", wholeSegmentation<kVsa>},
      {"mcgim", wholeSegmentation<kMcgim>}};
  for (const auto& [name, stage] : stages) {
    if (stage == seamCuts<false> && mesh == "bumps/1000000") continue;  // takes minutes
    benchmark::RegisterBenchmark((std::string(name) + "/" + mesh).c_str(),
                                 [stage = stage, mesh](benchmark::State& s) {
                                   prepared(mesh);
                                   const std::uint64_t before = allocations;
                                   stage(s, mesh);
                                   s.counters["allocations"] =
                                       benchmark::Counter(static_cast<double>(allocations - before),
                                                          benchmark::Counter::kAvgIterations);
                                 })
        ->Unit(benchmark::kMillisecond);
  }
}

}  // namespace
}  // namespace chartflood

void* operator new(std::size_t size) {
  ++chartflood::allocations;
  if (void* const memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

int main(int argc, char** argv) {
  // One thread unless asked: figures of one thread compare between machines.
  const char* threads = std::getenv("CHARTFLOOD_THREADS");
  chartflood::setThreadCount(threads != nullptr ? static_cast<unsigned>(std::atoi(threads)) : 1);
  for (const char* mesh : {"bumps/20000", "bumps/150000", "bumps/1000000"}) {
    chartflood::registerAll(mesh);
  }
  for (const char* file : {"stanford-bunny.obj", "igea-151558.ply"}) {
    if (std::filesystem::exists(std::filesystem::path(CHARTFLOOD_MESHES) / file)) {
      chartflood::registerAll(file);
    }
  }
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
