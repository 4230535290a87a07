#include "app/cli/picture.h"

#include <algorithm>
#include <filesystem>

#include "app/cli/camera_options.h"
#include "core/gauss/sector_normals.h"
#include "render/gl/offscreen_context.h"
#include "render/offscreen_render.h"
#include "render/renderer.h"

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

void fill(Renderer& renderer, const Results& results) {
  const CornerNormals normals = computeCornerNormals(*results.mesh, results.parameters.sharpAngle);
  renderer.setMesh(results.mesh, &normals);
  renderer.setGaussArea(results.gaussArea.get());
  renderer.setSegmentation(results.segmentation.get());
  renderer.setFlood(results.record);
  renderer.updateFlood();
  renderer.setSeeds(seedMarks(results));
}

}  // namespace

Image drawPicture(const Results& results, const PictureOptions& options,
                  const std::string& backend) {
  const auto context = gl::createOffscreenContext(gl::offscreenBackendFromId(backend));
  const gl::CurrentScope current(*context);
  Renderer renderer;
  fill(renderer, results);
  const double aspect = static_cast<double>(options.width) / options.height;
  RenderSettings settings = options.settings;
  settings.pixelScale =
      std::max(0.5f, static_cast<float>(std::min(options.width, options.height)) / kUsualSide);
  const PictureSize size{
      .width = options.width, .height = options.height, .supersampling = options.supersampling};
  return renderImage(renderer, cameraFromOptions(*results.mesh, options.camera, aspect), settings,
                     size);
}

ImageTexts pictureTexts(const Results& results) {
  std::string changed;
  for (const ParameterInfo& info : parameterTable()) {
    const ParameterValue value = parameterValue(results.parameters, info);
    if (value == parameterDefault(info)) continue;
    changed += (changed.empty() ? "--" : " --") + std::string(info.id) + "=" + parameterText(value);
  }
  const std::filesystem::path file = results.mesh->input().file;
  return {{"Software", "chartflood " CHARTFLOOD_VERSION},
          {"Title", file.filename().string()},
          {"Parameters", changed}};
}

}  // namespace chartflood
