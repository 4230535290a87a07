#include "app/host/settings/user_presets.h"

#include <algorithm>

#include "core/base/error.h"

namespace chartflood {

namespace {

constexpr std::size_t kLongestName = 60;  // bytes

bool isBuiltIn(std::string_view name) {
  const auto presets = presetTable();
  return name == "Standard" || std::any_of(presets.begin(), presets.end(), [&](const Preset& each) {
           return name == each.id || name == each.label;
         });
}

}  // namespace

UserPreset userPresetOf(std::string name, const Parameters& parameters) {
  UserPreset preset{std::move(name), {}};
  for (const ParameterInfo& info : parameterTable()) {
    const std::string_view id = info.id;
    const ParameterValue value = parameterValue(parameters, info);
    if (!isDefault(parameters, info) && id != "rng-seed")
      preset.values.emplace_back(info.id, parameterText(value));
  }
  return preset;
}

Parameters applyUserPreset(const Parameters& base, const UserPreset& preset, std::string& warning) {
  Parameters result;
  result.charts = base.charts;
  result.chartsAsked = base.chartsAsked;
  result.rngSeed = base.rngSeed;
  std::string left;
  for (const auto& [id, text] : preset.values) {
    try {
      const ParameterInfo* info = findParameter(id);
      if (info == nullptr) throw UsageError("unknown");
      setParameterFromText(result, *info, text);
    } catch (const UsageError&) {
      left += (left.empty() ? "" : ", ") + id;
    }
  }
  warning = left.empty() ? ""
                         : "The preset '" + preset.name + "' has values that cannot be used (" +
                               left + "); their defaults were taken.";
  return result;
}

const UserPreset* findUserPreset(std::span<const UserPreset> presets, std::string_view name) {
  const auto found = std::find_if(presets.begin(), presets.end(),
                                  [&](const UserPreset& each) { return each.name == name; });
  return found == presets.end() ? nullptr : &*found;
}

std::string presetNameProblem(std::span<const UserPreset> presets, std::string_view name) {
  if (name.find_first_not_of(' ') == std::string_view::npos) return "Give the preset a name.";
  if (name.size() > kLongestName) return "The name of a preset is 60 letters at most.";
  const bool control = std::any_of(name.begin(), name.end(),
                                   [](char c) { return static_cast<unsigned char>(c) < 32; });
  if (control) return "The name of a preset is one line of text.";
  if (isBuiltIn(name) || findUserPreset(presets, name) != nullptr) {
    return "There is a preset '" + std::string(name) + "' already: choose another name.";
  }
  return "";
}

}  // namespace chartflood
