// What fills the faces of the model: shader variants, values and colour map.

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/base/error.h"
#include "render/passes/renderer.h"
#include "render/passes/renderer_colors.h"
#include "render/passes/texture_units.h"
#include "render/scene/color_map.h"
#include "render/scene/image.h"

namespace chartflood {

namespace {

/// Without a picture there are squares.
CheckerKind shownChecker(const RenderSettings& settings) {
  const bool bare = settings.checkerKind == CheckerKind::Picture && !settings.checkerPicture;
  return bare ? CheckerKind::Squares : settings.checkerKind;
}

constexpr std::size_t kDense = 100'000;  // triangles from which light at their corners is enough
constexpr float kFrontShare = 0.01f;     // of all faces are bright behind the playhead

}  // namespace

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

void Renderer::setChecker(gl::Program& program, const RenderSettings& settings) {
  program.set("uCheckerSquares", settings.checkerSquares);
  program.set("uCheckerInTexture", settings.checkerInTexture ? 1 : 0);
  program.set("uCheckerTint", settings.checkerTint);
  if (shownChecker(settings) == CheckerKind::Picture) {
    program.set("uCheckerSquares", settings.checkerRepeats);
    program.set("uCheckerInTexture", 1);
    bindCheckerPicture(settings.checkerPicture);
    program.set("uCheckerPicture", static_cast<int>(units::kCheckerPicture));
  }
  if (settings.checkerKind != CheckerKind::Numbers) return;
  if (!checkerGlyphs_) checkerGlyphs_.upload<glm::vec4>(GL_RGBA32F, overlay_.checkerGlyphs());
  overlay_.bindGlyphs(units::kGlyphs);
  checkerGlyphs_.bind(units::kCheckerGlyphs);
  program.set("uGlyphs", static_cast<int>(units::kGlyphs));
  program.set("uCheckerGlyphs", static_cast<int>(units::kCheckerGlyphs));
  program.set("uGlyphUnit", GlyphAtlas::distanceUnit() / GlyphAtlas::pixelsPerEm());
}

void Renderer::bindCheckerPicture(std::shared_ptr<const Image> picture) {
  glActiveTexture(GL_TEXTURE0 + units::kCheckerPicture);
  if (checkerPicture_ && picture == loadedPicture_) {
    glBindTexture(GL_TEXTURE_2D, checkerPicture_.id());
    return;
  }
  loadedPicture_ = std::move(picture);
  const Image& image = *loadedPicture_;
  // Rows from the bottom, as texture places have them.
  std::vector<Rgba8> texels;
  texels.reserve(image.pixels().size());
  for (int y = image.height(); y-- > 0;) {
    for (int x = 0; x < image.width(); ++x) {
      Rgba8 p = image.at(x, y);
      for (std::size_t c = 0; c < 3; ++c) p[c] = static_cast<std::uint8_t>(p[c] * p[3] / 255);
      texels.push_back(p);
    }
  }
  if (!checkerPicture_) checkerPicture_ = gl::Texture::create();
  glBindTexture(GL_TEXTURE_2D, checkerPicture_.id());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, image.width(), image.height(), 0, GL_RGBA,
               GL_UNSIGNED_BYTE, texels.data());
  glGenerateMipmap(GL_TEXTURE_2D);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_REPEAT);
}

SurfaceFill Renderer::fillOf(const RenderSettings& settings) const {
  const ColorMode mode = settings.colorMode;
  return canShow(mode) ? colorModeInfo(mode).fill : SurfaceFill::Plain;
}

gl::Program& Renderer::surfaceProgram(const Frame& frame) {
  const RenderSettings& settings = frame.settings;
  const SurfaceFill fill = fillOf(settings);
  std::vector<std::string> macros = fillMacros(fill);
  if (frame.inTexture) macros.push_back("IN_TEXTURE");
  if (settings.playhead || fill == SurfaceFill::FloodTime || fill == SurfaceFill::FloodOrder) {
    macros.push_back("FLOOD");
  }
  if (settings.playhead) macros.push_back("PLAY");
  if (!settings.hiddenCharts.empty() || !settings.selectedCharts.empty()) {
    macros.push_back("STATES");
  }
  if (frame.simple) macros.push_back("SIMPLE");
  const bool lit = settings.lighting && !frame.inTexture;
  if (lit) macros.push_back("LIGHT");
  if (!settings.smoothNormals || !surface_->hasNormals()) {
    macros.push_back("FLAT");
  } else if (lit && surface_->culled() && mesh_->triangleCount() > kDense) {
    macros.push_back("VERTEX_LIGHT");
  }
  if (settings.edges && !frame.simple) macros.push_back("WIRE");
  if (settings.problems && marks_ && marks_->marksTriangles()) macros.push_back("MARKS");
  if (fill == SurfaceFill::Checker) {
    macros.push_back("CHECKER " + std::to_string(static_cast<int>(shownChecker(settings))));
  }
  const auto found = surfacePrograms_.find(macros);
  if (found != surfacePrograms_.end()) return found->second;
  return surfacePrograms_.emplace(macros, gl::Program("surface.vert", "surface.frag", macros))
      .first->second;
}

