#pragma once
/// Everything the running viewer knows: the session, how it is looked at, the playback and what was
/// said to the user. No window and no widget: the same state serves scripts and tests.

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/host/handle_film.h"
#include "app/host/insight.h"
#include "app/host/notices.h"
#include "app/host/playback.h"
#include "app/host/preferences.h"
#include "app/host/undo_history.h"
#include "app/host/view_settings.h"
#include "core/base/index.h"
#include "core/session/session.h"

namespace chartflood {

class ActionRegistry;

/// Which parts of the window are open. Transient: neither saved nor undone.
struct PanelState {
  enum class RightTab { Uv, Charts, Sphere, Plots };
  bool left = true, right = true, bottom = true;
  bool rightWanted = true;  ///< the window is wide enough for the right pane at first
  RightTab rightTab = RightTab::Uv;
  bool uvUnderMouse = false;    ///< actions of the view mean the texture
  bool selectRightTab = false;  ///< the tab was chosen by an action and must be brought to front
  enum class Browse { Nothing, Open, SaveMesh, SaveUv, SaveSeams, SaveLabels, SaveReport };
  Browse browse = Browse::Nothing;  ///< what the file browser is open for
  bool problems = false;            ///< their list is unfolded
  Index shownFace = kNone;   ///< of the problem that was shown last, where it is a single face
  bool barsByValue = false;  ///< bars of charts stand by size, not by number
  bool keys = false, log = false, about = false;
  bool firstCard = false;
};

/// A picture to be taken by whoever owns the renderer.
struct PictureRequest {
  std::filesystem::path file;  ///< "": the next free name in the folder of pictures
  int scale = 1;               ///< times the size of the 3D view
  bool bare = false;           ///< transparent, without helpers
  bool texture = false;        ///< the charts in the texture, at its size, instead of the view
};

/// What only the window's owner can do; it takes these and clears them.
struct WindowRequests {
  bool quit = false;
  bool toggleFullScreen = false;
  std::optional<std::string> clipboard;  ///< text to be copied
  std::vector<PictureRequest> pictures;
};

class AppState {
 public:
  explicit AppState(Session::Worker worker);

  /// Takes in what the worker has done and moves the playback on by `seconds`.
  void update(double seconds);

  /// Runs one script line; a failure becomes a toast. Returns whether it worked.
  bool perform(const ActionRegistry& actions, std::string_view line);
  /// The lines that worked, oldest first.
  const std::vector<std::string>& journal() const { return journal_; }

  Session& session() { return session_; }
  const Document& document() const { return session_.document(); }
  /// As of the last update; never null.
  const Results& results() const { return *results_; }
  const WorkStatus& status() const { return status_; }
  bool hasMesh() const { return results_->mesh != nullptr; }
  /// "bunny" for /models/bunny.obj; "" without a mesh.
  std::string modelName() const;

  /// True while the worker changes what the model shows; laying charts flat does not.
  bool changing() const { return status_.busy && !status_.unwrapping; }
  /// True when the view shows the finished labels rather than a part of the record.
  bool showsFinal() const;

  /// Changes parameters or seeds as an undoable step called `name`. With `dragging` further
  /// changes under the same `key` join it, until one without.
  void changeDocument(const Document& document, std::string name, const std::string& key,
                      bool dragging);
  void undo();
  void redo();
  const UndoHistory<Document>& undoHistory() const { return undo_; }

  /// What is shown beside the results; worked out on demand, never part of the state.
  Insight& insight() const { return *insight_; }
  /// The chart that is pointed at, on the model, in the texture, in a plot or in the table; kNone
  /// for none.
  Index hoveredChart() const;
  /// Chart of a face by the present labels, kNone without one.
  Index chartOfFace(Index face) const;
  /// Selects a chart and brings it into view, seen against its mean normal.
  /// \throws Error without such a chart
  void showChart(Index chart);
  /// Brings one face into view in the same way, and selects its chart.
  void showFace(Index face);

  /// Asks the session for a step.
  void request(const std::optional<StepRequest>& step);
  /// Opens a file or sample; plays one flood when it is there.
  void open(const std::filesystem::path& file);
  void openSample(const std::string& name, std::size_t triangles);

  ViewSettings view;
  Playback playback;
  HandleFilm film;
  Preferences preferences;
  PanelState panels;
  Notices notices;
  WindowRequests requests;
  /// Seeds for the next model that is opened, as faces of its file.
  std::vector<Index> firstSeeds;
  Index hoveredFace = kNone;   ///< under the mouse on the model or in the texture
  Index pointedChart = kNone;  ///< under the mouse in a plot or list; hoveredChart() says both
  Index selectedChart = kNone;
  /// Longest flood that is repeated while a slider is dragged, milliseconds.
  static constexpr double kLiveMilliseconds = 150;

 private:
  bool floodsLive(bool dragging) const;
  void placeSeeds();
  void takeNotices();

  void frameTriangles(const std::vector<Index>& triangles);

  Session session_;
  std::unique_ptr<Insight> insight_;
  std::shared_ptr<const Results> results_;
  WorkStatus status_;
  UndoHistory<Document> undo_;
  std::vector<std::string> journal_;
  std::uint64_t meshVersion_ = 0;
  bool playWhenOpened_ = false;
};

/// A command line that gives the present parameters and model: what differs from the defaults.
std::string commandLine(const AppState& state);

}  // namespace chartflood
