#include "app/host/files/session_view.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "app/host/files/checker_picture.h"
#include "app/host/files/session_legend.h"
#include "app/host/files/session_view_rows.h"
#include "core/base/error.h"
#include "core/io/read/data_uri.h"
#include "core/io/read/reference_path.h"
#include "render/scene/chart_palette.h"
#include "render/scene/color_map.h"

namespace chartflood {

namespace {

constexpr const char* kCheckerPicture = "checker-picture";

ViewRow switchRow(const char* name, bool RenderSettings::*member) {
  return viewSwitch(name, &ViewSettings::render, member);
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
  const Numbers* ends = viewNumbers(value, 2);
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
  const Numbers* n = viewNumbers(value, 7);
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
    dropCheckerPicture(view);  // squares, instead of a picture that is not there
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
          {kCheckerPicture, [](const ViewSettings& view) { return SessionValue(view.checkerFile); },
           readCheckerFile, [](const ViewSettings& view) { return !view.checkerFile.empty(); }},
          shareRow("checker-repeats", &RenderSettings::checkerRepeats, 1, kMostCheckerRepeats),
          shareRow("checker-size", &RenderSettings::checkerSquares, kFewestCheckerSquares,
                   kMostCheckerSquares),
          shareRow("checker-tint", &RenderSettings::checkerTint, 0, 1),
          switchRow("checker-in-texture", &RenderSettings::checkerInTexture)};
}

std::vector<ViewRow> viewRows() {
  std::vector<ViewRow> rows;
  for (const std::vector<ViewRow>& part :
       {colorRows(), overlayRows(), checkerRows(), cameraRows()}) {
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

namespace {

/// The value with which a picture may be opened; nothing, with the reason, when it must not be.
std::optional<SessionValue> pictureInside(const SessionValue& value,
                                          const std::filesystem::path& folder,
                                          std::string& refusal) {
  const std::string* name = std::get_if<std::string>(&value);
  if (name == nullptr) return value;  // refused by its kind
  const Reference picture =
      folder.empty() ? Reference{{}, "was not opened"} : findReference(folder, *name);
  if (picture) return picture.file.string();
  refusal = "The picture " + shownName(*name) + " on the session's checkerboard " +
            (folder.empty() ? picture.refusal : "was not opened: it " + picture.refusal) +
            "; squares are shown in its place.";
  return std::nullopt;
}

}  // namespace

std::vector<std::string> applyViewValues(const SessionView& values, ViewSettings& view,
                                         const std::filesystem::path& folder) {
  std::vector<std::string> left;
  const std::vector<ViewRow> rows = viewRows();
  for (auto [name, value] : values) {
    if (name == kCheckerPicture) {
      std::string refusal;
      const std::optional<SessionValue> inside = pictureInside(value, folder, refusal);
      if (!inside) {
        left.push_back(std::move(refusal));
        if (view.render.checkerKind == CheckerKind::Picture) dropCheckerPicture(view);
        continue;
      }
      value = *inside;
    }
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
