// The rows of the parameter table and the presets: data, and the look-ups by id.

#include <algorithm>
#include <limits>

#include "core/session/parameters.h"

namespace chartflood {

namespace {

constexpr double kLargestInt = std::numeric_limits<int>::max();
constexpr double kMostCharts = 1e9;

std::vector<ParameterInfo> chartRows() {
  return {
      {.id = "charts",
       .label = "Charts",
       .symbol = "K",
       .member = &Parameters::charts,
       .sliderMin = 1,
       .sliderMax = 100,
       .hardMin = 1,
       .hardMax = kMostCharts,
       .scale = SliderScale::Log,
       .format = "%.0f",
       .stage = Stage::Seeds,
       .group = "Charts",
       .help = "How many pieces to cut the model into. More pieces: less stretching, more seams.",
       .source = "3.4"},
      {.id = "max-stretch",
       .label = "Allowed stretch",
       .symbol = "",
       .member = &Parameters::maxStretch,
       .sliderMin = 1.01,
       .sliderMax = 2,
       .hardMin = 1.001,
       .hardMax = 100,
       .scale = SliderScale::Log,
       .format = "%.2f",
       .stage = Stage::Request,
       .group = "Charts",
       .help = "\"Fewest pieces\" and --charts=auto look for the smallest number of pieces that "
               "stretches no more than this. 1 is none.",
       .source = ""},
      {.id = "sharp-angle",
       .label = "Sharp edge angle",
       .symbol = "T_a",
       .member = &Parameters::sharpAngle,
       .sliderMin = 0,
       .sliderMax = 180,
       .hardMin = 0,
       .hardMax = 180,
       .unit = "deg",
       .format = "%.0f",
       .stage = Stage::Gauss,
       .group = "Charts",
       .help =
           "Edges folded more than this count as real creases. Lower it to respect soft bevels, "
           "raise it to treat the model as smooth clay.",
       .source = "3.2"},
      {.id = "speed-power",
       .label = "Crease avoidance",
       .symbol = "p",
       .member = &Parameters::speedPower,
       .sliderMin = 1,
       .sliderMax = 6,
       .hardMin = 0,
       .hardMax = 10,
       .format = "%.1f",
       .stage = Stage::Graph,
       .group = "Charts",
       .help =
           "How strongly the flood shies away from curved spots. Low: round, even pieces. High: "
           "borders cling to creases and corners.",
       .source = "3.3, eq. 7",
       .method = "t-flooding"},
      {.id = "speed-epsilon",
       .label = "Flat-area floor",
       .symbol = "\u03b5",
       .member = &Parameters::speedEpsilon,
       .sliderMin = 1e-6,
       .sliderMax = 1e-1,
       .hardMin = 1e-9,
       .hardMax = 1,
       .scale = SliderScale::Log,
       .format = "%.1e",
       .stage = Stage::Graph,
       .group = "Charts",
       .help =
           "Keeps flat areas from being swallowed at once. Larger: pieces spread more evenly and "
           "care less about curvature. A share of the largest curvature.",
       .source = "3.3, eq. 7",
       .method = "t-flooding"},
  };
}

std::vector<ParameterInfo> balanceRows() {
  return {
      {.id = "offsets",
       .label = "Balance by waiting",
       .symbol = "",
       .member = &Parameters::offsets,
       .stage = Stage::Iterations,
       .group = "Balance",
       .help = "Pieces that got too much in the last round start later in the next one.",
       .source = "3.5",
       .method = "t-flooding"},
      {.id = "offset-damping",
       .label = "Waiting strength",
       .symbol = "\u03b2",
       .member = &Parameters::offsetDamping,
       .sliderMin = 0.05,
       .sliderMax = 1,
       .hardMin = 0,
       .hardMax = 1,
       .hardMinExcluded = true,
       .format = "%.2f",
       .stage = Stage::Iterations,
       .group = "Balance",
       .help =
           "How much of the imbalance is corrected per round. Lower if the borders keep jumping.",
       .source = "3.5",
       .method = "t-flooding"},
      {.id = "lookahead",
       .label = "Look ahead",
       .symbol = "",
       .member = &Parameters::lookahead,
       .stage = Stage::Flood,
       .group = "Balance",
       .help = "Looks at the next triangle before deciding whose turn it is. Smoother balance.",
       .source = "3.3",
       .method = "t-flooding"},
      {.id = "area-share",
       .label = "Even out flat areas",
       .symbol = "\u03b7",
       .member = &Parameters::areaShare,
       .sliderMin = 1e-5,
       .sliderMax = 0.1,
       .hardMin = 0,
       .hardMax = 1,
       .scale = SliderScale::LogZero,
       .format = "%.5g",
       .stage = Stage::Flood,
       .group = "Balance",
       .help = "Lets plain surface count a little too, so that flat parts are shared fairly.",
       .source = "",
       .method = "t-flooding"},
      {.id = "rng-seed",
       .label = "Random seed",
       .symbol = "",
       .member = &Parameters::rngSeed,
       .sliderMin = 0,
       .sliderMax = 1000,
       .hardMin = 0,
       .hardMax = kLargestInt,
       .format = "%.0f",
       .stage = Stage::Seeds,
       .group = "Balance",
       .help = "Same number, same result. Roll for another starting layout.",
       .source = "3.4"},
      {.id = "best-of",
       .label = "Best of",
       .symbol = "",
       .member = &Parameters::bestOf,
       .sliderMin = 1,
       .sliderMax = 8,
       .hardMin = 1,
       .hardMax = 64,
       .format = "%.0f",
       .stage = Stage::Request,
       .group = "Balance",
       .help =
           "Run to the end tries so many random seeds side by side and keeps the shortest seams "
           "among those with even pieces. 3 gains a few percent.",
       .source = ""},
  };
}

std::vector<ParameterInfo> borderRows() {
  return {
      {.id = "refine",
       .label = "Borders",
       .symbol = "",
       .member = &Parameters::refine,
       .stage = Stage::Refine,
       .group = "Borders",
       .help = "Shortest: seams as short as the balance allows. Tidied: only stairs are smoothed. "
               "As flooded: as in the paper.",
       .source = "",
       .choices = {{"cuts", "Shortest", true},
                   {"moves", "Tidied", true},
                   {"none", "As flooded", true}}},
      {.id = "balance-weight",
       .label = "Balance or short seams",
       .symbol = "",
       .member = &Parameters::balanceWeight,
       .sliderMin = 10,
       .sliderMax = 1e5,
       .hardMin = 0,
       .hardMax = 1e9,
       .scale = SliderScale::LogZero,
       .format = "%.0f",
       .stage = Stage::Refine,
       .group = "Borders",
       .help =
           "How much equal pieces count against short seams. Small: shortest. Large: most even. "
           "For shortest borders.",
       .source = "",
       .method = "t-flooding"},
      {.id = "crease-weight",
       .label = "Length of creases",
       .symbol = "",
       .member = &Parameters::creaseWeight,
       .sliderMin = 0.01,
       .sliderMax = 1,
       .hardMin = 0,
       .hardMax = 1000,
       .scale = SliderScale::Log,
       .format = "%.2f",
       .stage = Stage::Refine,
       .group = "Borders",
       .help =
           "What a crease counts in a seam's length. Small: seams run along creases. 1: creases "
           "count as any other edge. For shortest borders.",
       .source = ""},
      {.id = "clean-up",
       .label = "Tidy borders",
       .symbol = "\u03bc",
       .member = &Parameters::cleanUp,
       .sliderMin = 10,
       .sliderMax = 1e5,
       .hardMin = 0,
       .hardMax = 1e9,
       .scale = SliderScale::LogZero,
       .format = "%.0f",
       .stage = Stage::Refine,
       .group = "Borders",
       .help = "For tidied borders, and shortest ones that came out uneven. Small: straightest. "
               "Large: most even. 0: only their length counts.",
       .source = "",
       .method = "t-flooding"},
  };
}

std::vector<ParameterInfo> cuttingRows() {
  return {
      {.id = "cut-handles",
       .label = "Cut handles",
       .symbol = "",
       .member = &Parameters::cutHandles,
       .stage = Stage::Cut,
       .group = "Cutting",
       .help = "Cuts pieces with a handle, like the one of a cup, so that they can lie flat.",
       .source = "3.6"},
      {.id = "handle-search",
       .label = "Search for handles",
       .symbol = "",
       .member = &Parameters::handleSearch,
       .stage = Stage::Cut,
       .group = "Cutting",
       .help =
           "Shortest: the shortest cut around each handle. Wavefront: a growing front finds the "
           "handles, as in the paper.",
       .source = "3.6",
       .choices = {{"shortest", "Shortest", true}, {"wavefront", "Wavefront", true}}},
      {.id = "cut-loops",
       .label = "Open into disks",
       .symbol = "",
       .member = &Parameters::cutLoops,
       .stage = Stage::Cut,
       .group = "Cutting",
       .help = "Cuts rings, tubes and closed pieces open, so that they can lie flat.",
       .source = "3.6"},
      {.id = "cut-tips",
       .label = "Cut tips",
       .symbol = "",
       .member = &Parameters::cutTips,
       .stage = Stage::Cut,
       .group = "Cutting",
       .help = "Slits long fingers open, so that they stretch less.",
       .source = "3.6"},
      {.id = "tip",
       .label = "Tip length",
       .symbol = "",
       .member = &Parameters::tip,
       .sliderMin = 0.1,
       .sliderMax = 2,
       .hardMin = 0.01,
       .hardMax = 100,
       .format = "%.2f",
       .stage = Stage::Cut,
       .group = "Cutting",
       .help = "How long a finger must be, against its rim, before it is slit open.",
       .source = "3.6"},
      {.id = "relief-stretch",
       .label = "Relief cuts",
       .symbol = "",
       .member = &Parameters::reliefStretch,
       .sliderMin = 1.05,
       .sliderMax = 5,
       .hardMin = 0,
       .hardMax = 1e6,
       .scale = SliderScale::LogZero,
       .format = "%.2f",
       .stage = Stage::Unwrap,
       .group = "Cutting",
       .help = "Slits a piece where it would stretch more than this. 0: never.",
       .source = ""},
  };
}

std::vector<ParameterInfo> unwrapRows() {
  return {
      {.id = "unwrap",
       .label = "Unwrap",
       .symbol = "",
       .member = &Parameters::unwrap,
       .stage = Stage::Unwrap,
       .group = "Unwrap",
       .help = "Free: the least stretch, nothing flipped, nothing overlapping. Circle: every piece "
               "fills a disk, as in the paper.",
       .source = "4",
       .choices = {{"free", "Free outline", true}, {"circle", "Circle", true}}},
      {.id = "layout",
       .label = "Layout",
       .symbol = "",
       .member = &Parameters::layout,
       .stage = Stage::Layout,
       .group = "Unwrap",
       .help = "Packed: all pieces at one scale, close together. Square: each piece in a square of "
               "its own, as in the paper.",
       .source = "4",
       .choices = {{"packed", "Packed", true}, {"square", "Squares", true}}},
      {.id = "texture-size",
       .label = "Texture size",
       .symbol = "",
       .member = &Parameters::textureSize,
       .sliderMin = 256,
       .sliderMax = 8192,
       .hardMin = 16,
       .hardMax = 16384,
       .scale = SliderScale::Log,
       .unit = "px",
       .format = "%.0f",
       .stage = Stage::Layout,
       .group = "Unwrap",
       .help = "Pixels on each side of the texture: what the margin is measured in.",
       .source = ""},
      {.id = "margin",
       .label = "Margin",
       .symbol = "",
       .member = &Parameters::margin,
       .sliderMin = 0,
       .sliderMax = 64,
       .hardMin = 0,
       .hardMax = 4096,
       .unit = "px",
       .format = "%.0f",
       .stage = Stage::Layout,
       .group = "Unwrap",
       .help = "Empty pixels between the pieces, so that paint does not bleed.",
       .source = ""},
  };
}

std::vector<ParameterInfo> stoppingRows() {
  return {
      {.id = "max-iterations",
       .label = "Most iterations",
       .symbol = "",
       .member = &Parameters::maxIterations,
       .sliderMin = 1,
       .sliderMax = 200,
       .hardMin = 1,
       .hardMax = 10000,
       .scale = SliderScale::Log,
       .format = "%.0f",
       .stage = Stage::Iterations,
       .group = "Stopping",
       .help = "Stop after this many rounds even if still improving.",
       .source = "3.4"},
      {.id = "patience",
       .label = "Patience",
       .symbol = "n",
       .member = &Parameters::patience,
       .sliderMin = 1,
       .sliderMax = 50,
       .hardMin = 1,
       .hardMax = 1000,
       .format = "%.0f",
       .stage = Stage::Iterations,
       .group = "Stopping",
       .help = "Stop when this many rounds brought no better balance.",
       .source = "3.4",
       .method = "t-flooding"},
      {.id = "keep",
       .label = "Keep",
       .symbol = "",
       .member = &Parameters::keep,
       .stage = Stage::Iterations,
       .group = "Stopping",
       .help = "Which round is kept once a stop rule fires: the best one or the last.",
       .source = "3.4",
       .choices = {{"best", "Best round", true}, {"last", "Last round", true}}},
      {.id = "settle",
       .label = "Settle",
       .symbol = "",
       .member = &Parameters::settle,
       .sliderMin = 0,
       .sliderMax = 20,
       .hardMin = 0,
       .hardMax = 1000,
       .format = "%.0f",
       .stage = Stage::Iterations,
       .group = "Stopping",
       .help =
           "Once moving the seeds no longer helps, keep them and even out by waiting alone, until "
           "this many rounds brought nothing. 0: stop at once, as in the paper.",
       .source = "",
       .method = "t-flooding"},
      {.id = "detect-cycles",
       .label = "Stop on a loop",
       .symbol = "",
       .member = &Parameters::detectCycles,
       .stage = Stage::Iterations,
       .group = "Stopping",
       .help = "Stop when the seeds return to a place they had before.",
       .source = "3.4"},
  };
}

std::vector<ParameterInfo> methodRows() {
  return {
      {.id = "method",
       .label = "Method",
       .symbol = "",
       .member = &Parameters::method,
       .stage = Stage::Seeds,
       .group = "Method",
       .help = "How the pieces are found.",
       .source = "3",
       .choices = {{"t-flooding", "T-flooding", true},
                   {"vsa", "Variational shape approximation", true},
                   {"mcgim", "Multi-chart geometry images", true}}},
      {.id = "vsa-seeding",
       .label = "Coming to pieces",
       .symbol = "",
       .member = &Parameters::vsaSeeding,
       .stage = Stage::Seeds,
       .group = "Method",
       .help =
           "One by one: a new piece where the planes fit worst. Doubling: one in every piece at "
           "once. Random: all at once anywhere.",
       .source = "",
       .choices = {{"one-by-one", "One by one", true},
                   {"doubling", "Doubling", true},
                   {"random", "Random", true}},
       .method = "vsa"},
      {.id = "vsa-teleport",
       .label = "Move stuck pieces",
       .symbol = "",
       .member = &Parameters::vsaTeleport,
       .stage = Stage::Iterations,
       .group = "Method",
       .help = "Joins two pieces that hardly differ and spends the freed one where the planes fit "
               "worst.",
       .source = "4",
       .method = "vsa"},
      {.id = "mcgim-lambda",
       .label = "Roundness",
       .symbol = "\u03bb",
       .member = &Parameters::mcgimLambda,
       .sliderMin = 1,
       .sliderMax = 10,
       .hardMin = 0.1,
       .hardMax = 1000,
       .scale = SliderScale::Log,
       .format = "%.2f",
       .stage = Stage::Flood,
       .group = "Method",
       .help = "Low: pieces keep to flat ground and end at folds. High: round pieces, wherever the "
               "folds are.",
       .source = "",
       .method = "mcgim"},
      {.id = "mcgim-normals",
       .label = "Facing of a piece",
       .symbol = "",
       .member = &Parameters::mcgimNormals,
       .stage = Stage::Flood,
       .group = "Method",
       .help = "Frozen: which way a piece faces is that of the round before. Running: it follows "
               "the piece as it grows.",
       .source = "",
       .choices = {{"frozen", "Frozen", true}, {"running", "Running", true}},
       .method = "mcgim"},
      {.id = "mcgim-disks",
       .label = "Grow as disks",
       .symbol = "",
       .member = &Parameters::mcgimDisks,
       .stage = Stage::Flood,
       .group = "Method",
       .help =
           "Pieces refuse what would make them rings or give them holes, while there is anything "
           "else to take.",
       .source = "",
       .method = "mcgim"},
      {.id = "search",
       .label = "Search",
       .symbol = "",
       .member = &Parameters::search,
       .stage = Stage::Seeds,
       .group = "Method",
       .help =
           "Literal: the paper's rounds on the whole mesh, every step can be watched. Auto: the "
           "best one for the size of the mesh.",
       .source = "3.4",
       .choices = {{"auto", "Auto", true}, {"literal", "Literal", true}, {"fast", "Fast", false}},
       .method = "t-flooding"},
      {.id = "start",
       .label = "Start",
       .symbol = "",
       .member = &Parameters::start,
       .stage = Stage::Seeds,
       .group = "Method",
       .help =
           "Flood: seeds far apart, as in the paper. Creases: the parts between sharp edges, for "
           "machine parts. Auto: creases where these divide the model.",
       .source = "3.4",
       .choices = {{"auto", "Auto", true}, {"flood", "Flood", true}, {"creases", "Creases", true}},
       .method = "t-flooding"},
  };
}

std::vector<ParameterInfo> allRows() {
  std::vector<ParameterInfo> rows;
  for (std::vector<ParameterInfo> part : {chartRows(), balanceRows(), borderRows(), cuttingRows(),
                                          unwrapRows(), stoppingRows(), methodRows()}) {
    rows.insert(rows.end(), part.begin(), part.end());
  }
  return rows;
}

/// Settings that the printed method has and the defaults do not.
std::vector<std::pair<const char*, ParameterValue>> printedValues(double power) {
  return {{"method", std::string("t-flooding")},
          {"sharp-angle", 45.0},
          {"speed-power", power},
          {"speed-epsilon", 1e-4},
          {"offset-damping", 0.9},
          {"area-share", 0.0},
          {"settle", 0},
          {"search", std::string("literal")},
          {"start", std::string("flood")},
          {"refine", std::string("none")},
          {"handle-search", std::string("wavefront")},
          {"tip", 1.0},
          {"relief-stretch", 0.0},
          {"unwrap", std::string("circle")},
          {"layout", std::string("square")}};
}

std::vector<Preset> allPresets() {
  return {
      {"paper", "Paper",
       "The printed values: p 1, \u03b5 1e-4, \u03b2 0.9, borders as flooded, charts on circles.",
       printedValues(1)},
      {"paper-happy", "Paper: Happy", "The printed values for the Happy Buddha: p 3.",
       printedValues(3)},
      {"few-large",
       "Few large pieces",
       "Eight round pieces, as few seams as possible.",
       {{"charts", 8}, {"speed-power", 1.0}}},
      {"hard-surface",
       "Hard surface",
       "Machine parts: borders cling to creases, soft bevels too.",
       {{"sharp-angle", 30.0}, {"speed-power", 3.0}}},
      {"organic",
       "Organic",
       "Figures and scans: the model is treated as smooth clay.",
       {{"sharp-angle", 90.0}, {"speed-power", 2.0}}},
  };
}

}  // namespace

std::span<const ParameterInfo> parameterTable() {
  static const std::vector<ParameterInfo> rows = allRows();
  return rows;
}

const ParameterInfo* findParameter(std::string_view id) {
  const auto rows = parameterTable();
  const auto found = std::find_if(rows.begin(), rows.end(),
                                  [&](const ParameterInfo& row) { return id == row.id; });
  return found == rows.end() ? nullptr : &*found;
}

std::span<const Preset> presetTable() {
  static const std::vector<Preset> presets = allPresets();
  return presets;
}

const Preset* findPreset(std::string_view id) {
  const auto presets = presetTable();
  const auto found = std::find_if(presets.begin(), presets.end(),
                                  [&](const Preset& preset) { return id == preset.id; });
  return found == presets.end() ? nullptr : &*found;
}

}  // namespace chartflood
