#pragma once
/// How much the parameters allow a chart to stretch, and which charts stretch more.

#include <string>
#include <vector>

#include "core/base/index.h"
#include "core/model/unwrap.h"
#include "core/param/unwrap_charts.h"
#include "core/session/settings/parameters.h"

namespace chartflood {

UnwrapOptions unwrapOptions(const Parameters& parameters);

/// L2 that relief cuts keep each chart to; endless without them, or the allowed stretch where the
/// number of charts was looked for.
double stretchLimit(const Parameters& parameters, bool searched);

/// Charts that are laid flat and stretch more than the limit, ascending.
std::vector<Index> chartsAbove(double limit, const Unwrap& unwrap);

/// One sentence that names them with their stretch and says what helps; "" when there are none.
std::string aboveLimitText(double limit, const Unwrap& unwrap);

}  // namespace chartflood
