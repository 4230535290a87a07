#include "core/session/pipeline/results.h"

namespace chartflood {

FloodMoment momentOf(const Results& results) {
  FloodMoment moment;
  if (!settled(results) || !results.record) return moment;
  moment.start = results.start;
  moment.taken = results.record->size();
  moment.finished = results.finished;
  return moment;
}

bool settled(const Results& results) { return !results.stale && !results.sketch; }

}  // namespace chartflood
