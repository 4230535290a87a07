#include "core/session/pipeline/results.h"

namespace chartflood {

FloodMoment momentOf(const Results& results) {
  FloodMoment moment;
  if (results.stale || results.sketch || !results.record) return moment;
  moment.start = results.start;
  moment.taken = results.record->size();
  moment.finished = results.finished;
  return moment;
}

}  // namespace chartflood
