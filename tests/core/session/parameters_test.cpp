// The parameter table: completeness, reading and refusing values, presets, spelling.

#include "core/base/spelling.h"
#include "core/session/settings/parameters.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <set>
#include <string>

#include "core/base/error.h"

namespace chartflood {
namespace {

const ParameterInfo& row(std::string_view id) {
  const ParameterInfo* info = findParameter(id);
  if (info == nullptr) throw std::logic_error("no row " + std::string(id));
  return *info;
}

std::string refusal(std::string_view id, std::string_view text) {
  Parameters values;
  try {
    setParameterFromText(values, row(id), text);
  } catch (const UsageError& error) {
    EXPECT_EQ(values, Parameters{}) << "a refused value was stored";
    return error.what();
  }
  ADD_FAILURE() << "--" << id << "=" << text << " was taken";
  return "";
}

TEST(ParameterTable, HasOneRowForEveryMember) {
  // A member without a row would keep the default when all rows are changed.
  Parameters changed;
  for (const ParameterInfo& info : parameterTable()) {
    std::visit(
        [&](auto member) {
          using T = std::remove_reference_t<decltype(changed.*member)>;
          if constexpr (std::is_same_v<T, std::string>)
            changed.*member += "x";
          else if constexpr (std::is_same_v<T, bool>)
            changed.*member = !(changed.*member);
          else
            changed.*member += 1;
        },
        info.member);
  }
  const Parameters defaults;
  EXPECT_EQ(parameterTable().size(), 41u);
  EXPECT_NE(changed.weld, defaults.weld);
  EXPECT_NE(changed.method, defaults.method);
  EXPECT_NE(changed.vsaSeeding, defaults.vsaSeeding);
  EXPECT_NE(changed.vsaTeleport, defaults.vsaTeleport);
  EXPECT_NE(changed.mcgimLambda, defaults.mcgimLambda);
  EXPECT_NE(changed.mcgimNormals, defaults.mcgimNormals);
  EXPECT_NE(changed.mcgimDisks, defaults.mcgimDisks);
  EXPECT_NE(changed.charts, defaults.charts);
  EXPECT_NE(changed.sharpAngle, defaults.sharpAngle);
  EXPECT_NE(changed.speedPower, defaults.speedPower);
  EXPECT_NE(changed.speedEpsilon, defaults.speedEpsilon);
  EXPECT_NE(changed.offsetDamping, defaults.offsetDamping);
  EXPECT_NE(changed.offsets, defaults.offsets);
  EXPECT_NE(changed.lookahead, defaults.lookahead);
  EXPECT_NE(changed.cutHandles, defaults.cutHandles);
  EXPECT_NE(changed.handleSearch, defaults.handleSearch);
  EXPECT_NE(changed.cutLoops, defaults.cutLoops);
  EXPECT_NE(changed.cutTips, defaults.cutTips);
  EXPECT_NE(changed.tip, defaults.tip);
  EXPECT_NE(changed.reliefStretch, defaults.reliefStretch);
  EXPECT_NE(changed.unwrap, defaults.unwrap);
  EXPECT_NE(changed.layout, defaults.layout);
  EXPECT_NE(changed.textureSize, defaults.textureSize);
  EXPECT_NE(changed.margin, defaults.margin);
  EXPECT_NE(changed.areaShare, defaults.areaShare);
  EXPECT_NE(changed.rngSeed, defaults.rngSeed);
  EXPECT_NE(changed.bestOf, defaults.bestOf);
  EXPECT_NE(changed.maxStretch, defaults.maxStretch);
  EXPECT_NE(changed.keep, defaults.keep);
  EXPECT_NE(changed.maxIterations, defaults.maxIterations);
  EXPECT_NE(changed.patience, defaults.patience);
  EXPECT_NE(changed.detectCycles, defaults.detectCycles);
  EXPECT_NE(changed.settle, defaults.settle);
  EXPECT_NE(changed.search, defaults.search);
  EXPECT_NE(changed.start, defaults.start);
  EXPECT_NE(changed.refine, defaults.refine);
  EXPECT_NE(changed.cleanUp, defaults.cleanUp);
  EXPECT_NE(changed.balanceWeight, defaults.balanceWeight);
  EXPECT_NE(changed.creaseWeight, defaults.creaseWeight);
}

TEST(ParameterTable, RowsAreCompleteAndDefaultsAllowed) {
  std::set<std::string> ids;
  for (const ParameterInfo& info : parameterTable()) {
    SCOPED_TRACE(info.id);
    EXPECT_TRUE(ids.insert(info.id).second) << "twice";
    EXPECT_NE(std::string(info.label), "");
    EXPECT_GT(std::string(info.help).size(), 20u);
    EXPECT_EQ(std::string(info.help).back(), '.');
    EXPECT_NE(std::string(info.group), "");
    Parameters values;
    EXPECT_NO_THROW(setParameter(values, info, parameterDefault(info)));
    EXPECT_EQ(parameterValue(values, info), parameterDefault(info));
    resetParameter(values, info);  // a default number of charts may be asked for
    EXPECT_EQ(values, Parameters{});
    const bool isNumber = !std::holds_alternative<bool Parameters::*>(info.member) &&
                          !std::holds_alternative<std::string Parameters::*>(info.member);
    EXPECT_EQ(info.choices.empty(),
              !std::holds_alternative<std::string Parameters::*>(info.member));
    EXPECT_TRUE(*info.orNumber == '\0' || !info.choices.empty());
    if (!isNumber) continue;
    EXPECT_NE(std::string(info.format), "");
    EXPECT_LT(info.sliderMin, info.sliderMax);
    EXPECT_LE(info.hardMin, info.sliderMin);
    EXPECT_GE(info.hardMax, info.sliderMax);
    if (info.scale != SliderScale::Linear) {
      EXPECT_GT(info.sliderMin, 0);
    }
  }
}

TEST(ParameterText, EveryDefaultReadsBack) {
  for (const ParameterInfo& info : parameterTable()) {
    Parameters values;
    setParameterFromText(values, info, parameterText(parameterDefault(info)));
    EXPECT_EQ(parameterValue(values, info), parameterDefault(info)) << info.id;
    resetParameter(values, info);
    EXPECT_EQ(values, Parameters{}) << info.id;
  }
}

TEST(ParameterText, NumbersReadBackExactly) {
  for (const double value : {0.1, 1.0 / 3, 1e-9, 9.999999999999999, 5e-324}) {
    Parameters values;
    setParameterFromText(values, row("speed-power"), parameterText(ParameterValue(value)));
    EXPECT_EQ(values.speedPower, value);
  }
}

TEST(ParameterText, ReadsEveryKind) {
  Parameters values;
  setParameterFromText(values, row("charts"), "+7");
  setParameterFromText(values, row("speed-epsilon"), "1e-4");
  setParameterFromText(values, row("offsets"), "off");
  setParameterFromText(values, row("detect-cycles"), "false");
  setParameterFromText(values, row("refine"), "none");
  EXPECT_EQ(values.charts, 7);
  EXPECT_EQ(values.speedEpsilon, 1e-4);
  EXPECT_FALSE(values.offsets);
  EXPECT_FALSE(values.detectCycles);
  EXPECT_EQ(values.refine, "none");
  setParameterFromText(values, row("offsets"), "true");
  EXPECT_TRUE(values.offsets);
}

TEST(ParameterText, TakesANumberForAChoiceWhereThatHasAMeaning) {
  Parameters values;
  EXPECT_EQ(weldDistance(values), 0);
  setParameterFromText(values, row("weld"), "1e-3");
  EXPECT_EQ(weldDistance(values), 1e-3);
  setParameterFromText(values, row("weld"), "off");
  EXPECT_LT(weldDistance(values), 0);
  for (const char* text : {"0", "-1", "nan", "inf", "1e999", "1mm", "on", ""}) {
    EXPECT_NE(refusal("weld", text).find("auto or off or a number above 0"), std::string::npos);
  }
  EXPECT_NE(refusal("method", "3"), "");
}

TEST(ParameterRefusal, NamesOptionValueAndRange) {
  EXPECT_EQ(refusal("sharp-angle", "181"),
            "--sharp-angle=181 is out of range: give a number from 0 to 180.");
  EXPECT_EQ(refusal("charts", "0"),
            "--charts=0 is out of range: give a whole number from 1 to 1000000000.");
  EXPECT_EQ(refusal("offset-damping", "0"),
            "--offset-damping=0 is out of range: give a number above 0 and up to 1.");
  EXPECT_EQ(refusal("speed-power", "nan"),
            "--speed-power=nan is not a finite number: give a number from 0 to 10.");
  EXPECT_EQ(refusal("offsets", "maybe"), "--offsets=maybe is neither on nor off: give on or off.");
  EXPECT_EQ(refusal("refine", "move"),
            "--refine=move is not known (nearest: moves): give cuts or moves or none.");
}

TEST(ParameterRefusal, OfEveryBadNumber) {
  for (const char* text :
       {"", " ", "1 ", " 1", "1,5", "0x10", "one", "++1", "--1", "1e", "1.2.3"}) {
    EXPECT_THAT(refusal("speed-power", text), testing::HasSubstr("is not a number")) << text;
    EXPECT_THAT(refusal("charts", text), testing::HasSubstr("is not a whole number")) << text;
  }
  EXPECT_THAT(refusal("charts", "20.5"), testing::HasSubstr("is not a whole number"));
  for (const char* text : {"inf", "-inf", "NaN", "-nan"}) {
    EXPECT_THAT(refusal("speed-epsilon", text), testing::HasSubstr("is not a finite number"));
  }
  for (const char* text : {"1e999", "-1e999", "11", "-0.1"}) {
    EXPECT_THAT(refusal("speed-power", text), testing::HasSubstr("is out of range")) << text;
  }
  EXPECT_THAT(refusal("charts", "99999999999999"), testing::HasSubstr("is out of range"));
  EXPECT_THAT(refusal("speed-epsilon", "0"), testing::HasSubstr("is out of range"));
}

TEST(ParameterRefusal, OfTheWrongKindOfValue) {
  Parameters values;
  EXPECT_THROW(setParameter(values, row("charts"), 20.0), UsageError);
  EXPECT_THROW(setParameter(values, row("speed-power"), 3), UsageError);
  EXPECT_THROW(setParameter(values, row("offsets"), std::string("on")), UsageError);
  EXPECT_THROW(setParameter(values, row("speed-power"), std::numeric_limits<double>::quiet_NaN()),
               UsageError);
  EXPECT_EQ(values, Parameters{});
}

TEST(FirstDifference, IsTheEarliestStage) {
  Parameters a, b;
  Stage stage = Stage::Flood;
  EXPECT_FALSE(firstDifference(a, b, stage));
  b.cleanUp = 5;
  ASSERT_TRUE(firstDifference(a, b, stage));
  EXPECT_EQ(stage, Stage::Refine);
  b.charts = 5;
  ASSERT_TRUE(firstDifference(a, b, stage));
  EXPECT_EQ(stage, Stage::Seeds);
  b.speedPower = 3;
  ASSERT_TRUE(firstDifference(a, b, stage));
  EXPECT_EQ(stage, Stage::Graph);
  b.sharpAngle = 10;
  ASSERT_TRUE(firstDifference(b, a, stage));
  EXPECT_EQ(stage, Stage::Gauss);
}

TEST(Presets, PaperIsThePrintedMethod) {
  Parameters base;
  base.charts = 7;
  base.rngSeed = 5;
  base.sharpAngle = 10;
  const Preset* paper = findPreset("paper");
  ASSERT_NE(paper, nullptr);
  const Parameters values = applyPreset(base, *paper);
  Parameters expected;
  expected.charts = 7;
  expected.rngSeed = 5;
  expected.speedPower = 1;
  expected.speedEpsilon = 1e-4;
  expected.offsetDamping = 0.9;
  expected.areaShare = 0;
  expected.settle = 0;
  expected.seeding = "one-by-one";
  expected.keep = "eq3";
  expected.detectCycles = false;
  expected.search = "literal";
  expected.start = "flood";
  expected.refine = "none";
  expected.handleSearch = "wavefront";
  expected.tip = 1;
  expected.reliefStretch = 0;
  expected.unwrap = "circle";
  expected.layout = "square";
  EXPECT_EQ(values, expected);
  expected.speedPower = 3;
  EXPECT_EQ(applyPreset(base, *findPreset("paper-happy")), expected);
}

TEST(Presets, OthersSetWhatTheyName) {
  const Parameters base;
  EXPECT_EQ(applyPreset(base, *findPreset("few-large")).charts, 8);
  EXPECT_EQ(applyPreset(base, *findPreset("hard-surface")).sharpAngle, 30);
  EXPECT_EQ(applyPreset(base, *findPreset("hard-surface")).speedPower, 3);
  EXPECT_EQ(applyPreset(base, *findPreset("hard-surface")).start, "creases");
  EXPECT_EQ(applyPreset(base, *findPreset("organic")).sharpAngle, 90);
  EXPECT_EQ(applyPreset(base, *findPreset("organic")).speedPower, 2);
  EXPECT_EQ(findPreset("papper"), nullptr);
  EXPECT_EQ(presetTable().size(), 5u);
}

TEST(ChartsAsked, LimitADefaultAloneToTheFeatures) {
  Parameters values;
  EXPECT_EQ(chartsInForce(values, 6), 6u);
  EXPECT_EQ(chartsInForce(values, 300), 20u);
  EXPECT_EQ(chartsInForce(values, 0), 1u);
  EXPECT_TRUE(isDefault(values, row("charts")));
  values.charts = 30;
  EXPECT_EQ(chartsInForce(values, 6), 30u);
  EXPECT_FALSE(isDefault(values, row("charts")));
}

TEST(ChartsAsked, TheDefaultsNumberStaysOnceItIsAskedFor) {
  const Parameters fresh;
  Parameters values;
  setParameterFromText(values, row("charts"), "20");
  EXPECT_EQ(chartsInForce(values, 6), 20u);
  EXPECT_FALSE(isDefault(values, row("charts")));
  Stage stage = Stage::Layout;
  EXPECT_TRUE(firstDifference(fresh, values, stage));
  EXPECT_EQ(stage, Stage::Seeds);
  const Parameters preset = applyPreset(values, *findPreset("organic"));
  EXPECT_EQ(chartsInForce(preset, 6), 20u);
  EXPECT_EQ(chartsInForce(applyPreset(fresh, *findPreset("organic")), 6), 6u);
  EXPECT_EQ(chartsInForce(applyPreset(fresh, *findPreset("few-large")), 6), 8u);
  resetParameter(values, row("charts"));
  EXPECT_EQ(values, fresh);
}

TEST(WhyUnused, TellsOfMethodsAndBorders) {
  Parameters values;
  const auto why = [&](const char* id) { return whyUnused(values, *findParameter(id)); };
  EXPECT_EQ(why("speed-power"), "");
  EXPECT_EQ(why("balance-weight"), "");
  EXPECT_NE(why("clean-up"), "");
  EXPECT_NE(why("vsa-seeding"), "");
  EXPECT_NE(why("detect-cycles"), "");
  values.settle = 0;
  EXPECT_EQ(why("detect-cycles"), "");
  values.settle = 4;
  values.offsets = false;
  EXPECT_EQ(why("detect-cycles"), "");
  values.refine = "moves";
  EXPECT_NE(why("balance-weight"), "");
  EXPECT_EQ(why("clean-up"), "");
  values.refine = "none";
  EXPECT_NE(why("crease-weight"), "");
  EXPECT_NE(why("clean-up"), "");
  values = {};
  values.method = "vsa";
  EXPECT_NE(why("speed-power"), "");
  EXPECT_EQ(why("vsa-seeding"), "");
  EXPECT_NE(why("detect-cycles"), "");
  EXPECT_EQ(why("charts"), "");
}

TEST(NearestSpelling, FindsTypingMistakes) {
  const std::vector<std::string> words{"charts", "sharp-angle", "speed-power", "seams", "seeds"};
  EXPECT_EQ(nearestSpelling("chart", words), "charts");
  EXPECT_EQ(nearestSpelling("chatrs", words), "charts");
  EXPECT_EQ(nearestSpelling("sharp", words), "sharp-angle");
  EXPECT_EQ(nearestSpelling("sped-powr", words), "speed-power");
  EXPECT_EQ(nearestSpelling("seam", words), "seams");
  EXPECT_EQ(nearestSpelling("gaus", std::vector<std::string>{"gauss-vertex", "gauss"}), "gauss");
  EXPECT_EQ(nearestSpelling("xyzzy", words), "");
  EXPECT_EQ(nearestSpelling("", words), "");
  EXPECT_EQ(nearestSpelling("a", {}), "");
}

}  // namespace
}  // namespace chartflood
