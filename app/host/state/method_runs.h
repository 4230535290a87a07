#pragma once
/// The three methods on one model, one after another on a worker of their own: the live state goes
/// on undisturbed.

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/session/session.h"

namespace chartflood {

class AppState;

class MethodRuns {
 public:
  explicit MethodRuns(Session::Worker worker) : worker_(worker) {}

  /// Begins with charts, cuts and unwrap of `document` and its seeds; what runs is given up.
  void begin(std::shared_ptr<const Mesh> mesh, const Document& document);
  /// Gives up at the next face; the worker is let go once it rests, see update().
  void stop();
  bool running() const { return session_ != nullptr && !stopped_; }

  struct State {
    std::string words;   ///< "vsa: Placing seeds"
    float fraction = 0;  ///< of the stage
  };
  /// \pre running()
  State state() const;

  /// One method's finished charts.
  struct Done {
    Document document;
    std::shared_ptr<const Results> results;
  };
  /// Goes on to the next method when one is done, and gives all once the last one is.
  /// \throws Error when a method failed; the others are given up
  std::optional<std::vector<Done>> update();

  /// As Session::setWake(), for the present run and later ones.
  void setWake(void (*wake)());

 private:
  void beginNext();

  Session::Worker worker_;
  std::unique_ptr<Session> session_;  ///< null: nothing runs
  Document document_;                 ///< that was begun with
  Document running_;                  ///< of the method that runs
  std::vector<Done> done_;
  bool stopped_ = false;  ///< waits for the worker to rest
  void (*wake_)() = nullptr;
};

/// Moves the runs on; puts the charts of all methods into the slots A, B and C, side by side, once
/// they are there. A failure becomes a notice.
void updateMethodRuns(AppState& state);

}  // namespace chartflood
