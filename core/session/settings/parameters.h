#pragma once
/// The parameter table: every number a user can turn is one row. Sliders, command-line options,
/// session files, help and tests are made from it.

#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace chartflood {

/// Values of all parameters; the initialisers are the defaults. Field comments name the option id.
struct Parameters {
  std::string weld = "auto";          ///< weld: auto, off or a distance in the file's units
  std::string method = "t-flooding";  ///< method
  int charts = 20;                    ///< charts: K
  /// K was asked for though it is the default. Other numbers always are; what is not asked for is
  /// no more than the features of the model, see chartsInForce().
  bool chartsAsked = false;
  double sharpAngle = 45;      ///< sharp-angle: T_a, degrees
  double speedPower = 1;       ///< speed-power: p of equation 7
  double speedEpsilon = 1e-3;  ///< speed-epsilon: epsilon of equation 7, share of max |K|
  double offsetDamping = 0.3;  ///< offset-damping: beta of section 3.5
  bool offsets = true;         ///< offsets
  bool lookahead = true;       ///< lookahead
  double areaShare = 1e-3;     ///< area-share: eta
  int rngSeed = 1;             ///< rng-seed
  int bestOf = 1;              ///< best-of: generator seeds that are tried
  double maxStretch = 1.1;     ///< max-stretch: L2 that charts=auto allows
  int maxIterations = 60;      ///< max-iterations
  int patience = 10;           ///< patience: n of section 3.4
  std::string keep = "best";   ///< keep: which round is kept at the end
  bool detectCycles = true;    ///< detect-cycles
  int settle = 4;              ///< settle: rounds without gain, seeds at rest
  std::string even = "auto";   ///< even: what charts are to have alike
  std::string vsaSeeding = "one-by-one";  ///< vsa-seeding
  bool vsaTeleport = true;                ///< vsa-teleport
  double mcgimLambda = 1;                 ///< mcgim-lambda
  std::string mcgimNormals = "frozen";    ///< mcgim-normals
  bool mcgimDisks = false;                ///< mcgim-disks
  std::string search = "auto";            ///< search
  std::string start = "auto";             ///< start
  std::string seeding = "spread";         ///< seeding
  std::string refine = "cuts";            ///< refine
  double balanceWeight = 1000;            ///< balance-weight: w
  double creaseWeight = 0.3;              ///< crease-weight
  double cleanUp = 1000;                  ///< clean-up: mu
  bool cutHandles = true;                 ///< cut-handles
  std::string handleSearch = "shortest";  ///< handle-search
  bool cutLoops = true;                   ///< cut-loops
  bool cutTips = true;                    ///< cut-tips
  double tip = 0.5;                       ///< tip: lengths of the boundary loop
  double reliefStretch = 1.5;             ///< relief-stretch: L2 stretch, 0 for none
  std::string unwrap = "free";            ///< unwrap
  std::string layout = "packed";          ///< layout
  int textureSize = 1024;                 ///< texture-size: pixels
  int margin = 8;                         ///< margin: pixels

  bool operator==(const Parameters&) const = default;
};

using ParameterValue = std::variant<bool, int, double, std::string>;

/// How a slider runs over its range.
enum class SliderScale {
  Linear,
  Log,      ///< equal ratios take equal lengths
  LogZero,  ///< like Log from sliderMin on, with 0 as one more place at the left end
};

/// The first stage that a change makes stale; all later ones follow.
enum class Stage {
  Mesh,
  Gauss,
  Graph,
  Seeds,
  Flood,
  Iterations,
  Refine,
  Cut,
  Unwrap,
  Layout,
  Request,  ///< none: read when something is asked for
};

/// One value of a choice parameter.
struct ParameterChoice {
  const char* id;
  const char* label;
};

/// One row of the table.
struct ParameterInfo {
  using Member = std::variant<bool Parameters::*, int Parameters::*, double Parameters::*,
                              std::string Parameters::*>;
  const char* id;      ///< option name without dashes, key in files
  const char* label;   ///< beside the slider
  const char* symbol;  ///< the paper's symbol, "" if it has none
  Member member;
  double sliderMin = 0, sliderMax = 1;  ///< range of the slider
  double hardMin = 0, hardMax = 1;      ///< range of what may be typed
  bool hardMinExcluded = false;         ///< hardMin itself is refused
  SliderScale scale = SliderScale::Linear;
  const char* unit = "";    ///< "deg", "sr", "" for plain numbers
  const char* format = "";  ///< printf format of the number on the slider
  Stage stage = Stage::Flood;
  const char* group = "";                     ///< section of the panel and of --help
  const char* help = "";                      ///< one or two sentences in an artist's words
  const char* source = "";                    ///< section of the paper, "" when beyond it
  std::vector<ParameterChoice> choices = {};  ///< of string parameters
  const char* method = "";                    ///< the only method that knows it; "": all
  const char* orNumber = "";  ///< name of a number above 0 that may stand for a choice; "": none
};

/// All rows in the order of the panel.
std::span<const ParameterInfo> parameterTable();

/// The row with this id, or nullptr.
const ParameterInfo* findParameter(std::string_view id);

ParameterValue parameterValue(const Parameters& values, const ParameterInfo& info);
ParameterValue parameterDefault(const ParameterInfo& info);

/// Stores a value after checking its type and hard range. A number of charts is asked for by it.
/// \throws UsageError that names the option, the value and what is allowed.
void setParameter(Parameters& values, const ParameterInfo& info, const ParameterValue& value);

/// Reads "20", "1e-3", "on", "false", "moves" and stores it. \throws UsageError
void setParameterFromText(Parameters& values, const ParameterInfo& info, std::string_view text);

/// How far vertices that are joined may lie apart, as buildMesh() takes it.
double weldDistance(const Parameters& values);

/// True when the row has its default, which a number of charts that is asked for never is.
bool isDefault(const Parameters& values, const ParameterInfo& info);
/// Gives the row its default.
void resetParameter(Parameters& values, const ParameterInfo& info);

/// Makes K a number that is asked for.
void askCharts(Parameters& values, int charts);

/// K of a model with so many features: the number asked for, else that of the parameters or of the
/// features, whichever is smaller.
std::size_t chartsInForce(const Parameters& values, std::size_t features);
/// The values with that number.
Parameters inForce(Parameters values, std::size_t features);

/// Why the row says nothing with these values, as a sentence: another method or a switch makes it
/// void. "" when it counts.
std::string whyUnused(const Parameters& values, const ParameterInfo& info);

/// Text that setParameterFromText reads back to the same value.
std::string parameterText(const ParameterValue& value);

/// The first stage in which two sets of values differ; false when none does.
bool firstDifference(const Parameters& a, const Parameters& b, Stage& stage);

/// True when values differ in nothing but how rounds go on and end: charts that were finished are
/// the same with both.
bool differOnlyInRounds(const Parameters& a, const Parameters& b);

/// Named values for a purpose.
struct Preset {
  const char* id;     ///< "paper"
  const char* label;  ///< "Paper"
  const char* help;
  std::vector<std::pair<const char*, ParameterValue>> values;
};
std::span<const Preset> presetTable();
const Preset* findPreset(std::string_view id);
/// Values of a preset over the defaults; the number of charts, asked for or not, the generator seed
/// and what is the model's (weld) stay as in `base` unless the preset names them.
Parameters applyPreset(const Parameters& base, const Preset& preset);

}  // namespace chartflood
