#include "render/renderer.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/check.h"
#include "core/base/error.h"
#include "render/color_map.h"
#include "render/texture_units.h"

namespace chartflood {

namespace {

// Values of FILL in surface.frag.
enum Fill { kPlain, kCharts, kTriangleValue, kChartValue, kFloodTime, kFloodOrder, kChecker };

constexpr glm::vec3 kClay(0.800f, 0.790f, 0.770f);
constexpr glm::vec3 kCalm(0.560f, 0.565f, 0.575f);  // the ground of discs and lines
constexpr glm::vec3 kDry(0.4157f);                  // 6A6A6A
constexpr std::size_t kDense = 100'000;  // triangles from which light at their corners is enough
constexpr std::size_t kFirstPiece = 16'000;  // triangles, while nothing is known of the driver
constexpr float kFrontShare = 0.01f;         // of all faces are bright behind the playhead

bool isDistortion(ColorMode mode) {
  return mode == ColorMode::Stretch || mode == ColorMode::AreaDistortion ||
         mode == ColorMode::AngleDistortion;
}

bool isGauss(ColorMode mode) {
  return mode == ColorMode::GaussVertex || mode == ColorMode::GaussEdge ||
         mode == ColorMode::GaussFace || mode == ColorMode::Gauss;
}

/// Range of an unwrap's distortion: from the undistorted value on, the tail cut at 98 %.
ScalarRange distortionRange(ColorMode mode, std::span<const float> values) {
  std::vector<WeightedValue> sizes;
  sizes.reserve(values.size());
  const bool signedValues = mode == ColorMode::AreaDistortion;
  for (const float v : values) sizes.push_back({signedValues ? std::abs(double{v}) : double{v}, 1});
  ScalarRange range;
  if (signedValues) {
    range.max = std::max(std::ceil(weightedPercentile(sizes, 0.98) * 2) / 2, 0.5);
    range.min = -range.max;
    return range;
  }
  range.min = 1;
  range.max = std::max(weightedPercentile(sizes, 0.98), 1.1);
  range.hasMean = true;
  range.mean = weightedMean(sizes);
  return range;
}

}  // namespace

Renderer::Renderer()
    : backgroundProgram_("background.vert", "background.frag"),
      lineProgram_("lines.vert", "lines.frag"), pointProgram_("points.vert", "points.frag"),
      idProgram_("ids.vert", "ids.frag"), emptyVertexArray_(gl::VertexArray::create()) {
  seeds_.upload<glm::vec4>(GL_RGBA32F, {});
  cornerUv_.upload<glm::vec2>(GL_RG32F, {});
}

void Renderer::setMesh(std::shared_ptr<const Mesh> mesh, const CornerNormals* normals) {
  unfinished_.reset();
  mesh_ = std::move(mesh);
  surface_.reset();
  charts_.reset();
  flood_.reset();
  gauss_.reset();
  values_.clear();
  hasCornerUv_ = false;
  seedMarks_.clear();
  if (!mesh_) return;
  bounds_ = boundingSphere(mesh_->positions());
  surface_.emplace(*mesh_, normals);
  charts_.emplace(mesh_);
  flood_.emplace(mesh_);
}

void Renderer::setNormals(const CornerNormals* normals) {
  unfinished_.reset();
  if (mesh_) surface_.emplace(*mesh_, normals);
}

void Renderer::setGaussArea(const GaussArea* gaussArea) {
  gauss_.reset();
  if (mesh_ && gaussArea) gauss_.emplace(gaussValues(*mesh_, *gaussArea));
}

void Renderer::setGaussValues(const GaussValues& values) {
  if (mesh_) gauss_.emplace(values);
}

void Renderer::warmUp(const RenderSettings& settings, std::span<const int> samples) {
  if (!mesh_) return;
  constexpr int kSize = 8;
  const Camera camera;
  for (const int count : samples) {
    const gl::Framebuffer target(kSize, kSize, count);
    for (const bool playing : {false, true}) {
      RenderSettings wanted = settings;
      wanted.playhead.reset();
      if (playing) wanted.playhead = 1;
      beginDrawing(target, camera, wanted, PicturePart::whole(kSize, kSize));
      const gl::FramebufferScope keep;
      target.bindForDrawing();
      useColorMap(wanted);
      glEnable(GL_BLEND);
      glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
      drawSurface({wanted, makeEye(camera, bounds_, unfinished_->part)}, 0, 1);
      glDisable(GL_BLEND);
      glFinish();
      unfinished_.reset();
    }
  }
}

void Renderer::setSegmentation(const Segmentation* segmentation) {
  if (mesh_) charts_->setSegmentation(segmentation);
}

void Renderer::setFlood(std::shared_ptr<const FloodRecord> record, std::size_t most) {
  if (!mesh_) return;
  flood_->follow(std::move(record));
  updateFlood(most);
}

bool Renderer::updateFlood(std::size_t most) {
  if (!mesh_) return true;
  const bool whole = flood_->update(most);
  charts_->growTo(flood_->chartCount());
  return whole;
}

void Renderer::setTriangleValues(ColorMode mode, std::span<const float> values) {
  if (!isDistortion(mode)) throw Error("This colour mode takes no values for triangles.");
  if (values.empty()) {
    values_.erase(mode);
    return;
  }
  if (!mesh_ || values.size() != mesh_->triangleCount()) {
    throw Error("There must be one value for each triangle.");
  }
  ValueLayer& layer = values_[mode];
  layer.values.upload<float>(GL_R32F, values);
  layer.range = distortionRange(mode, values);
}

void Renderer::setCornerUv(std::span<const glm::vec2> uv) {
  hasCornerUv_ = !uv.empty();
  if (hasCornerUv_ && (!mesh_ || uv.size() != 3 * mesh_->triangleCount())) {
    throw Error("There must be three texture places for each triangle.");
  }
  cornerUv_.upload<glm::vec2>(GL_RG32F, uv);
}

bool Renderer::canShow(ColorMode mode) const {
  if (!mesh_) return false;
  if (mode == ColorMode::Shaded) return true;
  if (isGauss(mode)) return gauss_.has_value();
  if (isDistortion(mode)) return values_.contains(mode);
  if (mode == ColorMode::Checkerboard) return hasCornerUv_;
  if (mode == ColorMode::FloodTime || mode == ColorMode::FloodOrder) return flood_->size() > 0;
  if (mode == ColorMode::Balance) return charts_->labelled();
  return charts_->labelled() || flood_->size() > 0;
}

glm::vec3 Renderer::chartColor(Index chart, const RenderSettings& settings) const {
  if (!charts_ || chart >= charts_->chartCount()) return kDry;
  return charts_->chartColor(chart, settings.palette);
}

std::optional<ScalarRange> Renderer::scalarRange(const RenderSettings& settings) const {
  const ColorModeInfo& info = colorModeInfo(settings.colorMode);
  if (*info.colorMap == '\0' || !canShow(settings.colorMode)) return std::nullopt;
  ScalarRange range;
  switch (settings.colorMode) {
  case ColorMode::GaussVertex:
    range = gauss_->vertexRange();
    break;
  case ColorMode::GaussEdge:
    range = gauss_->edgeRange();
    break;
  case ColorMode::GaussFace:
    range = gauss_->faceRange();
    break;
  case ColorMode::Gauss:
    range.plainEnds = true;
    break;
  case ColorMode::Balance:
    range = charts_->balanceRange();
    break;
  case ColorMode::Stretch:
  case ColorMode::AreaDistortion:
  case ColorMode::AngleDistortion:
    range = values_.at(settings.colorMode).range;
    break;
  default:
    break;  // shares run from 0 to 1
  }
  range.title = info.title;
  range.unit = info.unit;
  range.scale = info.scale;
  return chosenRange(range, settings);
}

ScalarRange Renderer::chosenRange(ScalarRange range, const RenderSettings& settings) const {
  if (settings.scale) range.scale = *settings.scale;
  if (settings.range && settings.range->first < settings.range->second) {
    range.min = settings.range->first;
    range.max = settings.range->second;
  }
  // A logarithm has no place for 0: show four decades below the top.
  if (range.scale == ScalarScale::Log && range.min <= 0) range.min = 1e-4 * std::abs(range.max);
  return range;
}

void Renderer::useColorMap(const RenderSettings& settings) {
  const char* own = colorModeInfo(settings.colorMode).colorMap;
  const std::string id =
      !settings.colorMap.empty() ? settings.colorMap : (*own == '\0' ? "viridis" : own);
  const std::string key = id + (settings.invertColorMap ? " inverted" : "");
  glActiveTexture(GL_TEXTURE0 + units::kColorMap);
  if (colorMap_ && key == loadedMap_) {
    glBindTexture(GL_TEXTURE_2D, colorMap_.id());
    return;
  }
  const ColorMap* map = findColorMap(id);
  if (!map) throw UsageError("There is no colour map \"" + id + "\".");
  std::array<std::array<std::uint8_t, 4>, 256> texels{};
  for (std::size_t i = 0; i < texels.size(); ++i) {
    const float t = static_cast<float>(i) / 255.0f;
    const glm::vec3 color = map->at(settings.invertColorMap ? 1 - t : t);
    for (int c = 0; c < 3; ++c) {
      texels[i][static_cast<std::size_t>(c)] =
          static_cast<std::uint8_t>(std::lround(color[c] * 255.0f));
    }
    texels[i][3] = 255;
  }
  if (!colorMap_) colorMap_ = gl::Texture::create();
  glBindTexture(GL_TEXTURE_2D, colorMap_.id());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 256, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  loadedMap_ = key;
}

void Renderer::setScale(gl::Program& program, const ScalarRange& range,
                        const RenderSettings& settings) {
  program.set("uColorMap", static_cast<int>(units::kColorMap));
  program.set("uRange", glm::vec2(range.min, range.max));
  program.set("uScale", static_cast<int>(range.scale));
  program.set("uSteps", settings.colorSteps);
}

void Renderer::draw(const gl::Framebuffer& target, const Camera& camera,
                    const RenderSettings& settings) {
  draw(target, camera, settings, PicturePart::whole(target.width(), target.height()));
}

void Renderer::draw(const gl::Framebuffer& target, const Camera& camera,
                    const RenderSettings& settings, const PicturePart& part) {
  beginDrawing(target, camera, settings, part);
  continueDrawing(std::numeric_limits<double>::infinity());
}

void Renderer::beginDrawing(const gl::Framebuffer& target, const Camera& camera,
                            const RenderSettings& settings, const PicturePart& part) {
  CF_CHECK(part.width == target.width() && part.height == target.height());
  const gl::FramebufferScope keep;
  lastSettings_ = settings;
  if (mesh_) charts_->update(settings, flood_->longestTime());
  unfinished_.emplace(Unfinished{&target, camera, settings, part, 0, kFirstPiece});
  target.bindForDrawing();
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_CULL_FACE);
  glDisable(GL_BLEND);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDepthMask(GL_TRUE);
  glClearColor(0, 0, 0, 0);
  glClearDepth(1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  drawBackground({settings, makeEye(camera, bounds_, part)});
}

bool Renderer::continueDrawing(double seconds) {
  if (!unfinished_) return true;
  const gl::FramebufferScope keep;
  Unfinished& picture = *unfinished_;
  const Frame frame{picture.settings, makeEye(picture.camera, bounds_, picture.part)};
  useColorMap(picture.settings);
  picture.target->bindForDrawing();
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_CULL_FACE);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDepthMask(GL_TRUE);
  glDepthFunc(GL_LEQUAL);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);  // colours are premultiplied
  const bool ready = drawSurfacePieces(frame, picture, seconds);
  if (ready && mesh_) {
    glDepthMask(GL_FALSE);
    drawLines(frame);
    drawMarks(frame);
    glDepthMask(GL_TRUE);
    drawOverlay(frame, picture.camera);
  }
  glDisable(GL_BLEND);
  glDisable(GL_DEPTH_TEST);
  glUseProgram(0);
  glActiveTexture(GL_TEXTURE0);
  if (!ready) return false;
  picture.target->resolve();
  unfinished_.reset();
  return true;
}

