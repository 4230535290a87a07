// Reading, checking, storing and comparing values by the rows of the parameter table.

#include "core/session/settings/parameters.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <type_traits>

#include "core/base/check.h"
#include "core/base/error.h"
#include "core/base/spelling.h"
#include "core/base/text.h"
#include "core/io/text/parse_number.h"
#include "core/model/build_mesh.h"
#include "core/segment/registry.h"

namespace chartflood {

namespace {

std::string numberText(double value) {
  std::array<char, 32> buffer;
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  return {buffer.data(), end};
}

bool isWhole(const ParameterInfo& info) {
  return std::holds_alternative<int Parameters::*>(info.member);
}

std::string allowedNumbers(const ParameterInfo& info) {
  const std::string kind = isWhole(info) ? "a whole number" : "a number";
  // Plain digits: 1000000000 reads better than 1e+09 where only whole numbers are allowed.
  const auto bound = [&](double value) {
    return isWhole(info) ? std::to_string(static_cast<long long>(value)) : numberText(value);
  };
  if (info.hardMinExcluded) {
    return kind + " above " + bound(info.hardMin) + " and up to " + bound(info.hardMax);
  }
  return kind + " from " + bound(info.hardMin) + " to " + bound(info.hardMax);
}

std::string allowedChoices(const ParameterInfo& info) {
  std::string text;
  for (const ParameterChoice& choice : info.choices) {
    if (!text.empty()) text += " or ";
    text += choice.id;
  }
  if (*info.orNumber != '\0') text += " or a number above 0";
  return text;
}

/// The number that stands for a choice; 0 when the text is none that may.
double numberForChoice(const ParameterInfo& info, std::string_view text) {
  double value = 0;
  if (*info.orNumber == '\0') return 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = error == std::errc() && end == text.data() + text.size();
  return whole && std::isfinite(value) && value > 0 ? value : 0;
}

std::string allowed(const ParameterInfo& info) {
  if (std::holds_alternative<bool Parameters::*>(info.member)) return "on or off";
  if (!info.choices.empty()) return allowedChoices(info);
  return allowedNumbers(info);
}

[[noreturn]] void refuse(const ParameterInfo& info, std::string_view value,
                         std::string_view reason) {
  throw UsageError("--" + std::string(info.id) + "=" + std::string(value) + " " +
                   std::string(reason) + ": give " + allowed(info) + ".");
}

void checkNumber(const ParameterInfo& info, double value, std::string_view text) {
  if (!std::isfinite(value)) refuse(info, text, "is not a finite number");
  const bool tooSmall = info.hardMinExcluded ? value <= info.hardMin : value < info.hardMin;
  if (tooSmall || value > info.hardMax) refuse(info, text, "is out of range");
}

void checkChoice(const ParameterInfo& info, const std::string& value) {
  if (numberForChoice(info, value) > 0) return;
  std::vector<std::string> names;
  for (const ParameterChoice& choice : info.choices) {
    names.push_back(choice.id);
    if (value == choice.id) return;
  }
  const std::string near = nearestSpelling(value, names);
  refuse(info, value, near.empty() ? "is not known" : "is not known (nearest: " + near + ")");
}

template <typename T>
T parseNumber(const ParameterInfo& info, std::string_view text) {
  const std::string_view digits = withoutPlus(text);
  T value{};
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error == std::errc::result_out_of_range) refuse(info, text, "is out of range");
  if (error != std::errc() || end != digits.data() + digits.size()) {
    refuse(info, text, isWhole(info) ? "is not a whole number" : "is not a number");
  }
  return value;
}

bool parseSwitch(const ParameterInfo& info, std::string_view text) {
  if (const std::optional<bool> on = switchValue(text)) return *on;
  refuse(info, text, "is neither on nor off");
}

bool asksForCharts(const Parameters& values) {
  return values.chartsAsked || values.charts != Parameters{}.charts;
}

}  // namespace

ParameterValue parameterValue(const Parameters& values, const ParameterInfo& info) {
  return std::visit([&](auto member) -> ParameterValue { return values.*member; }, info.member);
}

ParameterValue parameterDefault(const ParameterInfo& info) {
  return parameterValue(Parameters{}, info);
}

void setParameter(Parameters& values, const ParameterInfo& info, const ParameterValue& value) {
  std::visit(
      [&](auto member) {
        using T = std::remove_reference_t<decltype(values.*member)>;
        const T* typed = std::get_if<T>(&value);
        if (typed == nullptr) refuse(info, parameterText(value), "is of the wrong kind");
        if constexpr (std::is_same_v<T, std::string>) {
          checkChoice(info, *typed);
        } else if constexpr (!std::is_same_v<T, bool>) {
          checkNumber(info, static_cast<double>(*typed), parameterText(value));
        }
        values.*member = *typed;
        if constexpr (std::is_same_v<T, int>) {
          if (member == &Parameters::charts) values.chartsAsked = true;
        }
      },
      info.member);
}

