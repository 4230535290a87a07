#include "app/host/settings/notices.h"

#include <algorithm>
#include <utility>

namespace chartflood {

namespace {

LogLevel levelOf(Notice::Kind kind) {
  switch (kind) {
  case Notice::Kind::Warning:
    return LogLevel::Warning;
  case Notice::Kind::Error:
    return LogLevel::Error;
  case Notice::Kind::Info:
    break;
  }
  return LogLevel::Info;
}

}  // namespace

Notices::Notices() {
  sink_ = addLogSink(LogLevel::Info, [this](LogLevel level, const std::string& text) {
    const std::scoped_lock lock(mutex_);
    arrived_.push_back({level, text});
  });
}

Notices::~Notices() { removeLogSink(sink_); }

void Notices::add(Notice::Kind kind, std::string text) {
  keep({levelOf(kind), text});
  const auto same = std::find_if(toasts_.begin(), toasts_.end(),
                                 [&](const Toast& toast) { return toast.text == text; });
  if (same != toasts_.end()) toasts_.erase(same);
  toasts_.push_back({kind, std::move(text), 0});
  while (toasts_.size() > kMostToasts) toasts_.erase(toasts_.begin());
}

void Notices::update(double seconds) {
  for (Toast& toast : toasts_) {
    if (!std::exchange(toast.fresh, false)) toast.age += seconds;
  }
  std::erase_if(toasts_, [this](const Toast& toast) {
    const bool over = toast.age > lasting(toast.kind);
    if (over && toast.kind == Notice::Kind::Error) ++missedErrors_;
    return over;
  });
  std::vector<Line> arrived;
  {
    const std::scoped_lock lock(mutex_);
    arrived.swap(arrived_);
  }
  for (Line& line : arrived) keep(std::move(line));
}

void Notices::close(std::size_t toast) {
  if (toast < toasts_.size()) toasts_.erase(toasts_.begin() + static_cast<std::ptrdiff_t>(toast));
}

void Notices::keep(Line line) {
  log_.push_back(std::move(line));
  if (log_.size() > kMostLines) log_.pop_front();
}

}  // namespace chartflood
