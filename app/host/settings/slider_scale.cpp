#include "app/host/settings/slider_scale.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace chartflood {

namespace {

constexpr double kZeroShare = 0.05;  // part of a LogZero slider that means 0

std::string printed(const ParameterInfo& info, double value) {
  char text[64];
  std::snprintf(text, sizeof text, *info.format != '\0' ? info.format : "%g", value);
  return text;
}

double logFraction(const ParameterInfo& info, double value) {
  return std::log(value / info.sliderMin) / std::log(info.sliderMax / info.sliderMin);
}

double logValue(const ParameterInfo& info, double fraction) {
  return info.sliderMin * std::pow(info.sliderMax / info.sliderMin, fraction);
}

/// "1.0e-03" becomes "1e-3".
std::string shortExponent(std::string text) {
  const std::size_t e = text.find('e');
  if (e == std::string::npos) return text;
  std::string mantissa = text.substr(0, e);
  if (mantissa.find('.') != std::string::npos) {
    mantissa.erase(mantissa.find_last_not_of('0') + 1);
    if (mantissa.back() == '.') mantissa.pop_back();
  }
  return mantissa + 'e' + std::to_string(std::atoi(text.c_str() + e + 1));
}

}  // namespace

double sliderFraction(const ParameterInfo& info, double value) {
  double fraction = 0;
  switch (info.scale) {
  case SliderScale::Linear:
    fraction = (value - info.sliderMin) / (info.sliderMax - info.sliderMin);
    break;
  case SliderScale::Log:
    fraction = value > 0 ? logFraction(info, value) : 0;
    break;
  case SliderScale::LogZero:
    fraction = value > 0 ? kZeroShare + (1 - kZeroShare) * logFraction(info, value) : 0;
    break;
  }
  return std::clamp(fraction, 0.0, 1.0);
}

double sliderValue(const ParameterInfo& info, double fraction) {
  fraction = std::clamp(fraction, 0.0, 1.0);
  double value = 0;
  switch (info.scale) {
  case SliderScale::Linear:
    value = info.sliderMin + fraction * (info.sliderMax - info.sliderMin);
    break;
  case SliderScale::Log:
    value = logValue(info, fraction);
    break;
  case SliderScale::LogZero:
    if (fraction < kZeroShare) return 0;
    value = logValue(info, (fraction - kZeroShare) / (1 - kZeroShare));
    break;
  }
  if (info.scale != SliderScale::Linear && value < 10 && info.format[0] != '\0') {
    char text[32];  // a ratio scale needs no more than two digits
    std::snprintf(text, sizeof text, "%.1e", value);
    value = std::strtod(text, nullptr);
  }
  return std::clamp(std::strtod(printed(info, value).c_str(), nullptr), info.sliderMin,
                    info.sliderMax);
}

std::string sliderText(const ParameterInfo& info, double value) {
  std::string text = shortExponent(printed(info, value));
  std::string unit = info.unit;
  if (unit == "deg") return text + "\u00b0";
  if (value == 1 && unit.ends_with('s')) unit.pop_back();  // one of them
  return unit.empty() ? text : text + ' ' + unit;
}

double asNumber(const ParameterValue& value) {
  if (const double* number = std::get_if<double>(&value)) return *number;
  if (const int* number = std::get_if<int>(&value)) return *number;
  if (const bool* flag = std::get_if<bool>(&value)) return *flag ? 1 : 0;
  return 0;
}

}  // namespace chartflood
