#include "core/session/pipeline/chart_run.h"

#include <algorithm>
#include <span>

namespace chartflood {

FloodMoment ChartRun::moment() const {
  if (!stepper || !stepper->record()) return {};
  return {start, stepper->record()->size(), finished()};
}

bool differWithin(const Parameters& a, const Parameters& b, Stage first, Stage last) {
  const std::span<const ParameterInfo> table = parameterTable();
  return std::any_of(table.begin(), table.end(), [&](const ParameterInfo& info) {
    return info.stage >= first && info.stage <= last &&
           parameterValue(a, info) != parameterValue(b, info);
  });
}

bool sameCharts(const Document& a, const Document& b) {
  const Parameters& p = a.parameters;
  const Parameters& q = b.parameters;
  return a.seeds == b.seeds && a.hints == b.hints && p.bestOf == q.bestOf &&
         p.chartsAsked == q.chartsAsked && !differWithin(p, q, Stage::Mesh, Stage::Refine);
}

}  // namespace chartflood
