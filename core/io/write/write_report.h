#pragma once
/// The report as JSON text.

#include <string>

#include "core/model/report.h"

namespace chartflood {

/// JSON with two spaces of indentation and a final line feed. Every key of the format is there;
/// what does not exist is null, and so is a number that is not finite. Equal reports give equal
/// bytes.
std::string reportText(const Report& report);

}  // namespace chartflood
