// Time of a frame without a window: 1280 x 800 pixels, read back not included. Software drivers
// work on several threads, so the time of the whole process is shown beside the wall's.

#include <chrono>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include <benchmark/benchmark.h>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include "core/model/build_mesh.h"
#include "render/gl/framebuffer.h"
#include "render/gl/offscreen_context.h"
#include "render/passes/renderer.h"
#include "render/scene/simple_surface.h"

namespace chartflood {
namespace {

/// A torus of about `triangles` triangles.
std::shared_ptr<const Mesh> torus(std::size_t triangles) {
  const auto tube = static_cast<Index>(std::sqrt(static_cast<double>(triangles) / 6));
  const Index ring = 3 * tube;
  auto input = std::make_shared<InputMesh>();
  input->file = "torus";
  for (Index i = 0; i < ring; ++i) {
    for (Index j = 0; j < tube; ++j) {
      const double u = 2 * glm::pi<double>() * i / ring, v = 2 * glm::pi<double>() * j / tube;
      const double r = 1 + 0.4 * std::cos(v);
      input->positions.emplace_back(r * std::cos(u), 0.4 * std::sin(v), -r * std::sin(u));
      const Index i1 = (i + 1) % ring, j1 = (j + 1) % tube;
      for (const Index corner : {i * tube + j, i1 * tube + j, i1 * tube + j1, i * tube + j,
                                 i1 * tube + j1, i * tube + j1}) {
        input->corners.push_back(corner);
      }
    }
  }
  return buildMesh(input);
}

CornerNormals torusNormals(const Mesh& mesh) {
  CornerNormals normals;
  for (const auto& triangle : mesh.triangles()) {
    for (const Index vertex : triangle) {
      const glm::dvec3& p = mesh.positions()[vertex];
      const glm::dvec3 onRing = glm::normalize(glm::dvec3(p.x, 0, p.z)) / mesh.scale();
      normals.normal.emplace_back(glm::normalize(p - onRing));
    }
  }
  return normals;
}

Segmentation wedges(const Mesh& mesh) {
  constexpr std::size_t kCharts = 20;
  Segmentation segmentation;
  segmentation.chartCount = kCharts;
  segmentation.complete = true;
  for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
    segmentation.label.push_back(static_cast<Index>(f * kCharts / mesh.faceCount()));
  }
  return segmentation;
}

/// Texture places of the wedges: each a strip of its own, unrolled.
std::vector<glm::vec2> wedgeUv(const Mesh& mesh, const Segmentation& segmentation) {
  std::vector<glm::vec2> uv;
  const auto charts = static_cast<double>(segmentation.chartCount);
  for (Index t = 0; t < mesh.triangleCount(); ++t) {
    const double chart = segmentation.label[t];
    for (const Index v : mesh.triangles()[t]) {
      const glm::dvec3 p = mesh.positions()[v] * mesh.scale() + mesh.center();
      const double u = std::atan2(p.y, std::hypot(p.x, p.z) - 1) / (2 * glm::pi<double>()) + 0.5;
      double w = std::atan2(-p.z, p.x) / (2 * glm::pi<double>());
      if (w < 0) w += 1;
      const double strip = w * charts - chart;
      const double inside = strip > charts / 2 ? 0.0 : std::fmin(strip, 1.0);
      uv.emplace_back(u, (chart + 0.02 + 0.96 * inside) / charts);
    }
  }
  return uv;
}

std::shared_ptr<const UvLayout> wedgeLayout(const Mesh& mesh, const Segmentation& segmentation) {
  return std::make_shared<const UvLayout>(uvLayout(mesh, wedgeUv(mesh, segmentation)));
}

render::Scene sceneOf(const std::shared_ptr<const Mesh>& mesh) {
  render::Scene scene;
  scene.source.mesh = mesh;
  return scene;
}

render::Scene sceneOf(const std::shared_ptr<const Mesh>& mesh, const Segmentation& segmentation) {
  render::Scene scene = sceneOf(mesh);
  scene.source.segmentation = std::make_shared<const Segmentation>(segmentation);
  return scene;
}

enum Look { kCharts, kWire, kPlain, kSquares, kNumbers, kCircles };

void setLook(RenderSettings& settings, long look) {
  settings.colorMode = look == kPlain     ? ColorMode::Shaded
                       : look >= kSquares ? ColorMode::Checkerboard
                                          : ColorMode::Charts;
  settings.edges = look == kWire;
  if (look >= kSquares) settings.checkerKind = static_cast<CheckerKind>(look - kSquares);
}

/// Arguments: triangles, samples a pixel, 0 charts / 1 charts with mesh edges / 2 plain / 3 to 5
/// the checkerboard of squares, numbers, circles.
void frame(benchmark::State& state) {
  const auto context = gl::createOffscreenContext();
  const gl::CurrentScope current(*context);
  const auto mesh = torus(static_cast<std::size_t>(state.range(0)));
  const CornerNormals normals = torusNormals(*mesh);
  const Segmentation segmentation = wedges(*mesh);
  Renderer renderer;
  render::Scene scene = sceneOf(mesh, segmentation);
  scene.vertices = surfaceVertices(*mesh, &normals);
  Camera camera;
  camera.look(StandardView::Oblique);
  camera.frame(mesh->positions(), 1.6);
  RenderSettings settings;
  setLook(settings, state.range(2));
  if (state.range(2) >= kSquares) scene.source.layout = wedgeLayout(*mesh, segmentation);
  renderer.show(scene);
  const gl::Framebuffer target(1280, 800, static_cast<int>(state.range(1)));
  renderer.draw(target, camera, settings);  // compiles the shaders
  glFinish();
  for (auto _ : state) {
    camera.orbit(0.01, 0);
    renderer.draw(target, camera, settings);
    glFinish();
  }
  state.SetLabel(context->backend());
}
BENCHMARK(frame)
    ->ArgNames({"triangles", "samples", "look"})
    ->ArgsProduct({{150'000, 1'000'000}, {1, 4}, {0, 1, 2, 3, 4, 5}})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

/// Fewer triangles made, then a picture of them in a view of the window without smoothing.
void simpleFrame(benchmark::State& state) {
  const auto context = gl::createOffscreenContext();
  const gl::CurrentScope current(*context);
  const auto mesh = torus(static_cast<std::size_t>(state.range(0)));
  const CornerNormals normals = torusNormals(*mesh);
  const auto vertices = surfaceVertices(*mesh, &normals);
  Renderer renderer;
  render::Scene scene = sceneOf(mesh);
  scene.vertices = vertices;
  renderer.show(scene);
  const auto start = std::chrono::steady_clock::now();
  scene.simple = simpleSurface(*mesh, *vertices, nullptr, static_cast<std::size_t>(state.range(1)));
  renderer.show(scene);
  state.counters["made_ms"] =
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  Camera camera;
  camera.look(StandardView::Oblique);
  camera.frame(mesh->positions(), 0.92);
  const gl::Framebuffer target(580, 629, 1);
  const auto draw = [&] {
    renderer.beginDrawing(target, camera, {}, PicturePart::whole(580, 629), SurfaceForm::Simple);
    renderer.continueDrawing(std::numeric_limits<double>::infinity());
    glFinish();
  };
  draw();  // compiles the shaders
  for (auto _ : state) {
    camera.orbit(0.01, 0);
    draw();
  }
}
BENCHMARK(simpleFrame)
    ->ArgNames({"triangles", "wanted"})
    ->ArgsProduct({{150'000, 1'000'000}, {30'000, 60'000, 120'000}})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

/// The texture in a pane of the window. Arguments as for frame().
void uvFrame(benchmark::State& state) {
  const auto context = gl::createOffscreenContext();
  const gl::CurrentScope current(*context);
  const auto mesh = torus(static_cast<std::size_t>(state.range(0)));
  const Segmentation segmentation = wedges(*mesh);
  Renderer renderer;
  render::Scene scene = sceneOf(mesh, segmentation);
  scene.source.layout = wedgeLayout(*mesh, segmentation);
  renderer.show(scene);
  RenderSettings settings;
  settings.numbers = true;
  setLook(settings, state.range(2));
  const gl::Framebuffer target(500, 600, static_cast<int>(state.range(1)));
  UvCamera camera;
  renderer.drawUv(target, camera, settings, {});  // compiles the shaders
  glFinish();
  for (auto _ : state) {
    camera.pan({0, 0}, {0.5, 0}, {500, 600});
    renderer.drawUv(target, camera, settings, {});
    glFinish();
  }
  state.SetLabel(context->backend());
}
BENCHMARK(uvFrame)
    ->ArgNames({"triangles", "samples", "look"})
    ->ArgsProduct({{150'000, 1'000'000}, {1, 4}, {0, 3}})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

void pickUv(benchmark::State& state) {
  const auto context = gl::createOffscreenContext();
  const gl::CurrentScope current(*context);
  const auto mesh = torus(static_cast<std::size_t>(state.range(0)));
  const Segmentation segmentation = wedges(*mesh);
  Renderer renderer;
  render::Scene scene = sceneOf(mesh, segmentation);
  scene.source.layout = wedgeLayout(*mesh, segmentation);
  renderer.show(scene);
  for (auto _ : state) benchmark::DoNotOptimize(renderer.pickUv({}, 500, 600, 200, 300).triangle);
}
BENCHMARK(pickUv)
    ->ArgName("triangles")
    ->Arg(150'000)
    ->Arg(1'000'000)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

/// Islands, scales and outlines, then the upload of the parted vertices.
void layOut(benchmark::State& state) {
  const auto context = gl::createOffscreenContext();
  const gl::CurrentScope current(*context);
  const auto mesh = torus(static_cast<std::size_t>(state.range(0)));
  const std::vector<glm::vec2> uv = wedgeUv(*mesh, wedges(*mesh));
  Renderer renderer;
  render::Scene scene = sceneOf(mesh);
  renderer.show(scene);
  double uploading = 0;
  for (auto _ : state) {
    auto layout = std::make_shared<const UvLayout>(uvLayout(*mesh, uv));
    const auto start = std::chrono::steady_clock::now();
    scene.source.layout = std::move(layout);
    renderer.show(scene);
    glFinish();
    uploading +=
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  }
  state.counters["upload_ms"] = uploading / static_cast<double>(state.iterations());
}
BENCHMARK(layOut)
    ->ArgName("triangles")
    ->Arg(150'000)
    ->Arg(1'000'000)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

void upload(benchmark::State& state) {
  const auto context = gl::createOffscreenContext();
  const gl::CurrentScope current(*context);
  const auto mesh = torus(static_cast<std::size_t>(state.range(0)));
  const CornerNormals normals = torusNormals(*mesh);
  Renderer renderer;
  for (auto _ : state) {
    renderer.show({});
    render::Scene scene = sceneOf(mesh);
    scene.vertices = surfaceVertices(*mesh, &normals);
    renderer.show(scene);
    glFinish();
  }
}
BENCHMARK(upload)
    ->ArgName("triangles")
    ->Arg(150'000)
    ->Arg(1'000'000)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

/// A hundred updates over a whole flood, as when it is watched.
void followFlood(benchmark::State& state) {
  const auto context = gl::createOffscreenContext();
  const gl::CurrentScope current(*context);
  const auto mesh = torus(static_cast<std::size_t>(state.range(0)));
  Renderer renderer;
  render::Scene scene = sceneOf(mesh);
  const std::size_t faces = mesh->faceCount();
  for (auto _ : state) {
    const auto record = std::make_shared<FloodRecord>(faces);
    scene.source.record = record;
    for (std::size_t step = 0; step < 100; ++step) {
      for (std::size_t f = step * faces / 100; f < (step + 1) * faces / 100; ++f) {
        record->append(static_cast<Index>(f % 20 * (faces / 20) + f / 20 % (faces / 20)),
                       static_cast<Index>(f % 20), static_cast<float>(f));
      }
      record->publish();
      scene.source.recorded = record->size();
      renderer.show(scene);
    }
  }
}
BENCHMARK(followFlood)
    ->ArgName("triangles")
    ->Arg(1'000'000)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

}  // namespace
}  // namespace chartflood

BENCHMARK_MAIN();
