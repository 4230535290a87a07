/// How fast readers and writers are, in bytes of the file per second, on a sample of a million
/// triangles.

#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <unistd.h>
#include <utility>
#include <vector>

#include <benchmark/benchmark.h>

#include "core/charts/chart_surface.h"
#include "core/io/read/read_obj.h"
#include "core/io/read/read_off.h"
#include "core/io/read/read_ply.h"
#include "core/io/read/read_stl.h"
#include "core/io/read_mesh.h"
#include "core/io/write/write_seams.h"
#include "core/io/write/write_uv_svg.h"
#include "core/io/write_mesh.h"
#include "core/model/build_mesh.h"
#include "core/samples/samples.h"

namespace chartflood {
namespace {

const InputMesh& sample() {
  static const auto mesh = makeSample("torus", 1'000'000);
  return *mesh;
}

template <class T>
void append(std::string& bytes, T value) {
  const std::size_t old = bytes.size();
  bytes.resize(old + sizeof value);
  std::memcpy(bytes.data() + old, &value, sizeof value);
}

void appendText(std::string& text, const char* format, double x, double y, double z) {
  char line[128];
  text.append(line, static_cast<std::size_t>(std::snprintf(line, sizeof line, format, x, y, z)));
}

/// "KEYWORD x y z" for each vertex, then "KEYWORD a b c" for each face, counted from `first`.
std::string textRows(const std::string& vertex, const std::string& face, unsigned first,
                     const char* digits = "%.6f %.6f %.6f\n") {
  std::string text;
  for (const glm::dvec3& p : sample().positions) {
    text += vertex;
    appendText(text, digits, p.x, p.y, p.z);
  }
  for (std::size_t f = 0; f < sample().faceCount(); ++f) {
    const auto corners = sample().face(f);
    text += face;
    appendText(text, "%.0f %.0f %.0f\n", corners[0] + first, corners[1] + first,
               corners[2] + first);
  }
  return text;
}

std::string plyHeader(const char* format) {
  return "ply\nformat " + std::string(format) + " 1.0\nelement vertex " +
         std::to_string(sample().positions.size()) +
         "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
         std::to_string(sample().faceCount()) +
         "\nproperty list uchar int vertex_indices\nend_header\n";
}

std::string binaryPly() {
  std::string bytes = plyHeader("binary_little_endian");
  for (const glm::dvec3& p : sample().positions) {
    for (int axis = 0; axis < 3; ++axis) append(bytes, static_cast<float>(p[axis]));
  }
  for (std::size_t f = 0; f < sample().faceCount(); ++f) {
    append(bytes, std::uint8_t{3});
    for (const Index v : sample().face(f)) append(bytes, v);
  }
  return bytes;
}

std::string binaryStl() {
  std::string bytes(80, ' ');
  append(bytes, static_cast<std::uint32_t>(sample().faceCount()));
  for (std::size_t f = 0; f < sample().faceCount(); ++f) {
    bytes.append(12, '\0');
    for (const Index v : sample().face(f)) {
      for (int axis = 0; axis < 3; ++axis) {
        append(bytes, static_cast<float>(sample().positions[v][axis]));
      }
    }
    bytes.append(2, '\0');
  }
  return bytes;
}

void measure(benchmark::State& state, InputMesh (*reader)(const Source&),
             const std::string& bytes) {
  const Source source{bytes, "benchmark"};
  for (auto _ : state) {
    const InputMesh mesh = reader(source);
    benchmark::DoNotOptimize(mesh.corners.data());
  }
  const auto rounds = static_cast<std::int64_t>(state.iterations());
  state.SetBytesProcessed(rounds * static_cast<std::int64_t>(bytes.size()));
  state.SetItemsProcessed(rounds * static_cast<std::int64_t>(sample().faceCount()));
}

void readObjWithSixDigits(benchmark::State& state) {
  measure(state, readObj, textRows("v ", "f ", 1));
}
void readObjWithSeventeenDigits(benchmark::State& state) {
  measure(state, readObj, textRows("v ", "f ", 1, "%.17g %.17g %.17g\n"));
}
void readOffText(benchmark::State& state) {
  const std::string counts = std::to_string(sample().positions.size()) + " " +
                             std::to_string(sample().faceCount()) + " 0\n";
  measure(state, readOff, "OFF\n" + counts + textRows("", "3 ", 0));
}
void readPlyText(benchmark::State& state) {
  measure(state, readPly, plyHeader("ascii") + textRows("", "3 ", 0));
}
void readPlyBinary(benchmark::State& state) { measure(state, readPly, binaryPly()); }
void readStlBinary(benchmark::State& state) { measure(state, readStl, binaryStl()); }

/// With opening the file and copying it into memory (it is in the system's cache).
void readPlyFile(benchmark::State& state) {
  const std::filesystem::path file = std::filesystem::temp_directory_path() /
                                     ("chartflood-bench-" + std::to_string(::getpid()) + ".ply");
  const std::string bytes = binaryPly();
  std::ofstream(file, std::ios::binary).write(bytes.data(), static_cast<long>(bytes.size()));
  for (auto _ : state) benchmark::DoNotOptimize(readMesh(file));
  state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations()) *
                          static_cast<std::int64_t>(bytes.size()));
  std::filesystem::remove(file);
}

