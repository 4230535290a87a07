#include "render/passes/renderer.h"

#include <utility>

#include "render/passes/renderer_colors.h"

namespace chartflood {

Renderer::Renderer()
    : backgroundProgram_("background.vert", "background.frag"),
      lineProgram_("lines.vert", "lines.frag"), pointProgram_("points.vert", "points.frag"),
      idProgram_("ids.vert", "ids.frag"),
      idUvProgram_("ids.vert", "ids.frag", std::vector<std::string>{"IN_TEXTURE"}),
      emptyVertexArray_(gl::VertexArray::create()) {
  seeds_.upload<glm::vec4>(GL_RGBA32F, {});
}

bool Renderer::show(const render::Scene& scene, std::size_t mostOfFlood) {
  checkScene(scene);
  const render::Scene before = std::exchange(scene_, scene);
  scene_.source.taken = before.source.taken;
  if (scene_.source.mesh != mesh_) {
    showMesh(scene_);
    if (mesh_) return show(scene, mostOfFlood);
  }
  if (!mesh_) return true;
  showVertices(before);
  showCharts(before);
  const bool whole = showFlood(before, mostOfFlood);
  if (scene_.seeds != before.seeds && scene_.seeds) {
    std::vector<glm::dvec3> places;
    for (const SeedMark& seed : *scene_.seeds) {
      if (seed.chart == places.size()) places.push_back(faceMiddle(*mesh_, seed.face));
    }
    charts_->setSeeds(places);
  }
  showLines(before);
  std::erase_if(values_, [&](const auto& each) {
    return each.second.of != neededBy(each.first, scene_.source);
  });
  return whole;
}

/// Forgets everything about the mesh before. What else the scene has is still to be shown.
void Renderer::showMesh(const render::Scene& scene) {
  unfinished_.reset();
  mesh_ = scene.source.mesh;
  scene_ = {};
  scene_.source.mesh = mesh_;
  surface_.reset();
  charts_.reset();
  flood_.reset();
  gauss_.reset();
  values_.clear();
  uv_.reset();
  cuts_.reset();
  lines_.clear();
  marks_.reset();
  if (!mesh_) return;
  bounds_ = boundingSphere(mesh_->positions());
  surface_.emplace(*mesh_);
  charts_.emplace(mesh_);
  flood_.emplace(mesh_);
}

/// Vertices, with the places that a texture gives them.
void Renderer::showVertices(const render::Scene& before) {
  const std::shared_ptr<const UvLayout>& layout = scene_.source.layout;
  const bool otherLayout = layout != before.source.layout;
  if (otherLayout) {
    unfinished_.reset();
    surface_->forgetSimple();
    uv_.reset();
    if (layout && !layout->empty()) uv_.emplace(mesh_, layout);
  }
  if (otherLayout || scene_.vertices != before.vertices || !surface_->hasVertices()) {
    unfinished_.reset();
    const auto plain = scene_.vertices ? scene_.vertices : surfaceVertices(*mesh_, nullptr);
    if (!uv_)
      surface_->setVertices(*plain);
    else
      surface_->setVertices(scene_.parted ? *scene_.parted
                                          : *partedVertices(*plain, layout->corners));
  }
  if (scene_.simple != before.simple) {
    unfinished_.reset();
    if (scene_.simple && !scene_.simple->empty())
      surface_->setSimple(*scene_.simple);
    else
      surface_->forgetSimple();
  }
}

void Renderer::showCharts(const render::Scene& before) {
  const ModeSource &now = scene_.source, &then = before.source;
  if (now.gauss != then.gauss) {
    gauss_.reset();
    if (now.gauss) gauss_.emplace(*now.gauss);
  }
  if (scene_.chartColors != before.chartColors && scene_.chartColors) {
    charts_->paint(*scene_.chartColors);
  }
  if (now.segmentation != then.segmentation && now.segmentation) {
    charts_->setSegmentation(*now.segmentation);
  }
  if (now.segmentation != then.segmentation || scene_.labels != before.labels) {
    charts_->setLabels(shownLabels(scene_));
  }
}

bool Renderer::showFlood(const render::Scene& before, std::size_t most) {
  ModeSource& source = scene_.source;
  if (source.record != before.source.record) flood_->follow(source.record);
  const bool whole = flood_->update(source.recorded, most);
  source.taken = flood_->size();
  charts_->growTo(flood_->chartCount());
  return whole;
}

void Renderer::showLines(const render::Scene& before) {
  const bool otherLayout = scene_.source.layout != before.source.layout;
  if (scene_.cuts != before.cuts) {
    cuts_.reset();
    if (scene_.cuts) cuts_.emplace(*mesh_, *scene_.cuts);
  }
  if (uv_ && (otherLayout || scene_.cuts != before.cuts)) {
    uv_->setCuts(cuts_ ? std::span<const CutEdge>(cuts_->edges()) : std::span<const CutEdge>());
  }
  if (scene_.lines != before.lines) {
    lines_.clear();
    if (scene_.lines) {
      for (const EdgeLines& each : *scene_.lines) {
        lines_.push_back({CutLayer(*mesh_, each.sides), {{}, each.color, each.width, each.dashed}});
      }
    }
  }
  if (scene_.marks != before.marks) {
    marks_.reset();
    if (scene_.marks) marks_.emplace(*mesh_, *scene_.marks);
  }
  if (marks_ && (otherLayout || scene_.marks != before.marks)) {
    marks_->setTexture(*mesh_, uv_ ? &uv_->layout() : nullptr);
  }
}

std::span<const Index> Renderer::chartColorNumbers() const {
  return charts_ ? charts_->colorNumbers() : std::span<const Index>{};
}

bool Renderer::canShow(ColorMode mode) const { return chartflood::canShow(mode, scene_.source); }

glm::vec3 Renderer::chartColor(Index chart, const RenderSettings& settings) const {
  if (!charts_ || chart >= charts_->chartCount()) return colors::kDry;
  return charts_->chartColor(chart, settings.palette);
}

Renderer::ValueLayer& Renderer::valuesOf(ColorMode mode) const {
  const auto found = values_.find(mode);
  if (found != values_.end()) return found->second;
  ValueLayer& layer = values_[mode];
  layer.of = neededBy(mode, scene_.source);
  const ModeValues made = modeValues(mode, scene_.source);
  layer.range = made.range;
  layer.values.reserve(made.values.size());
  for (const WeightedValue& each : made.values) {
    layer.values.push_back(static_cast<float>(each.value));
  }
  return layer;
}

std::optional<ScalarRange> Renderer::scalarRange(const RenderSettings& settings) const {
  const ColorMode mode = settings.colorMode;
  const ColorModeInfo& info = colorModeInfo(mode);
  if (*info.colorMap == '\0' || !canShow(mode)) return std::nullopt;
  // What a flood has taken is known on the graphics card alone.
  const bool known = info.domain == ValueDomain::Flood || info.values == nullptr;
  return chosenRange(known ? modeRange(mode, {}) : valuesOf(mode).range, settings);
}

}  // namespace chartflood
