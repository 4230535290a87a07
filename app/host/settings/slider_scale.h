#pragma once
/// How a parameter runs along its slider, and how its value reads.

#include <string>

#include "core/session/settings/parameters.h"

namespace chartflood {

/// Where a value stands on the row's slider, 0 to 1; values beyond its ends are clamped.
double sliderFraction(const ParameterInfo& info, double value);

/// The value at a place on the slider, rounded to what the row's format shows. With LogZero the
/// first 5 % mean 0.
double sliderValue(const ParameterInfo& info, double fraction);

/// A number as the row shows it, with its unit: "45\u00b0", "1e-3", "0.3".
std::string sliderText(const ParameterInfo& info, double value);

/// The value as a plain number: bools are 0 or 1, texts 0.
double asNumber(const ParameterValue& value);

}  // namespace chartflood
