// Time from a change of a parameter to the charts that it makes, as a slider asks for them while it
// is dragged. Run it on a quiet machine:
//   build/release/tests/bench_session
// The worker has a thread of its own, as in the window; the time ends when all of the new flood and
// its charts can be seen.

#include <chrono>
#include <filesystem>
#include <thread>

#include <benchmark/benchmark.h>

#include "core/model/build_mesh.h"
#include "core/session/session.h"
#include "tests/bench/prepared_mesh.h"

namespace chartflood {
namespace {

using Clock = std::chrono::steady_clock;

/// Moves a parameter to one more value.
using Change = void (*)(Parameters&, int);

constexpr std::pair<const char*, Change> kChanges[] = {
    {"p", [](Parameters& p, int i) { p.speedPower = 1.05 + 0.05 * i; }},
    {"epsilon", [](Parameters& p, int i) { p.speedEpsilon = 0.01 + 0.01 * i; }},
    {"beta", [](Parameters& p, int i) { p.offsetDamping = 0.32 + 0.02 * i; }},
    {"K", [](Parameters& p, int i) { p.charts = 21 + i; }},
    {"T_a", [](Parameters& p, int i) { p.sharpAngle = 46 + i; }},
};

void rest() { std::this_thread::sleep_for(std::chrono::microseconds(200)); }

bool shows(const Results& results, const Parameters& parameters) {
  return results.parameters == parameters && !results.stale && results.segmentation &&
         results.segmentation->complete;
}

void slide(benchmark::State& state, const std::string& name, Change change) {
  Session session(Session::Worker::Threaded);
  session.openMesh(buildMesh(meshNamed(name)));
  session.step(StepUnit::Converged);
  session.waitIdle();
  int moved = 0;
  for (auto _ : state) {
    Document document = session.document();
    change(document.parameters, ++moved % 20);
    const Clock::time_point start = Clock::now();
    session.setDocument(document);
    while (!shows(*session.results(), document.parameters)) rest();
    state.SetIterationTime(std::chrono::duration<double>(Clock::now() - start).count());
    session.waitIdle();
  }
}

void registerOn(const std::string& mesh) {
  if (mesh.find('/') == std::string::npos &&
      !std::filesystem::exists(std::filesystem::path(CHARTFLOOD_MESHES) / mesh)) {
    return;
  }
  for (const auto& [name, change] : kChanges) {
    benchmark::RegisterBenchmark(
        (std::string(name) + "/" + mesh).c_str(),
        [change = change, mesh](benchmark::State& state) { slide(state, mesh, change); })
        ->Unit(benchmark::kMillisecond)
        ->UseManualTime()
        ->Iterations(15);
  }
}

}  // namespace
}  // namespace chartflood

int main(int argc, char** argv) {
  for (const char* mesh : {"bumps/150000", "igea-151558.ply", "bumps/1000000"}) {
    chartflood::registerOn(mesh);
  }
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