/// The sample in 100 charts of equally many faces in a row, with any texture coordinates.
struct ChartedSample {
  std::shared_ptr<const Mesh> mesh = buildMesh(makeSample("torus", 1'000'000));
  std::vector<Index> label;
  ChartSet charts;
  Atlas atlas;

  ChartedSample() {
    for (std::size_t f = 0; f < mesh->faceCount(); ++f) {
      label.push_back(static_cast<Index>(100 * f / mesh->faceCount()));
    }
    for (ChartSurface& surface : extractCharts(*mesh, label, 100)) {
      std::vector<glm::dvec2>& uv = atlas.uv.emplace_back();
      for (const glm::dvec3& p : surface.positions) {
        uv.emplace_back(glm::dvec2(p.x + 0.1 * p.z, p.y) + 0.5);
      }
      CutChart chart;
      chart.surface = std::move(surface);
      charts.charts.push_back(std::move(chart));
    }
  }
  ChartedMesh view() const { return {*mesh, label, charts, atlas}; }
};

template <class Write>
void measureWriter(benchmark::State& state, const Write& write) {
  static const ChartedSample sample;
  std::size_t size = 0;
  for (auto _ : state) {
    const std::string bytes = write(sample.view());
    size = bytes.size();
    benchmark::DoNotOptimize(bytes.data());
  }
  const auto rounds = static_cast<std::int64_t>(state.iterations());
  state.SetBytesProcessed(rounds * static_cast<std::int64_t>(size));
  state.SetItemsProcessed(rounds * static_cast<std::int64_t>(sample.mesh->faceCount()));
}

void writeObj(benchmark::State& state) {
  measureWriter(state, [](const ChartedMesh& m) { return objText(m); });
}
void writePlySplit(benchmark::State& state) {
  measureWriter(state, [](const ChartedMesh& m) { return plyBytes(m); });
}
void writePlyAsInput(benchmark::State& state) {
  measureWriter(state, [](const ChartedMesh& m) { return plyBytes(m, {PlyVertices::AsInput}); });
}
void writeGlb(benchmark::State& state) {
  measureWriter(state, [](const ChartedMesh& m) { return glbBytes(m); });
}
void writeSeams(benchmark::State& state) {
  measureWriter(state, [](const ChartedMesh& m) { return seamsText(m); });
}
void writeUvSvg(benchmark::State& state) {
  measureWriter(state, [](const ChartedMesh& m) { return uvSvgText(m); });
}

BENCHMARK(readObjWithSixDigits)->Unit(benchmark::kMillisecond);
BENCHMARK(readObjWithSeventeenDigits)->Unit(benchmark::kMillisecond);
BENCHMARK(readOffText)->Unit(benchmark::kMillisecond);
BENCHMARK(readPlyText)->Unit(benchmark::kMillisecond);
BENCHMARK(readPlyBinary)->Unit(benchmark::kMillisecond);
BENCHMARK(readStlBinary)->Unit(benchmark::kMillisecond);
BENCHMARK(readPlyFile)->Unit(benchmark::kMillisecond);
BENCHMARK(writeObj)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(writePlySplit)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(writePlyAsInput)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(writeGlb)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(writeSeams)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(writeUvSvg)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace chartflood

BENCHMARK_MAIN();
