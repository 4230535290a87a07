#pragma once
/// Everything the running viewer knows: the session, how it is looked at, the playback and what was
/// said to the user. No window and no widget: the same state serves scripts and tests.

#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/host/files/work_keeper.h"
#include "app/host/film/handle_film.h"
#include "app/host/film/moment_charts.h"
#include "app/host/film/playback.h"
#include "app/host/film/step_flash.h"
#include "app/host/insight/insight.h"
#include "app/host/settings/notices.h"
#include "app/host/settings/preferences.h"
#include "app/host/settings/undo_history.h"
#include "app/host/settings/view_settings.h"
#include "app/host/state/compare.h"
#include "app/host/state/hint_stroke.h"
#include "app/host/state/method_runs.h"
#include "app/host/state/run_watch.h"
#include "core/base/index.h"
#include "core/session/files/session_io.h"
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
  enum class Browse {
    Nothing,
    Open,
    SaveSession,
    SaveMesh,
    SaveUv,
    SaveSeams,
    SaveLabels,
    SaveReport
  };
  Browse browse = Browse::Nothing;  ///< what the file browser is open for
  bool problems = false;            ///< their list is unfolded
  Index shownFace = kNone;   ///< of the problem that was shown last, where it is a single face
  bool barsByValue = false;  ///< bars of charts stand by size, not by number
  int viewWidth = 1, viewHeight = 1;  ///< of all views of the model together, pixels
  int windowWidth = 1, windowHeight = 1;
  bool picture = false;  ///< the dialog of pictures is open
  bool legend = false;   ///< the editor of the colours is open
  bool keys = false, log = false, about = false;
  bool preferences = false;    ///< their window is open
  bool namesPreset = false;    ///< the question for a preset's name is asked
  std::string renamedPreset;   ///< of this one; "": for a new one
  bool search = false;         ///< the search for actions is open
  std::string shownParameter;  ///< its row is to be brought into view and given the keyboard
  bool firstCard = false;
  enum class Tool { Select, Seeds, Hints };
  Tool tool = Tool::Select;  ///< what the mouse does on the model
  HintBrush brush = HintBrush::Cut;
  bool unsavedQuestion = false;  ///< the question before unsaved changes are lost is asked
};

/// What undo brings back: the user's values, and the charts that they had given.
struct UndoStep {
  Document document;
  FloodMoment moment;
};

/// A seed that follows the mouse.
struct SeedDrag {
  std::size_t seed = 0;
  Index face = kNone;  ///< where it is now
};

/// A picture, or a row of them, to be taken by whoever owns the renderer.
struct PictureRequest {
  enum class Row { Single, Turntable, FloodFilm };
  std::filesystem::path file;  ///< "": the next free name in the folder of pictures
  PictureSettings settings;
  bool bare = false;     ///< without selection
  bool texture = false;  ///< the charts in the texture, at its size, instead of the view
  Row row = Row::Single;
};

/// How far a row of pictures is.
struct PictureRow {
  PictureRequest::Row row = PictureRequest::Row::Single;  ///< Single: none is being taken
  int done = 0, count = 0;

  bool running() const { return row != PictureRequest::Row::Single; }
};

/// What only the window's owner can do; it takes these and clears them.
struct WindowRequests {
  bool quit = false;
  bool toggleFullScreen = false;
  bool seedInView = false;  ///< a seed is to be added where the middle of the view shows
  std::optional<std::string> clipboard;  ///< text to be copied
  std::vector<PictureRequest> pictures;
  bool stopPictures = false;  ///< the row of pictures that is being taken is to end
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
  const std::shared_ptr<const Results>& sharedResults() const { return results_; }
  const WorkStatus& status() const { return status_; }
  bool hasMesh() const { return results_->mesh != nullptr; }
  /// "bunny" for /models/bunny.obj; "" without a mesh.
  std::string modelName() const;

