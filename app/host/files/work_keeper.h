#pragma once
/// What would be lost: which session file belongs to the work, whether it has unsaved changes, and
/// the copy that outlives a crash.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "app/host/files/recovery.h"
#include "core/session/pipeline/document.h"

namespace chartflood {

class WorkKeeper {
 public:
  /// After a change the copy waits so long for the next one, seconds.
  static constexpr double kQuietSeconds = 0.7;

  /// A model or session was opened, or the session was saved: nothing is unsaved.
  void begin(const Document& document, std::filesystem::path file);
  /// The work that another process left in `copy` was taken up: all of it is unsaved.
  void beginRecovered(const std::filesystem::path& copy, std::filesystem::path file);
  /// The session file that Save writes; "": none yet.
  const std::filesystem::path& file() const { return file_; }

  /// True when the document is another than the saved one. What was only looked at is not.
  bool unsaved(const Document& document) const { return !saved_ || *saved_ != document; }

  /// Keeps the copy up to date: `version` grows with what was computed and counts only while the
  /// program rests. `text` makes the copy's content.
  void update(const Document& document, std::uint64_t version, bool resting, double seconds,
              const std::function<std::string()>& text);
  /// Seconds until update() has something to do; large for never.
  double dueIn() const;

  Recovery recovery;

 private:
  std::filesystem::path file_;
  std::optional<Document> saved_ = Document{};
  std::optional<Document> copied_;  ///< document of the copy; none: there is no copy
  std::uint64_t copiedVersion_ = 0;
  Document seen_;  ///< at the last update
  std::uint64_t seenVersion_ = 0;
  double quiet_ = 0;  ///< seconds since the last change
  bool due_ = false;  ///< the copy is out of date
};

}  // namespace chartflood
