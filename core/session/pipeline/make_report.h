#pragma once
/// From the results of a session to the numbers of the report.

#include <string>
#include <vector>

#include "core/model/report.h"
#include "core/session/pipeline/results.h"

namespace chartflood {

/// What the mesh holds and what was repaired.
InputReport inputReport(const Mesh& mesh);

/// The report of everything computed so far. `seeds` are those placed by hand, as faces of the
/// mesh. `peakMemoryBytes` is left 0. \pre results.mesh is there
Report makeReport(const Results& results, const std::vector<Index>& seeds,
                  const std::string& version);

}  // namespace chartflood
