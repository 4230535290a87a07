#include "render/passes/renderer.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/error.h"
#include "render/passes/renderer_colors.h"
#include "render/scene/mode_range.h"

namespace chartflood {

namespace {

bool isGauss(ColorMode mode) {
  return mode == ColorMode::GaussVertex || mode == ColorMode::GaussEdge ||
         mode == ColorMode::GaussFace || mode == ColorMode::Gauss;
}

}  // namespace

Renderer::Renderer()
    : backgroundProgram_("background.vert", "background.frag"),
      lineProgram_("lines.vert", "lines.frag"), pointProgram_("points.vert", "points.frag"),
      idProgram_("ids.vert", "ids.frag"),
      idUvProgram_("ids.vert", "ids.frag", std::vector<std::string>{"IN_TEXTURE"}),
      emptyVertexArray_(gl::VertexArray::create()) {
  seeds_.upload<glm::vec4>(GL_RGBA32F, {});
}

void Renderer::setMesh(std::shared_ptr<const Mesh> mesh, const CornerNormals* normals) {
  unfinished_.reset();
  tree_.reset();
  mesh_ = std::move(mesh);
  vertices_.reset();
  surface_.reset();
  charts_.reset();
  flood_.reset();
  gauss_.reset();
  values_.clear();
  uv_.reset();
  cuts_.reset();
  lines_.clear();
  marks_.reset();
  seedMarks_.clear();
  if (!mesh_) return;
  bounds_ = boundingSphere(mesh_->positions());
  vertices_ = surfaceVertices(*mesh_, normals);
  surface_.emplace(*mesh_, *vertices_);
  charts_.emplace(mesh_);
  flood_.emplace(mesh_);
}

void Renderer::setNormals(const CornerNormals* normals) {
  if (mesh_) setVertices(surfaceVertices(*mesh_, normals));
}

void Renderer::setVertices(std::shared_ptr<const SurfaceVertices> vertices,
                           const SurfaceVertices* parted) {
  unfinished_.reset();
  if (!mesh_) return;
  vertices_ = std::move(vertices);
  if (uv_) return showParted(uv_->layout(), parted);
  surface_->setVertices(*vertices_);
}

void Renderer::showParted(const UvLayout& layout, const SurfaceVertices* parted) {
  surface_->setVertices(parted != nullptr ? *parted : *partedVertices(*vertices_, layout.corners));
}

void Renderer::setGaussArea(const GaussArea* gaussArea) {
  gauss_.reset();
  if (mesh_ && gaussArea) gauss_.emplace(gaussValues(*mesh_, *gaussArea));
}

void Renderer::setGaussValues(const GaussValues& values) {
  if (mesh_) gauss_.emplace(values);
}

void Renderer::setSegmentation(const Segmentation* segmentation) {
  if (mesh_) charts_->setSegmentation(segmentation);
}

void Renderer::setChartColors(std::span<const Index> numbers) {
  if (mesh_) charts_->paint(numbers);
}

std::span<const Index> Renderer::chartColorNumbers() const {
  return charts_ ? charts_->colorNumbers() : std::span<const Index>{};
}

void Renderer::setLabels(std::span<const Index> label) {
  if (!mesh_) return;
  if (!label.empty() && label.size() != mesh_->faceCount()) {
    throw Error("There must be one label for each face.");
  }
  charts_->setLabels(label);
}

void Renderer::setChartAreas(std::span<const double> gaussArea) {
  if (mesh_) charts_->setBalance(gaussArea);
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
  if (!showsDistortion(mode)) throw Error("This colour mode takes no values for triangles.");
  if (values.empty()) {
    values_.erase(mode);
    return;
  }
  if (!mesh_ || values.size() != mesh_->triangleCount()) {
    throw Error("There must be one value for each triangle.");
  }
  ValueLayer& layer = values_[mode];
  layer.values.upload<float>(GL_R32F, values);
  layer.range = distortionRange(mode, values, mesh_->triangleArea());
}

void Renderer::setCornerUv(std::span<const glm::vec2> uv) {
  if (!uv.empty() && (!mesh_ || uv.size() != 3 * mesh_->triangleCount())) {
    throw Error("There must be three texture places for each triangle.");
  }
  if (uv.empty())
    forgetUv();
  else
    setUvLayout(std::make_shared<const UvLayout>(uvLayout(*mesh_, uv)));
}

void Renderer::setUvLayout(std::shared_ptr<const UvLayout> layout, const SurfaceVertices* parted) {
  if (!mesh_) return;
  if (layout->empty()) return forgetUv();
  unfinished_.reset();
  surface_->forgetSimple();
  showParted(*layout, parted);
  uv_.emplace(mesh_, std::move(layout));
  if (cuts_) uv_->setCuts(cuts_->edges());
  if (marks_) marks_->setTexture(*mesh_, &uv_->layout());
}

void Renderer::forgetUv() {
  if (!uv_) return;
  unfinished_.reset();
  surface_->forgetSimple();
  surface_->setVertices(*vertices_);
  uv_.reset();
  if (marks_) marks_->setTexture(*mesh_, nullptr);
}

void Renderer::setMarks(const SurfaceMarks& marks) {
  if (!mesh_) return;
  marks_.emplace(*mesh_, marks);
  marks_->setTexture(*mesh_, uv_ ? &uv_->layout() : nullptr);
}

void Renderer::setLines(std::span<const EdgeLines> lines) {
  lines_.clear();
  if (!mesh_) return;
  for (const EdgeLines& each : lines) {
    lines_.push_back({CutLayer(*mesh_, each.sides), {{}, each.color, each.width, each.dashed}});
  }
}

void Renderer::setCuts(std::span<const Index> sides) {
  if (!mesh_) return;
  cuts_.emplace(*mesh_, sides);
  if (uv_) uv_->setCuts(cuts_->edges());
}

bool Renderer::canShow(ColorMode mode) const {
  if (!mesh_) return false;
  if (mode == ColorMode::Shaded) return true;
  if (isGauss(mode)) return gauss_.has_value();
  if (showsDistortion(mode)) return values_.contains(mode);
  if (mode == ColorMode::Checkerboard) return uv_.has_value();
  if (mode == ColorMode::FloodTime || mode == ColorMode::FloodOrder) return flood_->size() > 0;
  return charts_->labelled() || flood_->size() > 0;
}

glm::vec3 Renderer::chartColor(Index chart, const RenderSettings& settings) const {
  if (!charts_ || chart >= charts_->chartCount()) return colors::kDry;
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

}  // namespace chartflood
