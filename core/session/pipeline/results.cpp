#include "core/session/pipeline/results.h"

namespace chartflood {

FloodMoment momentOf(const Results& results) {
  FloodMoment moment;
  if (results.stale || !results.record) return moment;
  moment.seeds = results.seeds;
  moment.offsets = results.offsets;
  moment.normals = results.normals;
  moment.creases = results.creases;
  moment.fast = results.fast;
  moment.taken = results.record->size();
  moment.finished = results.finished;
  return moment;
}

}  // namespace chartflood
