#pragma once
/// The groups of actions, each with its keys.

#include "app/host/script/action_registry.h"

namespace chartflood {

/// All of the program's actions with their keys.
ActionRegistry makeActionRegistry();

/// Open, samples, recent files, quit.
void addFileActions(ActionRegistry& registry);
/// Saving and recovering the work, and the question before it would be lost.
void addSessionActions(ActionRegistry& registry);
/// The hand on the seeds.
void addSeedActions(ActionRegistry& registry);
/// The same by keyboard alone.
void addSeedKeyActions(ActionRegistry& registry);
/// Parameters, presets, undo and redo.
void addEditActions(ActionRegistry& registry);
/// Flooding and its playback.
void addSegmentActions(ActionRegistry& registry);
/// The number of charts, found.
void addCountActions(ActionRegistry& registry);
/// The brush on edges.
void addHintActions(ActionRegistry& registry);
/// Colours, overlays, camera, panels.
void addViewActions(ActionRegistry& registry);
/// Range, scale and colours of values.
void addLegendActions(ActionRegistry& registry);
/// Theme, simulated colour vision, preferences, and the search for actions.
void addLookActions(ActionRegistry& registry);
/// The user's own presets.
void addPresetActions(ActionRegistry& registry);
/// Selecting charts, looking at one alone, their texture and its checkerboard.
void addChartActions(ActionRegistry& registry);
/// Results kept beside the live ones.
void addCompareActions(ActionRegistry& registry);
/// The film of the HandleCutter.
void addFilmActions(ActionRegistry& registry);
void addRunActions(ActionRegistry& registry);
/// The Gauss sphere, plots, figures of charts, and what deserves attention.
void addInsightActions(ActionRegistry& registry);
/// Pictures, and what they are like.
void addPictureActions(ActionRegistry& registry);
/// Files made from the results.
void addExportActions(ActionRegistry& registry);

}  // namespace chartflood
