#pragma once
/// What a long computation tells about itself, and how it is asked to stop.

#include <atomic>
#include <string>

namespace chartflood {

/// Shared by the thread that works and the threads that watch. Every member may be called from
/// any thread at any time. Cancelling is sticky: once asked, every later question says so.
class Progress {
 public:
  Progress() = default;
  /// Of a part of `whole`: is cancelled with it and tells nobody of its phases.
  explicit Progress(const Progress* whole) : whole_(whole) {}
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Begins a phase. `name` must be a literal or outlive the Progress.
  void beginPhase(const char* name) {
    fraction_.store(0.0f, std::memory_order_relaxed);
    phase_.store(name, std::memory_order_release);
  }
  /// Share of the phase that is done, in [0, 1]; never falls within a phase.
  void setFraction(float fraction) {
    float seen = fraction_.load(std::memory_order_relaxed);
    while (fraction > seen &&
           !fraction_.compare_exchange_weak(seen, fraction, std::memory_order_relaxed)) {
    }
  }
  void cancel() { cancelled_.store(true, std::memory_order_relaxed); }

  bool cancelled() const {
    return cancelled_.load(std::memory_order_relaxed) || (whole_ != nullptr && whole_->cancelled());
  }
  float fraction() const { return fraction_.load(std::memory_order_relaxed); }
  /// Name of the present phase, "" before the first.
  const char* phase() const { return phase_.load(std::memory_order_acquire); }

 private:
  std::atomic<float> fraction_{0.0f};
  std::atomic<const char*> phase_{""};
  std::atomic<bool> cancelled_{false};
  const Progress* whole_ = nullptr;
};

}  // namespace chartflood
