#include "app/cli/picture.h"

#include <algorithm>
#include <filesystem>

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include "app/cli/camera_options.h"
#include "app/host/film/film_frame.h"
#include "app/host/insight/problem_marks.h"
#include "app/host/insight/problems.h"
#include "core/gauss/sector_normals.h"
#include "render/gl/offscreen_context.h"
#include "render/passes/offscreen_render.h"
#include "render/passes/renderer.h"
#include "render/scene/corner_uv.h"

namespace chartflood {

namespace {

/// Lines and letters are made for a picture of this height and grow with it.
constexpr float kUsualSide = 960;

std::vector<SeedMark> seedMarks(const Results& results) {
  std::vector<SeedMark> marks;
  const Segmentation& segmentation = *results.segmentation;
  const std::vector<Index> locked = lockedFaces(results.placed);
  for (std::size_t c = 0; c < segmentation.seeds.size(); ++c) {
    const Index face = segmentation.seeds[c];
    const bool isLocked = std::find(locked.begin(), locked.end(), face) != locked.end();
    marks.push_back({face, static_cast<Index>(c), false, isLocked});
  }
  return marks;
}

/// What a picture shows beside the model and its charts. The rest is not worked out at all: on a
/// million triangles it takes longer than drawing.
struct Needs {
  bool gauss = false, flood = false, texture = false;
};

Needs needsOf(const Results& results, const PictureOptions& options, bool inTexture) {
  const RenderSettings& settings = options.settings;
  const ModeNeed mode = colorModeInfo(settings.colorMode).needs;
  Needs needs;
  needs.gauss = settings.sharpEdges || mode == ModeNeed::GaussArea;
  needs.flood = settings.playhead || options.floodFilm > 0 || mode == ModeNeed::Flood ||
                !results.segmentation->complete;
  // Marks lie in the texture, too.
  needs.texture = inTexture || options.view != PictureOptions::View::Model ||
                  mode == ModeNeed::Texture || settings.problems;
  return needs;
}

template <class Value>
std::shared_ptr<const Value> sharedPart(Value value) {
  return std::make_shared<const Value>(std::move(value));
}

void addFlat(render::Scene& scene, const Results& results, const RenderSettings& settings,
             const Needs& needs) {
  if (needs.texture) {
    scene.source.layout = sharedPart(
        uvLayout(*results.mesh, cornerUv(*results.mesh, *results.charts, *results.atlas)));
  }
  if (settings.cuts) scene.cuts = sharedPart(cutSides(*results.charts));
  scene.source.unwrap = results.unwrap;
}

float pixelScale(int width, int height) {
  return std::max(0.5f, static_cast<float>(std::min(width, height)) / kUsualSide);
}

render::Scene pictureScene(const Results& results, const PictureOptions& options,
                           bool inTexture = false) {
  const Needs needs = needsOf(results, options, inTexture);
  render::Scene scene;
  scene.source.mesh = results.mesh;
  const CornerNormals normals = computeCornerNormals(*results.mesh, results.parameters.sharpAngle);
  scene.vertices = surfaceVertices(*results.mesh, &normals);
  if (needs.gauss) {
    scene.source.gauss = sharedPart(gaussValues(*results.mesh, *results.gaussArea));
  }
  scene.chartColors = sharedPart(options.chartColors);
  scene.source.segmentation = results.segmentation;
  if (needs.flood && results.record) {
    scene.source.record = results.record;
    scene.source.recorded = results.record->size();
  }
  scene.seeds = sharedPart(seedMarks(results));
  if (results.flat) addFlat(scene, results, options.settings, needs);
  // They belong to the finished charts.
  if (options.settings.problems && results.segmentation->complete && results.chartStats) {
    scene.marks =
        sharedPart(problemMarks(*results.mesh, *results.segmentation, findProblems(results)));
  }
  return scene;
}

Camera pictureCamera(const Results& results, const PictureOptions& options) {
  const bool both = options.view == PictureOptions::View::Both;
  const int width =
      both ? widthsOfBoth({.width = options.width, .height = options.height}).scene : options.width;
  return cameraFromOptions(*results.mesh, options.camera,
                           static_cast<double>(width) / options.height);
}

/// A camera whose whole turn keeps the model in the picture, unless one was asked for.
Camera turntableCamera(const Results& results, const PictureOptions& options) {
  Camera camera = pictureCamera(results, options);
  if (options.camera.given || options.camera.saved) return camera;
  constexpr int kAngles = 24;
  const double aspect = static_cast<double>(options.width) / options.height;
  const auto points = results.mesh->positions();
  camera.target = boundingSphere(points).center;
  double distance = 0;
  for (int i = 0; i < kAngles; ++i) {
    Camera turned = camera;
    turned.orbit(2 * glm::pi<double>() * i / kAngles, 0);
    turned.frame(points, aspect);
    distance = std::max(distance, turned.distance + glm::distance(turned.target, camera.target));
  }
  camera.distance = distance;
  return camera;
}

/// Each part of a picture draws the whole model: few parts where that takes longer than memory for
/// large ones is worth.
int largestPart(const Mesh& mesh) {
  constexpr std::size_t kManyTriangles = 2'000'000;
  return mesh.triangleCount() > kManyTriangles ? 2048 : PictureSize().largestPart;
}

/// One picture with everything uploaded. `settings` are without the scale of lines and letters.
Image drawView(Renderer& renderer, const Mesh& mesh, const PictureOptions& options,
               RenderSettings settings, const Camera& camera) {
  using View = PictureOptions::View;
  if (settings.playhead) settings.problems = false;
  const PictureSize size{.width = options.width,
                         .height = options.height,
                         .supersampling = options.supersampling,
                         .largestPart = largestPart(mesh)};
  settings.pixelScale = options.lineScale > 0 ? static_cast<float>(options.lineScale)
                                              : pixelScale(options.width, options.height);
  const UvCamera texture = options.uvCamera.value_or(UvCamera::whole());
  if (options.view == View::Uv) return renderUvImage(renderer, texture, settings, options.uv, size);
  if (options.view == View::Both) {
    return renderBothImage(renderer, camera, texture, settings, options.uv, size);
  }
  return renderImage(renderer, camera, settings, size);
}

}  // namespace

Image drawPicture(const Results& results, const PictureOptions& options,
                  const std::string& backend) {
  const auto context = gl::createOffscreenContext(gl::offscreenBackendFromId(backend));
  const gl::CurrentScope current(*context);
  Renderer renderer;
  renderer.show(pictureScene(results, options));
  return drawView(renderer, *results.mesh, options, options.settings,
                  pictureCamera(results, options));
}

void drawFrames(const Results& results, const PictureOptions& options, const std::string& backend,
                const std::function<void(std::size_t, const Image&)>& take) {
  const auto context = gl::createOffscreenContext(gl::offscreenBackendFromId(backend));
  const gl::CurrentScope current(*context);
  Renderer renderer;
  renderer.show(pictureScene(results, options));
  const bool turns = options.turntable > 0;
  const std::size_t count = turns ? options.turntable : options.floodFilm;
  const Camera first = turns ? turntableCamera(results, options) : pictureCamera(results, options);
  for (std::size_t i = 0; i < count; ++i) {
    Camera camera = first;
    RenderSettings settings = options.settings;
    if (turns) {
      camera.orbit(2 * glm::pi<double>() * static_cast<double>(i) / static_cast<double>(count), 0);
    } else {
      settings.playhead = filmPlayhead(results.record->size(), i, count);
    }
    take(i, drawView(renderer, *results.mesh, options, settings, camera));
  }
}

Image drawTexture(const Results& results, const PictureOptions& options,
                  const std::string& backend) {
  const auto context = gl::createOffscreenContext(gl::offscreenBackendFromId(backend));
  const gl::CurrentScope current(*context);
  Renderer renderer;
  renderer.show(pictureScene(results, options, true));
  const PictureSize size{.width = results.atlas->textureSize,
                         .height = results.atlas->textureSize,
                         .supersampling = options.supersampling,
                         .largestPart = largestPart(*results.mesh)};
  RenderSettings settings = options.settings;
  settings.scalarBar = false;
  // A layout lies over a texture unless a ground is asked for.
  if (!options.backgroundGiven) settings.background.transparent = true;
  settings.pixelScale = pixelScale(size.width, size.height);
  return renderUvImage(renderer, UvCamera::exact(), settings, {.frame = false}, size);
}

ImageTexts pictureTexts(const Results& results) {
  std::string changed;
  for (const ParameterInfo& info : parameterTable()) {
    if (isDefault(results.parameters, info)) continue;
    const ParameterValue value = parameterValue(results.parameters, info);
    changed += (changed.empty() ? "--" : " --") + std::string(info.id) + "=" + parameterText(value);
  }
  const std::filesystem::path file = results.mesh->input().file;
  return {{"Software", "chartflood " CHARTFLOOD_VERSION},
          {"Title", file.filename().string()},
          {"Parameters", changed}};
}

}  // namespace chartflood