/// True when the whole surface is drawn.
bool Renderer::drawSurfacePieces(const Frame& frame, Unfinished& picture, double seconds) {
  if (!mesh_) return true;
  if (seconds == std::numeric_limits<double>::infinity()) {
    drawSurface(frame, picture.nextTriangle, mesh_->triangleCount());
    return true;
  }
  using Clock = std::chrono::steady_clock;
  const auto since = [](Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
  };
  const Clock::time_point start = Clock::now();
  while (picture.nextTriangle < mesh_->triangleCount()) {
    const Clock::time_point pieceStart = Clock::now();
    picture.nextTriangle = drawSurface(frame, picture.nextTriangle, picture.pieceSize);
    glFinish();
    // Three pieces in the time that there is, so that it is not missed by much.
    const double share = seconds / 3 / std::max(since(pieceStart), 1e-6);
    picture.pieceSize = static_cast<std::size_t>(std::clamp(
        static_cast<double>(picture.pieceSize) * std::clamp(share, 0.3, 4.0), 2000.0, 1e9));
    if (since(start) >= seconds * 2 / 3) break;
  }
  return picture.nextTriangle >= mesh_->triangleCount();
}

void Renderer::drawBackground(const Frame& frame) {
  const Background& background = frame.settings.background;
  if (background.transparent) return;
  glDisable(GL_DEPTH_TEST);
  backgroundProgram_.use();
  backgroundProgram_.set("uTile", frame.eye.tile);
  backgroundProgram_.set("uBottom", glm::vec4(background.bottom, 1));
  backgroundProgram_.set("uTop", glm::vec4(background.top, 1));
  glBindVertexArray(emptyVertexArray_.id());
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

int Renderer::fillNumber(const RenderSettings& settings) const {
  switch (canShow(settings.colorMode) ? settings.colorMode : ColorMode::Shaded) {
  case ColorMode::Shaded:
  case ColorMode::GaussVertex:
  case ColorMode::GaussEdge:
    return kPlain;
  case ColorMode::Charts:
    return kCharts;
  case ColorMode::Balance:
    return kChartValue;
  case ColorMode::FloodTime:
    return kFloodTime;
  case ColorMode::FloodOrder:
    return kFloodOrder;
  case ColorMode::Checkerboard:
    return kChecker;
  default:
    return kTriangleValue;
  }
}

gl::Program& Renderer::surfaceProgram(const RenderSettings& settings) {
  const int fill = fillNumber(settings);
  std::vector<std::string> macros{"FILL " + std::to_string(fill)};
  if (settings.playhead || fill == kFloodTime || fill == kFloodOrder) macros.push_back("FLOOD");
  if (settings.playhead) macros.push_back("PLAY");
  if (!settings.hiddenCharts.empty() || !settings.selectedCharts.empty()) {
    macros.push_back("STATES");
  }
  if (settings.lighting) macros.push_back("LIGHT");
  if (!settings.smoothNormals || !surface_->hasNormals()) {
    macros.push_back("FLAT");
  } else if (settings.lighting && surface_->culled() && mesh_->triangleCount() > kDense) {
    macros.push_back("VERTEX_LIGHT");
  }
  if (settings.edges) macros.push_back("WIRE");
  if (settings.edges || fill == kChecker) macros.push_back("PLACES");
  const auto found = surfacePrograms_.find(macros);
  if (found != surfacePrograms_.end()) return found->second;
  return surfacePrograms_.emplace(macros, gl::Program("surface.vert", "surface.frag", macros))
      .first->second;
}

void Renderer::setFill(gl::Program& program, const Frame& frame) {
  const RenderSettings& settings = frame.settings;
  const ColorMode mode = canShow(settings.colorMode) ? settings.colorMode : ColorMode::Shaded;
  const bool marksAlone = mode == ColorMode::GaussVertex || mode == ColorMode::GaussEdge;
  program.set("uPlainColor", marksAlone ? kCalm : kClay);
  program.set("uDryColor", kDry);
  std::optional<ScalarRange> range = scalarRange(settings);
  if (mode == ColorMode::Gauss) {
    range = gauss_->faceRange();
    range->scale = settings.scale.value_or(ScalarScale::Linear);
  }
  setScale(program, range.value_or(ScalarRange{}), settings);
  if (mode == ColorMode::GaussFace || mode == ColorMode::Gauss) {
    gauss_->bindFaceValues(units::kValues);
  } else if (isDistortion(mode)) {
    values_.at(mode).values.bind(units::kValues);
  }
}

std::size_t Renderer::drawSurface(const Frame& frame, std::size_t first, std::size_t count) {
  const std::size_t end = first + std::min(count, mesh_->triangleCount() - first);
  const RenderSettings& settings = frame.settings;
  gl::Program& program = surfaceProgram(settings);
  program.use();
  setEye(program, frame.eye);
  setFill(program, frame);
  charts_->bindLabels(units::kLabels);
  flood_->bindOrder(units::kFlood);
  flood_->bindTime(units::kFloodTime);
  charts_->bindColors(units::kChartColors);
  charts_->bindValues(units::kChartValues);
  cornerUv_.bind(units::kCornerUv);
  surface_->bindArrays(units::kVertices, units::kIndices, units::kInnerSides);
  const std::pair<const char*, GLuint> samplers[] = {
      {"uLabels", units::kLabels},           {"uFlood", units::kFlood},
      {"uFloodTime", units::kFloodTime},     {"uValues", units::kValues},
      {"uChartColors", units::kChartColors}, {"uChartValues", units::kChartValues},
      {"uVertices", units::kVertices},       {"uIndices", units::kIndices},
      {"uInnerSides", units::kInnerSides},   {"uCornerUv", units::kCornerUv}};
  for (const auto& [name, unit] : samplers) program.set(name, static_cast<int>(unit));

  const float faces = static_cast<float>(mesh_->faceCount());
  program.set("uPlayhead", static_cast<unsigned>(settings.playhead.value_or(0)));
  program.set("uFront", static_cast<unsigned>(std::max(1.0f, std::ceil(kFrontShare * faces))));
  program.set("uOrderScale", 1 / std::max(faces, 1.0f));
  program.set("uWireWidth", settings.edgeWidth * settings.pixelScale);
  program.set("uCheckerSquares", settings.checkerSquares);
  const bool hovers = settings.hoverFace < mesh_->faceCount();
  program.set("uHoverFirst", hovers ? mesh_->triangleBegin(settings.hoverFace) : 0u);
  program.set("uHoverEnd", hovers ? mesh_->triangleBegin(settings.hoverFace + 1) : 0u);
  program.set("uFirstTriangle", static_cast<int>(first));
  program.set("uOutside", surface_->insideOut() ? -1.0f : 1.0f);
  glEnable(GL_DEPTH_TEST);
  // The inside of a closed surface is seen only where charts are hidden.
  surface_->draw(settings.hiddenCharts.empty(), first, end - first);
  return end;
}

void Renderer::drawSegments(const Frame& frame, std::size_t count, const glm::vec2& widths,
                            const glm::vec4& color) {
  if (count == 0) return;
  gl::Program& program = lineProgram_;
  program.set("uSegments", static_cast<int>(units::kValues));
  program.set("uFirst", 0);
  program.set("uWidths", widths * frame.settings.pixelScale);
  program.set("uColor", color);
  glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(6 * count));
}

