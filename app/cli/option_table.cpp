#include "app/cli/option_table.h"

#include "app/host/settings/preferences.h"
#include "core/session/settings/parameters.h"
#include "render/scene/render_settings.h"

namespace chartflood {

namespace {

std::string joined(const std::vector<std::string>& words, const std::string& between = "|") {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
  return text;
}

std::string valueName(const ParameterInfo& info) {
  if (std::holds_alternative<bool Parameters::*>(info.member)) return "";
  std::vector<std::string> choices;
  for (const ParameterChoice& choice : info.choices) {
    choices.push_back(choice.id);
  }
  if (*info.orNumber != '\0') choices.push_back(info.orNumber);
  if (!choices.empty()) return joined(choices);
  const std::string unit = info.unit;
  return unit == "deg" ? "DEG" : "N";
}

std::string parameterHelp(const ParameterInfo& info) {
  std::string text = info.help;
  text += " Default: " + parameterText(parameterDefault(info));
  const bool inPaper = *info.symbol != '\0' && *info.source != '\0';
  if (inPaper) text += std::string("; ") + info.symbol + " in the paper";
  return text + ".";
}

void addParameters(std::vector<OptionInfo>& table) {
  for (const ParameterInfo& info : parameterTable()) {
    table.push_back({info.id, valueName(info), "Segmentation", parameterHelp(info)});
  }
  std::vector<std::string> presets;
  for (const Preset& preset : presetTable()) presets.push_back(preset.id);
  table.push_back(
      {"preset", joined(presets), "Segmentation",
       "Values for a purpose, also one saved in the window; options given beside it win. "
       "paper: the printed method."});
  table.push_back({"seeds", "F,F,..", "Segmentation",
                   "Faces of the file (the first is 0) at which the charts begin."});
  table.push_back({"hints", "F.txt", "Segmentation",
                   "Edges by the numbers of their vertices in the file (the first is 0), one a "
                   "line: \"cut 12 57\" where a seam is welcome, \"never 12 57\" where none is."});
  table.push_back({"steps", "N", "Segmentation",
                   "Stop the first flood after N faces were taken: the rest stays free."});
  table.push_back({"iterations", "N", "Segmentation",
                   "Stop after N rounds of flooding; borders stay as flooded."});
}

/// Rows of settings that are options.
template <typename Owner>
void addSettings(std::vector<OptionInfo>& table, const SettingTable<Owner>& rows,
                 const std::string& group) {
  const Owner defaults{};
  for (const Setting<Owner>& row : rows) {
    if (!row.option) continue;
    table.push_back({row.id, formText(row.value.domain), group,
                     std::string(row.help) + " Default: " + row.text(defaults) + row.note + "."});
  }
}

void addFiles(std::vector<OptionInfo>& table) {
  const std::string group = "Results (any of these: no window)";
  table.push_back({"output", "F.png", group, "A picture, see below."});
  table.push_back({"export-labels", "F.txt", group,
                   "One chart number per face of the file, in its order; -1: no chart."});
  table.push_back({"export-mesh", "F.(obj|ply|glb)", group,
                   "The mesh with texture coordinates and charts; OBJ and PLY keep vertices, faces "
                   "and their order."});
  table.push_back({"export-uv", "F.(png|svg)", group, "The charts in the texture, as a picture."});
  table.push_back({"export-seams", "F.obj", group,
                   "Borders between charts and cuts, as lines on the file's vertices."});
  table.push_back({"save-session", "F.chartflood", group,
                   "The work as it is, to go on with: give the file instead of a mesh."});
  table.push_back({"overwrite", "", group,
                   "Results may replace the very file that they are made from, with all that they "
                   "do not carry. Default: off."});
  table.push_back({"compare", "METHOD,METHOD,..", group,
                   "Several methods with the same number of charts, the same cuts and unwrap: a "
                   "table on standard output, --output side by side (with several modes in "
                   "--color-by below each other), --report with all results."});
  table.push_back(
      {"report", "F.json", group, "All figures as JSON; - writes them to standard output."});
}

void addPicture(std::vector<OptionInfo>& table) {
  const std::string group = "Picture and view";
  const auto add = [&](const char* name, const char* value, const std::string& help) {
    table.push_back({name, value, group, help});
  };
  add("color-by", "MODE", joined(colorModeIds(), ", ") + ". Default: charts.");
  add("colormap", "NAME", "Colours of values; --list-colormaps names them.");
  add("range", "MIN,MAX", "Values at the ends of the colour map. Default: from the values.");
  add("color-scale", "auto|linear|root|log",
      "How values run along the colours. Default: auto, the mode's own.");
  add("color-steps", "N", "So many flat colours, 2 to 32, instead of a smooth run; 0: smooth.");
  add("invert-colors", "", "Swaps the ends of the colour map. Default: off.");
  add("clamp-colors", "",
      "Values out of the range have its end colours; off: such faces are grey. Default: on.");
  add("problems", "",
      "Marks what deserves attention: flipped, overlapping or thin charts, sharp edges that no "
      "border follows. Default: off.");
  add("background", "COLOR",
      "dark, white, black, #RRGGBB, R,G,B with 0..255, or transparent. Default: dark.");
  add("seams", "", "Lines where charts meet. Default: on.");
  add("cuts", "", "Lines along which charts are cut open. Default: on.");
  add("edges", "", "The edges of the mesh. Default: off.");
  add("sharp-edges", "", "The edges that are folded more than the sharp edge angle. Default: off.");
  add("seed-marks", "", "Marks at the seeds. Default: on.");
  add("numbers", "", "Chart numbers on the charts. Default: off.");
  add("scalar-bar", "", "The scale of the colours. Default: on where colours stand for values.");
  add("resolution", "W,H", "Size of the picture in pixels. Default: 1280,960.");
  add("supersampling", "1|2|4", "Samples a pixel in each direction, for smooth lines. Default: 2.");
  add("line-scale", "N", "How large lines and letters are. Default: by the picture's size.");
  add("like", "F.png",
      "The same picture again: charts, view and size of one that the window saved, of the given "
      "mesh "
      "or the one beside it. Options given as well win.");
  add("view", "3d|uv|both", "The model, its texture, or both side by side. Default: 3d.");
  add("turntable", "N",
      "So many pictures of a whole turn about the upright axis instead of one: F_001.png, ..");
  add("flood-film", "N",
      "So many pictures of the last flood on its way; the last one shows the charts: F_001.png, "
      "..");
}

void addCamera(std::vector<OptionInfo>& table) {
  const auto add = [&](const char* name, const char* value, const char* help) {
    table.push_back({name, value, "Camera", help});
  };
  add("camera-direction", "X,Y,Z", "Look along this direction; the model fills the picture.");
  add("camera-position", "X,Y,Z", "The eye, in the model's units.");
  add("camera-focal-point", "X,Y,Z", "Look at this point, in the model's units.");
  add("camera-view-up", "X,Y,Z", "This direction points up in the picture.");
  add("camera-view-angle", "DEG", "Height of the field of view. Default: 30.");
  add("camera-zoom-factor", "N", "Above 1: closer.");
  add("camera-azimuth-angle", "DEG", "Turn about the upright axis.");
  add("camera-elevation-angle", "DEG", "Turn up or down.");
  add("camera-orthographic", "", "Without perspective. Default: off.");
  add("up", "auto|+Y|+Z",
      "The axis of the model that stands upright. Auto: as the format says or the model stands. "
      "Default: auto.");
}

void addGeneral(std::vector<OptionInfo>& table) {
  const auto add = [&](const char* name, const char* value, const char* help) {
    table.push_back({name, value, "General", help});
  };
  addSettings(table, preferenceTable(), "General");
  add("sample", "NAME", "Use a model that the program makes; --list-samples names them.");
  add("triangles", "N", "About how many triangles the sample gets.");
  add("threads", "N", "Threads to work with; 0: one a core. Never changes a result. Default: 0.");
  add("rendering-backend", "auto|osmesa|egl", "What draws pictures without a window.");
  add("verbose", "LEVEL", "debug, info, warning, error or quiet. Default: warning.");
  add("info", "", "Say what the file holds and what was repaired, and leave.");
  add("list-samples", "", "Name the samples, and leave.");
  add("list-colormaps", "", "Name the colour maps, and leave.");
  add("list-bindings", "", "Name the keys of the window, and leave.");
  add("help", "", "Say this, and leave.");
  add("version", "", "Say the version, and leave.");
}

std::vector<OptionInfo> makeTable() {
  std::vector<OptionInfo> table;
  addParameters(table);
  addFiles(table);
  addPicture(table);
  addCamera(table);
  addGeneral(table);
  return table;
}

}  // namespace

std::span<const OptionInfo> optionTable() {
  static const std::vector<OptionInfo> table = makeTable();
  return table;
}

std::vector<std::string> colorModeIds() {
  std::vector<std::string> ids;
  for (const ColorModeInfo& info : colorModeTable()) ids.push_back(info.id);
  return ids;
}

}  // namespace chartflood