  /// True while the worker changes what the model shows; laying charts flat does not.
  bool changing() const { return status_.busy && !status_.unwrapping; }
  /// True when the view shows the finished labels rather than a part of the record.
  bool showsFinal() const;
  /// Chart of each face at the moment shown, kNone while dry; empty without charts.
  std::span<const Index> shownLabels() const;
  /// Figures of the charts at the moment shown, null without any; while showsFinal() is false faces
  /// and Gauss areas alone.
  const std::shared_ptr<const ChartStats>& shownStats() const;
  /// True for a chart that cannot grow any more at the moment shown, while others can.
  bool closedOff(Index chart) const { return !showsFinal() && moment_.closedOff(chart); }

  /// True when dragging a slider changes the charts at once: by sketches where the model is not too
  /// large for them, else by floods where the preference and what the last one took allow it.
  bool answersDrags() const;

  /// The seeds of the charts that are or are about to be shown, with their locks. Where values are
  /// answered with finished charts those placed by hand stay where they were put.
  std::vector<PlacedSeed> presentSeeds() const;

  /// Goes to the finished charts of the present values, whatever is shown.
  void finish();
  /// Figures of the finished charts before the last change of values; null without any.
  const std::optional<CompareFigures>& earlierFigures() const { return earlierFigures_; }

  /// Changes parameters or seeds as an undoable step called `name`. With `dragging` further
  /// changes under the same `key` join it, until one without.
  void changeDocument(const Document& document, std::string name, const std::string& key,
                      bool dragging);
  /// Notes that something other than the document is about to change, so that it can be undone.
  void rememberCharts(std::string name);
  /// Makes a document and the charts of a moment the present ones, as an undoable step.
  void takeUp(const Document& document, const FloodMoment& moment, std::string name);
  void undo();
  void redo();
  /// Ends a drag that is to be forgotten: the document is as it was before it.
  void takeBackDrag();
  const UndoHistory<UndoStep>& undoHistory() const { return undo_; }

  /// What is shown beside the results; worked out on demand, never part of the state.
  Insight& insight() const { return *insight_; }
  /// What a comparison says of the live results; worked out when they have changed.
  const CompareFigures& liveFigures() const;
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
  /// Opens a mesh file, session, or picture that holds one, or a sample; plays one flood of a mesh.
  /// \throws ReadError for sessions and pictures
  void open(const std::filesystem::path& file);
  void openSample(const std::string& name, std::size_t triangles);
  /// Opens the session's model and goes on with it. `file` is where it is saved from now on.
  /// `recovered` is the copy it was read from when another process left it behind; it is unsaved.
  void openSession(SessionFile session, const std::filesystem::path& file,
                   const std::filesystem::path& recovered = {});
  /// The text of a session without a target, see sessionText(), that looks like `shown`.
  std::string sessionTextLike(const ViewSettings& shown) const;
  /// The model as a command line names it: a file, or a sample with its size.
  std::string modelWords(bool withFolder = true) const;
  /// False for a sample.
  bool modelIsFile() const { return model_.sample.empty(); }
  /// Writes the session. \throws WriteError
  void saveSession(const std::filesystem::path& file);
  /// True when changes of the document would be lost by ending now.
  bool unsaved() const { return hasMesh() && keeper.unsaved(document()); }
  /// Does at once what would lose unsaved changes when there are none or nobody wants to be asked;
  /// else asks, and does it after the answer.
  void whenSafe(std::function<void(AppState&)> step);
  /// Does what has waited for an answer, or forgets it.
  void goOn();
  void giveUp() { waiting_ = {}; }