void Renderer::drawLines(const Frame& frame) {
  const RenderSettings& settings = frame.settings;
  const ColorMode mode = canShow(settings.colorMode) ? settings.colorMode : ColorMode::Shaded;
  constexpr glm::vec4 kInk(0.055f, 0.055f, 0.063f, 1), kChalk(0.93f, 0.93f, 0.90f, 1);
  constexpr glm::vec4 kByValue(0);
  glEnable(GL_DEPTH_TEST);
  glBindVertexArray(emptyVertexArray_.id());
  lineProgram_.use();
  setEye(lineProgram_, frame.eye);
  setScale(lineProgram_, ScalarRange{}, settings);
  if (settings.sharpEdges && gauss_ && mode != ColorMode::GaussEdge && mode != ColorMode::Gauss) {
    gauss_->bindEdges(units::kValues);
    drawSegments(frame, gauss_->edgeCount(), glm::vec2(1.4f), kChalk);
  }
  if (settings.seams) {
    const glm::vec2 width(settings.seamWidth);
    if (settings.playhead) {
      flood_->bindSeams(units::kValues);
      drawSegments(frame, flood_->seamCount(*settings.playhead), width, kInk);
    } else {
      charts_->bindSeams(units::kValues);
      drawSegments(frame, charts_->seamCount(), width, kInk);
    }
  }
  if (mode == ColorMode::GaussEdge || mode == ColorMode::Gauss) {
    ScalarRange range = gauss_->edgeRange();
    range.scale = ScalarScale::Root;
    setScale(lineProgram_, mode == ColorMode::Gauss ? range : *scalarRange(settings), settings);
    gauss_->bindEdges(units::kValues);
    // All dark outlines lie under all colours, or they would cut the chain into pieces.
    drawSegments(frame, gauss_->edgeCount(), {3.2f, 6.2f}, kInk);
    drawSegments(frame, gauss_->edgeCount(), {1.6f, 4.4f}, kByValue);
  }
}

