#include "render/scene/color_modes.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <numeric>

#include <glm/geometric.hpp>

#include "core/base/check.h"
#include "render/scene/mode_values.h"

namespace chartflood {

namespace {

using Row = const ColorModeInfo&;

/// One value a triangle.
template <typename Values>
std::vector<WeightedValue> ofTriangles(const Mesh& mesh, const Values& values) {
  std::vector<WeightedValue> weighted;
  weighted.reserve(values.size());
  for (std::size_t t = 0; t < values.size(); ++t) {
    weighted.push_back({double{values[t]}, mesh.triangleArea()[t]});
  }
  return weighted;
}

/// What the unwrap measured of each triangle.
template <std::vector<float> Unwrap::*kMeasure>
ModeValues distortionValues(Row row, const ModeSource& source) {
  ModeValues made{ofTriangles(*source.mesh, *source.unwrap.*kMeasure), {}};
  made.range = modeRange(row.mode, made.values);
  return made;
}

ModeValues gaussFaceValues(Row, const ModeSource& source) {
  return {ofTriangles(*source.mesh, source.gauss->faces), source.gauss->faceRange};
}

ModeValues gaussEdgeValues(Row, const ModeSource& source) {
  const std::vector<glm::vec4>& edges = source.gauss->edges;
  ModeValues made{{}, source.gauss->edgeRange};
  for (std::size_t i = 0; i + 1 < edges.size(); i += 2) {
    const double length = double{glm::distance(glm::vec3(edges[i]), glm::vec3(edges[i + 1]))};
    made.values.push_back({double{edges[i].w}, length});
  }
  return made;
}

ModeValues gaussVertexValues(Row, const ModeSource& source) {
  const std::vector<glm::vec4>& vertices = source.gauss->vertices;
  ModeValues made{{}, source.gauss->vertexRange};
  for (std::size_t i = 0; i + 1 < vertices.size(); i += 2) {
    made.values.push_back({double{vertices[i].w}, 1});
  }
  return made;
}

/// Gauss area of each chart against the mean, per cent: 0 carries the mean. Zeros where the mean
/// vanishes.
ModeValues balanceValues(Row row, const ModeSource& source) {
  std::vector<WeightedValue> values;
  if (source.stats) {
    for (const ChartFigures& chart : source.stats->charts) {
      values.push_back({chart.gaussArea, chart.area});
    }
  } else if (source.segmentation) {
    for (const double area : source.segmentation->areas.gaussArea) values.push_back({area, 1});
  }
  double sum = 0;
  for (const WeightedValue& each : values) sum += each.value;
  const double mean = values.empty() ? 0 : sum / static_cast<double>(values.size());
  for (WeightedValue& each : values) {
    const double balance = mean > 1e-9 ? 100 * (each.value / mean - 1) : 0;
    each.value = double{static_cast<float>(balance)};  // as the model has it
  }
  return {values, modeRange(row.mode, values)};
}

double faceArea(const Mesh& mesh, Index face) {
  double area = 0;
  for (Index t = mesh.triangleBegin(face); t < mesh.triangleBegin(face + 1); ++t) {
    area += mesh.triangleArea()[t];
  }
  return area;
}

/// One value a face that is taken, and one for all that are dry.
template <bool kOrder>
ModeValues floodValues(Row row, const ModeSource& source) {
  const FloodRecord& record = *source.record;
  std::vector<double> longest;
  for (std::size_t i = 0; i < source.recorded; ++i) {
    const Incorporation& entry = record[i];
    if (entry.chart >= longest.size()) longest.resize(entry.chart + 1, 0.0);
    longest[entry.chart] = std::max(longest[entry.chart], double{entry.time});
  }
  ModeValues made{{}, modeRange(row.mode, {})};
  made.values.reserve(source.taken + 1);
  double dry = 0;
  for (const double area : source.mesh->triangleArea()) dry += area;
  const auto all = static_cast<double>(source.mesh->faceCount());
  for (std::size_t i = 0; i < source.taken; ++i) {
    const Incorporation& entry = record[i];
    const double whole = longest[entry.chart];
    const double time = whole > 0 ? double{entry.time} / whole : 0;
    const double area = faceArea(*source.mesh, entry.face);
    made.values.push_back({kOrder ? static_cast<double>(i) / all : time, area});
    dry -= area;
  }
  if (source.taken < source.mesh->faceCount()) {
    made.values.push_back({std::numeric_limits<double>::quiet_NaN(), dry});
  }
  return made;
}

using enum ColorMode;
using Family = ColorFamily;
using Domain = ValueDomain;
using Need = ModeNeed;
using Fill = SurfaceFill;
using Rule = RangeRule;
using Scale = ScalarScale;

constexpr ColorModeInfo kModes[] = {
    {Shaded, "shaded", "Plain shaded", "", "", Scale::Linear, "", "The shape alone.", "1",
     Family::Shape, Domain::None, Need::Nothing, Fill::Plain, Rule::Shares, nullptr},
    {Charts, "charts", "Charts", "", "", Scale::Linear, "",
     "One colour a chart; neighbours differ.", "2", Family::Charts, Domain::None, Need::Charts,
     Fill::Charts, Rule::Shares, nullptr},
    {Gauss, "gauss", "Gauss area: all", "Gauss area", "", Scale::Linear, "ember",
     "Vertices, edges and faces together, each kind on its own range.", "3", Family::Gauss,
     Domain::All, Need::GaussArea, Fill::TriangleValue, Rule::PlainEnds, nullptr},
    {GaussVertex, "gauss-vertex", "Gauss area: vertices", "Gauss area of vertices", "sr",
     Scale::Root, "ember", "Corners, larger and redder the more area their normals span.", "",
     Family::Gauss, Domain::Vertex, Need::GaussArea, Fill::Plain, Rule::FromZero,
     gaussVertexValues},
    {GaussEdge, "gauss-edge", "Gauss area: edges", "Gauss area of edges, per length", "sr/d",
     Scale::Root, "ember",
     "Creases, thicker and redder the more area their normals span; d is the model's diagonal.", "",
     Family::Gauss, Domain::Edge, Need::GaussArea, Fill::Plain, Rule::FromZero, gaussEdgeValues},
    {GaussFace, "gauss-face", "Gauss area: faces", "Gauss area per area", "sr/d\u00B2",
     Scale::Linear, "ember",
     "How much area the normals of a face span for its size; d is the model's diagonal.", "",
     Family::Gauss, Domain::Triangle, Need::GaussArea, Fill::TriangleValue, Rule::FromZero,
     gaussFaceValues},
    {Balance, "balance", "Balance", "Gauss area of charts against the mean", "%", Scale::Linear,
     "blue-orange", "White charts carry the mean, blue ones less, orange more.", "4",
     Family::Balance, Domain::Chart, Need::Charts, Fill::ChartValue, Rule::AroundMean,
     balanceValues},
    {FloodTime, "flood-time", "Flood time", "Time within its chart", "", Scale::Linear, "viridis",
     "When a face was taken, as a share of its chart's own time.", "5", Family::Flood,
     Domain::Flood, Need::Flood, Fill::FloodTime, Rule::Shares, floodValues<false>},
    {FloodOrder, "flood-order", "Flood order", "Share of all faces taken", "", Scale::Linear,
     "viridis", "When a face was taken, counted over all charts.", "", Family::Flood, Domain::Flood,
     Need::Flood, Fill::FloodOrder, Rule::Shares, floodValues<true>},
    {Stretch, "stretch", "Stretch", "Stretch (L2)", "", Scale::Log, "ember",
     "How much a face is stretched by the unwrap; 1 is not at all.", "6", Family::Stretch,
     Domain::Triangle, Need::Unwrap, Fill::TriangleValue, Rule::FromOne,
     distortionValues<&Unwrap::stretch>},
    {AreaDistortion, "area-distortion", "Area distortion", "Area distortion, log2", "",
     Scale::Linear, "purple-green", "White faces keep their share of area.", "7", Family::Area,
     Domain::Triangle, Need::Unwrap, Fill::TriangleValue, Rule::AroundZero,
     distortionValues<&Unwrap::area>},
    {AngleDistortion, "angle-distortion", "Angle distortion", "Angle distortion", "", Scale::Log,
     "ember", "Longer over shorter axis of a small circle; 1 is round.", "8", Family::Angle,
     Domain::Triangle, Need::Unwrap, Fill::TriangleValue, Rule::FromOne,
     distortionValues<&Unwrap::angle>},
    {Checkerboard, "checkerboard", "Checkerboard", "", "", Scale::Linear, "",
     "Squares of the texture: they stay square and of one size where the unwrap is good.", "9",
     Family::Checker, Domain::Corner, Need::Texture, Fill::Checker, Rule::Shares, nullptr},
};

/// In the order of SurfaceFill, as surface.frag calls them.
constexpr const char* kFillNames[] = {"PLAIN",      "CHARTS",      "TRIANGLE_VALUE", "CHART_VALUE",
                                      "FLOOD_TIME", "FLOOD_ORDER", "CHECKER"};
static_assert(std::size(kFillNames) == static_cast<std::size_t>(SurfaceFill::Checker) + 1);

}  // namespace

std::span<const ColorModeInfo> colorModeTable() { return kModes; }

const ColorModeInfo& colorModeInfo(ColorMode mode) {
  const ColorModeInfo& info = kModes[static_cast<std::size_t>(mode)];
  CF_CHECK(info.mode == mode);
  return info;
}

const ColorModeInfo* findColorMode(std::string_view id) {
  const auto found = std::find_if(std::begin(kModes), std::end(kModes),
                                  [&](const ColorModeInfo& m) { return m.id == id; });
  return found == std::end(kModes) ? nullptr : &*found;
}

std::vector<ColorMode> colorModeFamily(ColorMode mode) {
  std::vector<ColorMode> family;
  for (const ColorModeInfo& info : kModes) {
    if (info.family == colorModeInfo(mode).family) family.push_back(info.mode);
  }
  return family;
}

bool needsUnwrap(ColorMode mode) {
  const ModeNeed needs = colorModeInfo(mode).needs;
  return needs == ModeNeed::Unwrap || needs == ModeNeed::Texture;
}

std::vector<std::string> fillMacros(SurfaceFill fill) {
  std::vector<std::string> macros;
  for (std::size_t i = 0; i < std::size(kFillNames); ++i) {
    macros.push_back(std::string("FILL_") + kFillNames[i] + ' ' + std::to_string(i));
  }
  macros.push_back(std::string("FILL FILL_") + kFillNames[static_cast<std::size_t>(fill)]);
  return macros;
}

}  // namespace chartflood
