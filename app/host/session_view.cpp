#include "app/host/session_view.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "app/host/checker_picture.h"
#include "app/host/session_legend.h"
#include "core/base/error.h"
#include "render/chart_palette.h"
#include "render/color_map.h"

namespace chartflood {

namespace {

using Numbers = std::vector<double>;

/// The limits of the checkerboard's action.

/// One named setting: how it is read off and set. `set` says whether the value could be used.
struct ViewRow {
  const char* name;
  std::function<SessionValue(const ViewSettings&)> get;
  std::function<bool(ViewSettings&, const SessionValue&)> set;
  std::function<bool(const ViewSettings&)> present = {};  ///< none: always
};

/// A switch in a part of the settings.
template <typename Part>
ViewRow switchRow(const char* name, Part ViewSettings::*part, bool Part::*member) {
  return {name, [=](const ViewSettings& view) { return SessionValue(view.*part.*member); },
          [=](ViewSettings& view, const SessionValue& value) {
            const bool* on = std::get_if<bool>(&value);
            if (on != nullptr) view.*part.*member = *on;
            return on != nullptr;
          }};
}

ViewRow switchRow(const char* name, bool RenderSettings::*member) {
  return switchRow(name, &ViewSettings::render, member);
}

/// The numbers of a value when there are `count` finite ones, else null.
const Numbers* numbers(const SessionValue& value, std::size_t count) {
  const Numbers* list = std::get_if<Numbers>(&value);
  if (list == nullptr || list->size() != count) return nullptr;
  const bool finite =
      std::all_of(list->begin(), list->end(), [](double x) { return std::isfinite(x); });
  return finite ? list : nullptr;
}

std::vector<ViewRow> overlayRows() {
  return {switchRow("seams", &RenderSettings::seams),
          switchRow("cuts", &RenderSettings::cuts),
          switchRow("edges", &RenderSettings::edges),
          switchRow("sharp-edges", &RenderSettings::sharpEdges),
          switchRow("seed-marks", &RenderSettings::seedMarks),
          switchRow("numbers", &RenderSettings::numbers),
          switchRow("problems", &RenderSettings::problems),
          switchRow("scalar-bar", &RenderSettings::scalarBar),
          switchRow("smooth", &RenderSettings::smoothNormals),
          switchRow("invert-colors", &RenderSettings::invertColorMap)};
}

bool readColorMode(ViewSettings& view, const SessionValue& value) {
  const std::string* id = std::get_if<std::string>(&value);
  const ColorModeInfo* mode = id == nullptr ? nullptr : findColorMode(*id);
  if (mode == nullptr) return false;
  const auto modes = availableColorModes();
  if (std::find(modes.begin(), modes.end(), mode->mode) == modes.end()) return false;
  view.render.colorMode = mode->mode;
  return true;
}

bool readColorMap(ViewSettings& view, const SessionValue& value) {
  const std::string* id = std::get_if<std::string>(&value);
  if (id == nullptr || (!id->empty() && findColorMap(*id) == nullptr)) return false;
  view.render.colorMap = *id;
  return true;
}

bool readRange(ViewSettings& view, const SessionValue& value) {
  const Numbers* ends = numbers(value, 2);
  if (ends == nullptr || !((*ends)[0] < (*ends)[1])) return false;
  view.render.range = {(*ends)[0], (*ends)[1]};
  return true;
}

bool readLegends(ViewSettings& view, const SessionValue& value) {
  const std::string* text = std::get_if<std::string>(&value);
  return text != nullptr && applyLegends(*text, view);
}

SessionValue groundOf(const ViewSettings& view) {
  const Background& ground = view.render.background;
  return Numbers{ground.bottom.x,
                 ground.bottom.y,
                 ground.bottom.z,
                 ground.top.x,
                 ground.top.y,
                 ground.top.z,
                 ground.transparent ? 0.0 : 1.0};
}

bool readGround(ViewSettings& view, const SessionValue& value) {
  const Numbers* n = numbers(value, 7);
  const auto isShare = [](double x) { return x >= 0 && x <= 1; };
  if (n == nullptr || !std::all_of(n->begin(), n->end(), isShare)) return false;
  view.render.background = {glm::vec3((*n)[0], (*n)[1], (*n)[2]),
                            glm::vec3((*n)[3], (*n)[4], (*n)[5]), (*n)[6] == 0};
  return true;
}

/// A list of charts in the render settings, written down where it is not empty.
ViewRow chartsRow(const char* name, std::vector<Index> RenderSettings::*member) {
  return {name,
          [=](const ViewSettings& view) {
            const std::vector<Index>& charts = view.render.*member;
            return SessionValue(Numbers(charts.begin(), charts.end()));
          },
          [=](ViewSettings& view, const SessionValue& value) {
            const Numbers* list = std::get_if<Numbers>(&value);
            const auto isChart = [](double x) { return x >= 0 && x < kNone && x == std::floor(x); };
            const bool fits = list != nullptr && std::all_of(list->begin(), list->end(), isChart);
            if (fits) (view.render.*member).assign(list->begin(), list->end());
            return fits;
          },
          [=](const ViewSettings& view) { return !(view.render.*member).empty(); }};
}

SessionValue chartColorsOf(const ViewSettings& view) {
  return Numbers(view.chartColors.begin(), view.chartColors.end());
}

bool readChartColors(ViewSettings& view, const SessionValue& value) {
  const Numbers* list = std::get_if<Numbers>(&value);
  if (list == nullptr || list->size() > kNone) return false;
  std::vector<Index> numbers;
  const auto most = static_cast<double>(chartPaletteTable().front().colors.size());
  for (const double number : *list) {
    if (!(number >= 0 && number < most) || number != std::floor(number)) return false;
    numbers.push_back(static_cast<Index>(number));
  }
  view.chartColors = std::move(numbers);
  return true;
}

std::vector<ViewRow> colorRows() {
  const auto colorMode = [](const ViewSettings& view) {
    return SessionValue(std::string(colorModeInfo(view.render.colorMode).id));
  };
  const auto range = [](const ViewSettings& view) {
    return SessionValue(Numbers{view.render.range->first, view.render.range->second});
  };
  return {{"color-by", colorMode, readColorMode},
          {"colormap", [](const ViewSettings& view) { return SessionValue(view.render.colorMap); },
           readColorMap},
          {"range", range, readRange,
           [](const ViewSettings& view) { return view.render.range.has_value(); }},
          {"legends", [](const ViewSettings& view) { return SessionValue(legendsText(view)); },
           readLegends, [](const ViewSettings& view) { return !legendsText(view).empty(); }},
          {"background", groundOf, readGround},
          chartsRow("selected-charts", &RenderSettings::selectedCharts),
          chartsRow("hidden-charts", &RenderSettings::hiddenCharts),
          {"chart-colors", chartColorsOf, readChartColors,
           [](const ViewSettings& view) { return !view.chartColors.empty(); }}};
}

/// Degrees that give the angle again, to the last bit.
double exactDegrees(double angle) {
  double degrees = glm::degrees(angle);
  for (const double toward : {0.0, 360.0}) {
    double near = degrees;
    for (int step = 0; step < 4 && glm::radians(near) != angle; ++step) {
      near = std::nextafter(near, toward);
    }
    if (glm::radians(near) == angle) return near;
  }
  return degrees;
}

/// Target, orientation (w, x, y, z), distance, field of view (degrees), in this order.
SessionValue cameraOf(const ViewSettings& view) {
  const Camera& c = view.camera;
  return Numbers{c.target.x,      c.target.y,      c.target.z,
                 c.orientation.w, c.orientation.x, c.orientation.y,
                 c.orientation.z, c.distance,      exactDegrees(c.fieldOfView)};
}

bool readCamera(ViewSettings& view, const SessionValue& value) {
  const Numbers* n = numbers(value, 9);
  if (n == nullptr) return false;
  const glm::dquat turn((*n)[3], (*n)[4], (*n)[5], (*n)[6]);
  const double length = glm::length(turn), distance = (*n)[7], angle = (*n)[8];
  // Normalised units: beyond these nothing of the model could be seen.
  const bool sane = length > 1e-3 && length < 1e3 && distance > 1e-9 && distance < 1e6 &&
                    angle >= 1 && angle <= 170;
  if (!sane) return false;
  view.camera.target = {(*n)[0], (*n)[1], (*n)[2]};
  // Written with all digits: a turn of unit length is taken as it is.
  view.camera.orientation = std::abs(length - 1) < 1e-12 ? turn : glm::normalize(turn);
  view.camera.distance = distance;
  view.camera.fieldOfView = glm::radians(angle);
  view.frameWhenLoaded = false;
  return true;
}

std::vector<ViewRow> cameraRows() {
  return {{"camera", cameraOf, readCamera,
           [](const ViewSettings& view) { return !view.frameWhenLoaded; }},
          {"camera-orthographic",
           [](const ViewSettings& view) { return SessionValue(view.camera.orthographic); },
           [](ViewSettings& view, const SessionValue& value) {
             const bool* on = std::get_if<bool>(&value);
             if (on != nullptr) view.camera.orthographic = *on;
             return on != nullptr;
           }},
          {"up",
           [](const ViewSettings& view) {
             return SessionValue(std::string(view.camera.up == UpAxis::Z ? "+Z" : "+Y"));
           },
           [](ViewSettings& view, const SessionValue& value) {
             const std::string* axis = std::get_if<std::string>(&value);
             if (axis == nullptr || (*axis != "+Y" && *axis != "+Z")) return false;
             view.camera.up = *axis == "+Z" ? UpAxis::Z : UpAxis::Y;
             return true;
           }}};
}

ViewRow shareRow(const char* name, float RenderSettings::*member, double low, double high) {
  return {name, [=](const ViewSettings& view) { return SessionValue(double{view.render.*member}); },
          [=](ViewSettings& view, const SessionValue& value) {
            const double* number = std::get_if<double>(&value);
            const bool fits = number != nullptr && *number >= low && *number <= high;
            if (fits) view.render.*member = static_cast<float>(*number);
            return fits;
          }};
}

bool readCheckerKind(ViewSettings& view, const SessionValue& value) {
  const std::string* id = std::get_if<std::string>(&value);
  if (id == nullptr) return false;
  for (const CheckerKind kind :
       {CheckerKind::Squares, CheckerKind::Numbers, CheckerKind::Circles, CheckerKind::Picture}) {
    if (*id != checkerKindId(kind)) continue;
    view.render.checkerKind = kind;
    return true;
  }
  return false;
}

bool readCheckerFile(ViewSettings& view, const SessionValue& value) {
  const std::string* file = std::get_if<std::string>(&value);
  if (file == nullptr) return false;
  const CheckerKind kind = view.render.checkerKind;
  try {
    setCheckerPicture(*file, view);
  } catch (const ReadError&) {
    return false;
  }
  view.render.checkerKind = kind;
  return true;
}

std::vector<ViewRow> checkerRows() {
  const auto kind = [](const ViewSettings& view) {
    return SessionValue(std::string(checkerKindId(view.render.checkerKind)));
  };
  return {{"checker-kind", kind, readCheckerKind},
          {"checker-picture",
           [](const ViewSettings& view) { return SessionValue(view.checkerFile); }, readCheckerFile,
           [](const ViewSettings& view) { return !view.checkerFile.empty(); }},
          shareRow("checker-repeats", &RenderSettings::checkerRepeats, 1, kMostCheckerRepeats),
          shareRow("checker-size", &RenderSettings::checkerSquares, kFewestCheckerSquares,
                   kMostCheckerSquares),
          shareRow("checker-tint", &RenderSettings::checkerTint, 0, 1),
          switchRow("checker-in-texture", &RenderSettings::checkerInTexture)};
}

/// Middle (u, v) and span.
SessionValue uvCameraOf(const ViewSettings& view) {
  const UvCamera& c = view.uvCamera;
  return Numbers{c.center.x, c.center.y, c.span};
}

bool readUvCamera(ViewSettings& view, const SessionValue& value) {
  const Numbers* n = numbers(value, 3);
  if (n == nullptr) return false;
  const double u = (*n)[0], v = (*n)[1], span = (*n)[2];
  const bool sane = std::abs(u) < UvCamera::kMostSpan && std::abs(v) < UvCamera::kMostSpan &&
                    span >= UvCamera::kLeastSpan && span <= UvCamera::kMostSpan;
  if (sane) view.uvCamera = {{u, v}, span};
  return sane;
}

std::vector<ViewRow> uvRows() {
  return {switchRow("uv-fill", &ViewSettings::uv, &UvStyle::fill),
          switchRow("uv-frame", &ViewSettings::uv, &UvStyle::frame),
          {"uv-camera", uvCameraOf, readUvCamera}};
}

/// Orientation (w, x, y, z) of the Gauss sphere where it does not turn with the model.
SessionValue sphereTurnOf(const ViewSettings& view) {
  const glm::dquat& turn = view.sphereCamera.orientation;
  return Numbers{turn.w, turn.x, turn.y, turn.z};
}

bool readSphereTurn(ViewSettings& view, const SessionValue& value) {
  const Numbers* n = numbers(value, 4);
  if (n == nullptr) return false;
  const glm::dquat turn((*n)[0], (*n)[1], (*n)[2], (*n)[3]);
  const double length = glm::length(turn);
  if (length < 1e-3 || length > 1e3) return false;
  view.sphereCamera.orientation = std::abs(length - 1) < 1e-12 ? turn : glm::normalize(turn);
  return true;
}

std::vector<ViewRow> sphereRows() {
  const auto linked = [](const ViewSettings& view) { return SessionValue(view.sphereLinked); };
  const auto link = [](ViewSettings& view, const SessionValue& value) {
    const bool* on = std::get_if<bool>(&value);
    if (on != nullptr) view.sphereLinked = *on;
    return on != nullptr;
  };
  return {{"sphere-linked", linked, link},
          {"sphere-turn", sphereTurnOf, readSphereTurn,
           [](const ViewSettings& view) { return !view.sphereLinked; }}};
}

std::vector<ViewRow> viewRows() {
  std::vector<ViewRow> rows;
  for (const std::vector<ViewRow>& part :
       {colorRows(), overlayRows(), checkerRows(), cameraRows(), uvRows(), sphereRows()}) {
    rows.insert(rows.end(), part.begin(), part.end());
  }
  return rows;
}

}  // namespace

SessionView viewValues(const ViewSettings& view) {
  SessionView values;
  for (const ViewRow& row : viewRows()) {
    if (!row.present || row.present(view)) values[row.name] = row.get(view);
  }
  return values;
}

std::vector<std::string> applyViewValues(const SessionView& values, ViewSettings& view) {
  std::vector<std::string> left;
  const std::vector<ViewRow> rows = viewRows();
  for (const auto& [name, value] : values) {
    const auto row = std::find_if(rows.begin(), rows.end(),
                                  [&key = name](const ViewRow& each) { return key == each.name; });
    if (row == rows.end()) {
      left.push_back("The session's 'view/" + name +
                     "' is not known to this version; it is kept when the session is saved again.");
    } else if (!row->set(view, value)) {
      left.push_back("The session's value of 'view/" + name + "' cannot be used and was left out.");
    }
  }
  return left;
}

}  // namespace chartflood
