#pragma once
/// How the halves of a comparison are looked at: with one camera and one scale, or each by itself.

#include "app/host/state/compare.h"

namespace chartflood {

class AppState;

/// The present state as it would be stored. \pre there are charts
StoredResult storedNow(const AppState& state, const std::string& name);

/// From now on the view's camera and colours are those of this half, where they are not linked.
void activate(AppState& state, ComparePane pane);

/// Gives all halves the look of the active one.
void shareLook(AppState& state);

/// The results that a half shows.
const Results& paneResults(const AppState& state, ComparePane pane);
/// What is shown beside them: the state's own while both have the same, else one of the half's.
Insight& paneInsight(const AppState& state, ComparePane pane);
Camera paneCamera(const AppState& state, ComparePane pane);
/// Colours and overlays of a half, without what only the live state has (playhead, film). The scale
/// is not linked yet, see commonRange().
RenderSettings paneLook(const AppState& state, ComparePane pane);

/// What is said under a half, in pieces that stay whole where there is room for them.
struct PaneCaption {
  std::string method;
  std::vector<std::string> figures;
  std::vector<std::string> problems;   ///< while they are marked on the half
  std::vector<std::string> differing;  ///< values that are others than on another half
};
PaneCaption paneCaption(const AppState& state, ComparePane pane);

}  // namespace chartflood