void setParameterFromText(Parameters& values, const ParameterInfo& info, std::string_view text) {
  std::visit(
      [&](auto member) {
        using T = std::remove_reference_t<decltype(values.*member)>;
        if constexpr (std::is_same_v<T, std::string>) {
          setParameter(values, info, std::string(text));
        } else if constexpr (std::is_same_v<T, bool>) {
          setParameter(values, info, parseSwitch(info, text));
        } else {
          setParameter(values, info, parseNumber<T>(info, text));
        }
      },
      info.member);
}

double weldDistance(const Parameters& values) {
  if (values.weld == "auto") return 0;
  return values.weld == "off" ? kNoWeld : numberForChoice(*findParameter("weld"), values.weld);
}

bool isDefault(const Parameters& values, const ParameterInfo& info) {
  if (std::string_view(info.id) == "charts") return !asksForCharts(values);
  return parameterValue(values, info) == parameterDefault(info);
}

void resetParameter(Parameters& values, const ParameterInfo& info) {
  const Parameters defaults;
  std::visit([&](auto member) { values.*member = defaults.*member; }, info.member);
  if (std::string_view(info.id) == "charts") values.chartsAsked = false;
}

void askCharts(Parameters& values, int charts) {
  values.charts = charts;
  values.chartsAsked = true;
}

std::size_t chartsInForce(const Parameters& values, std::size_t features) {
  const auto charts = static_cast<std::size_t>(values.charts);
  return asksForCharts(values) ? charts : std::max<std::size_t>(1, std::min(charts, features));
}

Parameters inForce(Parameters values, std::size_t features) {
  values.charts = static_cast<int>(chartsInForce(values, features));
  return values;
}

std::string whyUnused(const Parameters& values, const ParameterInfo& info) {
  const std::string id = info.id;
  const bool even =
      values.method != "t-flooding" && (values.even == "error" || values.even == "area");
  // Even growth balances by offsets over rounds, as t-flooding does.
  if (even && (id == "patience" || id == "settle")) return "";
  if (*info.method != '\0' && values.method != info.method) {
    const ParameterInfo& method = *findParameter("method");
    for (const ParameterChoice& choice : method.choices) {
      if (info.method == std::string(choice.id)) {
        return "Only for the method \"" + std::string(choice.label) + "\".";
      }
    }
  }
  const bool ofCuts = id == "balance-weight" || id == "crease-weight";
  if (ofCuts && values.refine != "cuts") return "Only for shortest borders.";
  if (id == "clean-up" && values.refine != "moves") return "Only for tidied borders.";
  if (id == "even" && values.method == "t-flooding") return "T-flooding evens out Gauss area.";
  if (id == "mcgim-disks" && even) return "Charts that are evened out may grow into rings.";
  if (id == "seeding" && values.search == "fast") return "The fast search spreads its seeds.";
  if (id == "seeding" && values.start == "creases") return "Charts begin from creases.";
  const Segmenter& segmenter = segmenterOf(values.method);
  if (id == "detect-cycles" && *segmenter.noCycles != '\0') return segmenter.noCycles;
  const bool balances = segmenter.balances && values.offsets;
  if (id == "detect-cycles" && balances && values.settle > 0) {
    return "Seeds that return are no end while charts settle: set Settle to 0.";
  }
  return "";
}

std::string parameterText(const ParameterValue& value) {
  if (const bool* on = std::get_if<bool>(&value)) return switchWord(*on);
  if (const int* whole = std::get_if<int>(&value)) return std::to_string(*whole);
  if (const double* number = std::get_if<double>(&value)) return numberText(*number);
  return std::get<std::string>(value);
}

bool firstDifference(const Parameters& a, const Parameters& b, Stage& stage) {
  bool differs = false;
  for (const ParameterInfo& info : parameterTable()) {
    if (info.stage == Stage::Request) continue;
    if (parameterValue(a, info) == parameterValue(b, info)) continue;
    if (!differs || info.stage < stage) stage = info.stage;
    differs = true;
  }
  if (asksForCharts(a) != asksForCharts(b)) {
    stage = differs ? std::min(stage, Stage::Seeds) : Stage::Seeds;
    differs = true;
  }
  return differs;
}

bool differOnlyInRounds(const Parameters& a, const Parameters& b) {
  Parameters same = a;
  same.offsets = b.offsets;
  same.offsetDamping = b.offsetDamping;
  same.maxIterations = b.maxIterations;
  same.patience = b.patience;
  same.keep = b.keep;
  same.detectCycles = b.detectCycles;
  same.settle = b.settle;
  return a != b && same == b;
}

Parameters applyPreset(const Parameters& base, const Preset& preset) {
  Parameters values;
  values.charts = base.charts;
  values.chartsAsked = base.chartsAsked;
  values.rngSeed = base.rngSeed;
  values.weld = base.weld;
  for (const auto& [id, value] : preset.values) {
    const ParameterInfo* info = findParameter(id);
    CF_CHECK(info != nullptr);
    setParameter(values, *info, value);
  }
  return values;
}

}  // namespace chartflood