  ViewSettings view;
  Playback playback;
  StepFlash flash;
  HandleFilm film;
  Compare compare;
  MethodRuns methodRuns;
  RunWatch runs;
  Preferences preferences;
  PanelState panels;
  Notices notices;
  WindowRequests requests;
  PictureRow pictureRow;  ///< kept up to date by whoever takes the pictures
  WorkKeeper keeper;
  std::optional<UserPreset> deletedPreset;  ///< can be brought back
  /// Writes the preferences where they are kept; nothing where they are not.
  std::function<void()> keepPreferences = [] {};
  /// Says that what is on disk is what the preferences are now: from here on they are written soon
  /// after each change.
  void preferencesAreKept();
  /// True while changed preferences wait to be written; for loops that sleep.
  bool keepsLater() const { return keptPreferences_ && *keptPreferences_ != preferences; }
  /// Seeds for the next model that is opened, as faces of its file.
  std::vector<Index> firstSeeds;
  std::optional<UpAxis> firstUp;     ///< upright axis of the next model; nothing: the likely one
  std::filesystem::path firstHints;  ///< the same for painted edges; "": none
  Index hoveredFace = kNone;         ///< under the mouse on the model or in the texture
  Index pointedChart = kNone;  ///< under the mouse in a plot or list; hoveredChart() says both
  Index selectedChart = kNone;
  Index chosenSeed = kNone;   ///< that the keyboard moves in the seeds tool
  Index hoveredSeed = kNone;  ///< under the mouse in the seeds tool
  std::optional<SeedDrag> seedDrag;
  std::optional<HintStroke> hintStroke;  ///< follows the mouse
  /// Longest flood that is repeated while a slider is dragged, milliseconds.
  static constexpr double kLiveMilliseconds = 150;
  /// Largest model that is sketched while a value is dragged, triangles.
  static constexpr std::size_t kMostSketched = 3'000'000;

 private:
  static constexpr std::size_t kNoRound = static_cast<std::size_t>(-1);

  /// What is being opened.
  struct Opening {
    SessionModel model;
    std::optional<SessionFile> session;
    std::filesystem::path sessionFile;
    std::filesystem::path recovered;
  };

  bool floodsLive(bool dragging) const;
  Session::Answer answerTo(bool dragging) const;
  FloodMoment presentMoment(const Results& results) const;
  UndoStep present() const;
  void restore(const UndoStep& step);
  void finishFirstFlood();
  void noteFigures();
  void takeNewMesh();
  void lookAtNewMesh();
  void takeSession(Opening& opening);
  void keepWork(double seconds);
  void keepLikes(double seconds);
  void movePlayback(double seconds);
  std::string sessionTextFor(const std::filesystem::path& file) const;
  std::string sessionTextOf(const ViewSettings& shown, const std::filesystem::path& file) const;
  std::filesystem::path findModel(const std::string& name,
                                  const std::filesystem::path& picture) const;
  void placeSeeds();
  void takeHints();
  void takeNotices();

  void frameTriangles(const std::vector<Index>& triangles);

  Session session_;
  std::unique_ptr<Insight> insight_;
  std::shared_ptr<const Results> results_;
  mutable CompareFigures figures_;  ///< of the results of `figuresVersion_`
  mutable std::uint64_t figuresVersion_ = 0;
  std::optional<CompareFigures> earlierFigures_;
  Preferences seenPreferences_;                 ///< of the last update
  double preferencesAge_ = 0;                   ///< seconds since they changed
  std::optional<Preferences> keptPreferences_;  ///< on disk; nothing: they are not kept
  bool firstFlood_ = false;  ///< of a model is being played; its charts are to be finished then
  MomentCharts moment_;
  std::size_t recalled_ = kNoRound;  ///< round whose log the session was asked for
  WorkStatus status_;
  UndoHistory<UndoStep> undo_;
  std::vector<std::string> journal_;
  std::uint64_t meshVersion_ = 0;
  std::optional<Opening> opening_;
  SessionModel model_;         ///< of the mesh that is shown
  std::string unknownInFile_;  ///< of the session file, written back
  std::map<std::string, SessionValue> unknownView_;
  std::function<void(AppState&)> waiting_;  ///< for the answer about unsaved changes
};

/// A command line that gives the present parameters and model: what differs from the defaults.
/// Without its folder a file is named alone.
std::string commandLine(const AppState& state, bool withFolder = true);
/// The same of another document, whose charts are `results`, on the present model.
std::string commandLine(const AppState& state, const Document& document, const Results& results,
                        bool withFolder = true);

}  // namespace chartflood
