#include "app/host/actions/actions.h"

namespace chartflood {

ActionRegistry makeActionRegistry() {
  ActionRegistry registry;
  addFileActions(registry);
  addSessionActions(registry);
  addEditActions(registry);
  addSegmentActions(registry);
  addCountActions(registry);
  addHintActions(registry);
  addSeedActions(registry);
  addSeedKeyActions(registry);
  addViewActions(registry);
  addLegendActions(registry);
  addLookActions(registry);
  addPresetActions(registry);
  addChartActions(registry);
  addFilmActions(registry);
  addCompareActions(registry);
  addPictureActions(registry);
  addRunActions(registry);
  addInsightActions(registry);
  addExportActions(registry);
  return registry;
}

}  // namespace chartflood