void Renderer::setFill(gl::Program& program, const Frame& frame) {
  const RenderSettings& settings = frame.settings;
  const ColorMode mode = canShow(settings.colorMode) ? settings.colorMode : ColorMode::Shaded;
  const ValueDomain domain = colorModeInfo(mode).domain;
  const bool marksAlone = domain == ValueDomain::Vertex || domain == ValueDomain::Edge;
  program.set("uPlainColor", marksAlone ? colors::kCalm : colors::kClay);
  program.set("uDryColor", colors::kDry);
  program.set("uClamp", settings.clampColors ? 1 : 0);
  std::optional<ScalarRange> range = scalarRange(settings);
  const ColorMode onTriangles = modeOfElement(mode, ValueDomain::Triangle);
  if (onTriangles != mode) {  // each kind of element has its own range
    range = valuesOf(onTriangles).range;
    if (settings.scale) range->scale = *settings.scale;
  }
  setScale(program, range.value_or(ScalarRange{}), settings);
  if (fillOf(settings) != SurfaceFill::TriangleValue) return;
  ValueLayer& layer = valuesOf(onTriangles);
  if (!layer.onCard) layer.onCard.upload<float>(GL_R32F, layer.values);
  layer.onCard.bind(units::kValues);
}

void Renderer::setTriangleMarks(gl::Program& program, const Frame& frame) {
  if (!marks_ || !frame.settings.problems) return;
  marks_->bindTriangles(units::kMarks);
  program.set("uMarks", static_cast<int>(units::kMarks));
  for (std::size_t i = 1; i < kTriangleMarks; ++i) {
    program.set("uMarkColors[" + std::to_string(i) + ']', markColor(static_cast<TriangleMark>(i)));
  }
  program.set("uMarkScale", frame.settings.pixelScale);
  program.set("uPartOrigin", frame.origin);
}

std::size_t Renderer::drawnTriangles(const Frame& frame) const {
  return frame.simple ? surface_->simpleCount() : mesh_->triangleCount();
}

std::size_t Renderer::drawSurface(const Frame& frame, std::size_t first, std::size_t count) {
  const std::size_t end = first + std::min(count, drawnTriangles(frame) - first);
  const RenderSettings& settings = frame.settings;
  if (settings.playhead) flood_->prepare();  // before anything is bound
  gl::Program& program = surfaceProgram(frame);
  program.use();
  setEye(program, frame.eye);
  setFill(program, frame);
  charts_->bindLabels(units::kLabels);
  flood_->bindOrder(units::kFlood);
  flood_->bindTime(units::kFloodTime);
  charts_->bindColors(units::kChartColors);
  charts_->bindValues(units::kChartValues);
  surface_->bindArrays(units::kVertices, units::kIndices, units::kInnerSides);
  const std::pair<const char*, GLuint> samplers[] = {
      {"uLabels", units::kLabels},           {"uFlood", units::kFlood},
      {"uFloodTime", units::kFloodTime},     {"uValues", units::kValues},
      {"uChartColors", units::kChartColors}, {"uChartValues", units::kChartValues},
      {"uVertices", units::kVertices},       {"uIndices", units::kIndices},
      {"uInnerSides", units::kInnerSides}};
  for (const auto& [name, unit] : samplers) program.set(name, static_cast<int>(unit));

  const float faces = static_cast<float>(mesh_->faceCount());
  program.set("uPlayhead", static_cast<unsigned>(settings.playhead.value_or(0)));
  const float front = settings.front ? std::max(1.0f, std::ceil(kFrontShare * faces)) : 0;
  program.set("uFront", static_cast<unsigned>(front));
  program.set("uOrderScale", 1 / std::max(faces, 1.0f));
  program.set("uWireWidth", settings.edgeWidth * settings.pixelScale);
  setChecker(program, settings);
  setTriangleMarks(program, frame);
  const bool hovers = settings.hoverFace < mesh_->faceCount();
  program.set("uHoverFirst", hovers ? mesh_->triangleBegin(settings.hoverFace) : 0u);
  program.set("uHoverEnd", hovers ? mesh_->triangleBegin(settings.hoverFace + 1) : 0u);
  const bool flashes = settings.flashFace < mesh_->faceCount();
  program.set("uFlashFirst", flashes ? mesh_->triangleBegin(settings.flashFace) : 0u);
  program.set("uFlashEnd", flashes ? mesh_->triangleBegin(settings.flashFace + 1) : 0u);
  program.set("uHoverChart", hoveredChart(settings));
  program.set("uFirstTriangle", static_cast<int>(first));
  program.set("uOutside", surface_->insideOut() ? -1.0f : 1.0f);
  // The inside of a closed surface is seen only where charts are hidden, and in the texture, where
  // a flipped triangle shall show.
  const bool outsideAlone = settings.hiddenCharts.empty() && !frame.inTexture;
  if (frame.simple) {
    surface_->bindSimple(units::kSimple);
    program.set("uTriangles", static_cast<int>(units::kSimple));
    surface_->drawSimple(outsideAlone, first, end - first);
  } else {
    surface_->draw(outsideAlone, first, end - first);
  }
  return end;
}

}  // namespace chartflood
