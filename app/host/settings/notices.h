#pragma once
/// What the program tells the user: short-lived toasts and a log that keeps everything.

#include <deque>
#include <mutex>
#include <string>
#include <vector>

#include "core/base/log.h"
#include "core/session/session.h"

namespace chartflood {

/// A sentence over the view.
struct Toast {
  Notice::Kind kind = Notice::Kind::Info;
  std::string text;
  double age = 0;  ///< seconds shown; the wait for the first frame does not count
  bool fresh = true;
};

class Notices {
 public:
  static constexpr std::size_t kMostToasts = 3;
  static constexpr std::size_t kMostLines = 2000;
  static constexpr double kToastSeconds = 5;
  static constexpr double kErrorSeconds = 15;

  Notices();
  ~Notices();
  Notices(const Notices&) = delete;
  Notices& operator=(const Notices&) = delete;

  /// Shows a toast and writes the sentence into the log.
  void add(Notice::Kind kind, std::string text);
  /// Ages the toasts and takes in what was logged by any thread.
  void update(double seconds);
  void close(std::size_t toast);

  const std::vector<Toast>& toasts() const { return toasts_; }
  /// Seconds after which a sentence goes away by itself.
  static double lasting(Notice::Kind kind) {
    return kind == Notice::Kind::Error ? kErrorSeconds : kToastSeconds;
  }
  /// Errors whose sentences went away before they were closed or the log was looked at.
  std::size_t missedErrors() const { return missedErrors_; }
  void forgetMissed() { missedErrors_ = 0; }

  struct Line {
    LogLevel level = LogLevel::Info;
    std::string text;
  };
  const std::deque<Line>& log() const { return log_; }

 private:
  void keep(Line line);

  std::vector<Toast> toasts_;
  std::deque<Line> log_;
  std::mutex mutex_;           ///< guards arrived_
  std::vector<Line> arrived_;  ///< logged since the last update
  int sink_ = 0;
  std::size_t missedErrors_ = 0;
};

}  // namespace chartflood
