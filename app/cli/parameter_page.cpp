#include "app/cli/parameter_page.h"

#include "core/session/settings/parameters.h"

namespace chartflood {

namespace {

/// Shortest text of a number: "0.001", "1e-06".
std::string shortText(double value) { return parameterText(ParameterValue(value)); }

std::string rangeText(const ParameterInfo& info) {
  if (std::holds_alternative<bool Parameters::*>(info.member)) return "on, off";
  std::string choices;
  for (const ParameterChoice& choice : info.choices) {
    choices += (choices.empty() ? "" : ", ") + std::string(choice.id);
  }
  if (*info.orNumber != '\0') choices += ", a number above 0";
  if (!choices.empty()) return choices;
  const std::string zero = info.scale == SliderScale::LogZero ? "0, " : "";
  const std::string unit = *info.unit == '\0' ? "" : std::string(" ") + info.unit;
  return zero + shortText(info.sliderMin) + " to " + shortText(info.sliderMax) + unit;
}

std::string rowText(const ParameterInfo& info) {
  return std::string("| ") + info.label + " | " + info.symbol + " | `--" + info.id + "` | " +
         rangeText(info) + " | " + parameterText(parameterDefault(info)) + " | " + info.help +
         " |\n";
}

std::string presetText(const Preset& preset) {
  std::string values;
  for (const auto& [id, value] : preset.values) {
    values +=
        (values.empty() ? "" : " ") + std::string("`--") + id + "=" + parameterText(value) + "`";
  }
  return std::string("| `--preset=") + preset.id + "` | " + preset.label + " | " + preset.help +
         " | " + values + " |\n";
}

}  // namespace

std::string parameterPage() {
  std::string text = "| Slider | Symbol | Option | Range | Default | What it does |\n"
                     "|---|---|---|---|---|---|\n";
  for (const ParameterInfo& info : parameterTable()) text += rowText(info);
  text += "\n| Preset | Name | For | Values |\n|---|---|---|---|\n";
  for (const Preset& preset : presetTable()) text += presetText(preset);
  return text;
}

}  // namespace chartflood
