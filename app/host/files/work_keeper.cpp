#include "app/host/files/work_keeper.h"

#include <algorithm>
#include <utility>

namespace chartflood {

void WorkKeeper::begin(const Document& document, std::filesystem::path file) {
  saved_ = document;
  file_ = std::move(file);
}

void WorkKeeper::beginRecovered(const std::filesystem::path& copy, std::filesystem::path file) {
  saved_.reset();
  file_ = std::move(file);
  recovery.adopt(copy);
  copied_.emplace();  // there is one, though an old one
}

void WorkKeeper::update(const Document& document, std::uint64_t version, bool resting,
                        double seconds, const std::function<std::string()>& text) {
  if (!recovery.on()) return;
  if (!unsaved(document)) {
    if (copied_) recovery.drop();
    copied_.reset();
    due_ = false;
    return;
  }
  if (document != seen_ || (resting && version != seenVersion_)) {
    seen_ = document;
    seenVersion_ = version;
    quiet_ = 0;
  } else {
    quiet_ += seconds;
  }
  const bool current = copied_ && *copied_ == document && (!resting || copiedVersion_ == version);
  due_ = !current;
  if (current || quiet_ < kQuietSeconds || !recovery.write(text())) return;
  copied_ = document;
  copiedVersion_ = version;
  due_ = false;
}

double WorkKeeper::dueIn() const {
  constexpr double kNever = 1e9, kSoon = 0.05;
  return due_ ? std::max(kSoon, kQuietSeconds - quiet_) : kNever;
}

}  // namespace chartflood
