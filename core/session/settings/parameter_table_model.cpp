// Rows of the parameter table: how a file becomes a surface.

#include "core/session/settings/parameter_table.h"

namespace chartflood {

std::vector<ParameterInfo> modelRows() {
  return {
      {.id = "weld",
       .label = "Join vertices",
       .symbol = "",
       .member = &Parameters::weld,
       .stage = Stage::Mesh,
       .group = "Model",
       .help =
           "Files often repeat vertices at creases and texture seams. Auto: those at exactly one "
           "place are joined where that makes one surface. Off: only what the file joins. A "
           "distance, in the model's units, closes gaps up to it. Exports keep all vertices.",
       .source = "",
       .choices = {{"auto", "At one place"}, {"off", "As in the file"}},
       .orNumber = "DISTANCE"},
  };
}

}  // namespace chartflood
