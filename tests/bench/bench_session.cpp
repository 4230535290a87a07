// Time from a change of a value to what it makes: the charts of a preview, as a slider asks for
// them while it is dragged, its texture, and the settled charts with theirs. Run it on a quiet
// machine:
//   build/release/tests/bench_session [--benchmark_filter=igea]
// The worker has a thread of its own, as in the window. The time of a row is the preview's charts;
// the counters are medians and 95th per cents in milliseconds.

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include <benchmark/benchmark.h>

#include "core/model/build_mesh.h"
#include "core/session/session.h"
#include "tests/bench/prepared_mesh.h"

namespace chartflood {
namespace {

using Clock = std::chrono::steady_clock;

/// Moves a value to the next of a series.
using Change = void (*)(Document&, const Results&, int);

constexpr std::pair<const char*, Change> kChanges[] = {
    {"p", [](Document& d, const Results&, int i) { d.parameters.speedPower = 1.05 + 0.05 * i; }},
    {"epsilon",
     [](Document& d, const Results&, int i) { d.parameters.speedEpsilon = 0.01 + 0.01 * i; }},
    {"beta",
     [](Document& d, const Results&, int i) { d.parameters.offsetDamping = 0.32 + 0.02 * i; }},
    {"K", [](Document& d, const Results&, int i) { d.parameters.charts = 21 + i; }},
    {"T_a", [](Document& d, const Results&, int i) { d.parameters.sharpAngle = 46 + i; }},
    {"seed",
     [](Document& d, const Results& results, int i) {
       if (d.seeds.empty()) {
         for (const Index face : results.start.seeds) d.seeds.push_back({face});
       }
       d.seeds[0].face = static_cast<Index>((37 * i) % results.mesh->faceCount());
     }},
    {"crease-weight",
     [](Document& d, const Results&, int i) { d.parameters.creaseWeight = 0.31 + 0.02 * i; }},
    {"margin", [](Document& d, const Results&, int i) { d.parameters.margin = 9 + i; }},
};

void rest() { std::this_thread::sleep_for(std::chrono::microseconds(200)); }

double milliseconds(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

bool shows(const Results& results, const Document& document) {
  return results.parameters == document.parameters && results.placed == document.seeds &&
         !results.stale && results.segmentation && results.segmentation->complete;
}

/// Median and 95th per cent as counters.
void count(benchmark::State& state, const std::string& name, std::vector<double> values) {
  std::sort(values.begin(), values.end());
  state.counters[name] = values[values.size() / 2];
  state.counters[name + "_p95"] = values[values.size() * 95 / 100];
}

void slide(benchmark::State& state, const std::string& name, Change change) {
  Session session(Session::Worker::Threaded);
  session.setAutoUnwrap(true);
  session.openMesh(buildMesh(meshNamed(name)));
  session.setDocument({}, Session::Answer::Finished);
  session.waitIdle();
  std::vector<double> charts, texture, settled;
  int moved = 0;
  for (auto _ : state) {
    Document document = session.document();
    change(document, *session.results(), ++moved);
    Clock::time_point start = Clock::now();
    session.setDocument(document, Session::Answer::Sketch);
    while (!shows(*session.results(), document)) rest();
    charts.push_back(milliseconds(start));
    state.SetIterationTime(charts.back() / 1000);
    while (!session.results()->flat) rest();
    texture.push_back(milliseconds(start));
    session.waitIdle();
    start = Clock::now();
    session.setDocument(document, Session::Answer::Finished);
    session.waitIdle();
    settled.push_back(milliseconds(start));
  }
  count(state, "texture", texture);
  count(state, "settled", settled);
  count(state, "charts", charts);
}

void registerOn(const std::string& mesh, int moves) {
  if (mesh.find('/') == std::string::npos &&
      !std::filesystem::exists(std::filesystem::path(CHARTFLOOD_MESHES) / mesh)) {
    return;
  }
  for (const auto& [name, change] : kChanges) {
    benchmark::RegisterBenchmark(
        (mesh + "/" + name).c_str(),
        [change = change, mesh](benchmark::State& state) { slide(state, mesh, change); })
        ->Unit(benchmark::kMillisecond)
        ->UseManualTime()
        ->Iterations(moves);
  }
}

}  // namespace
}  // namespace chartflood

int main(int argc, char** argv) {
  const std::pair<const char*, int> meshes[] = {{"rocker-arm.obj", 15},
                                                {"stanford-bunny.obj", 15},
                                                {"igea-151558.ply", 11},
                                                {"bumps/1000000", 5}};
  for (const auto& [mesh, moves] : meshes) chartflood::registerOn(mesh, moves);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