void Renderer::setSeeds(std::span<const SeedMark> seeds) {
  seedMarks_.assign(seeds.begin(), seeds.end());
  if (!mesh_) return;
  std::vector<glm::dvec3> places;
  for (const SeedMark& seed : seedMarks_) {
    if (seed.chart == places.size()) places.push_back(faceMiddle(*mesh_, seed.face));
  }
  charts_->setSeeds(places);
}

void Renderer::drawMarks(const Frame& frame) {
  const RenderSettings& settings = frame.settings;
  const ColorMode mode = canShow(settings.colorMode) ? settings.colorMode : ColorMode::Shaded;
  gl::Program& program = pointProgram_;
  const float scale = settings.pixelScale;
  glBindVertexArray(emptyVertexArray_.id());
  program.use();
  setEye(program, frame.eye);
  program.set("uPoints", static_cast<int>(units::kValues));
  program.set("uOpacity", 1.0f);
  if (mode == ColorMode::GaussVertex || mode == ColorMode::Gauss) {
    ScalarRange range = gauss_->vertexRange();
    range.scale = ScalarScale::Root;
    setScale(program, mode == ColorMode::Gauss ? range : *scalarRange(settings), settings);
    gauss_->bindVertices(units::kValues);
    program.set("uByValue", 1);
    program.set("uBall", 0);
    program.set("uRing", 1.1f * scale);
    program.set("uRadii", glm::vec2(2.6f, 7.0f) * scale);
    glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(6 * gauss_->vertexCount()));
  }
  if (!settings.seedMarks || seedMarks_.empty()) return;
  setScale(program, ScalarRange{}, settings);
  uploadSeeds(settings);
  seeds_.bind(units::kValues);
  program.set("uByValue", 0);
  program.set("uBall", 1);
  program.set("uRing", 1.5f * scale);
  program.set("uRadii", glm::vec2(settings.seedRadius) * scale);
  // Seeds behind the model shine through faintly; those in front cover it.
  const auto count = static_cast<GLsizei>(6 * seedMarks_.size());
  glDepthFunc(GL_GREATER);
  program.set("uOpacity", 0.14f);
  glDrawArrays(GL_TRIANGLES, 0, count);
  glDepthFunc(GL_LEQUAL);
  program.set("uOpacity", 1.0f);
  glDrawArrays(GL_TRIANGLES, 0, count);
}

void Renderer::uploadSeeds(const RenderSettings& settings) {
  std::vector<glm::vec4> texels;
  for (const SeedMark& seed : seedMarks_) {
    texels.emplace_back(glm::vec3(faceMiddle(*mesh_, seed.face)), 0.0f);
    texels.emplace_back(chartColor(seed.chart, settings),
                        (seed.emphasis ? 1.0f : 0.0f) + (seed.locked ? 2.0f : 0.0f));
  }
  if (texels == uploadedSeeds_) return;
  seeds_.upload<glm::vec4>(GL_RGBA32F, texels);
  uploadedSeeds_ = std::move(texels);
}

glm::dvec3 faceMiddle(const Mesh& mesh, Index face) {
  glm::dvec3 sum(0);
  double weight = 0;
  for (Index t = mesh.triangleBegin(face); t < mesh.triangleBegin(face + 1); ++t) {
    const double area = std::max(mesh.triangleArea()[t], 1e-30);
    for (const Index vertex : mesh.triangles()[t]) sum += mesh.positions()[vertex] * (area / 3);
    weight += area;
  }
  return sum / weight;
}

}  // namespace chartflood
