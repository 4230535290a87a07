#include "core/base/interruption.h"

#include <array>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <ctime>
#include <mutex>
#include <thread>
#include <utility>

#include <unistd.h>

namespace chartflood {

namespace {

constexpr std::array kSignals = {SIGINT, SIGTERM, SIGHUP};
constexpr int kExitCode = 130;
/// So long what works may take to come to its next question and to leave in order.
constexpr timespec kGrace = {.tv_sec = 0, .tv_nsec = 200'000'000};

std::atomic<bool> signalled{false};

std::mutex& uninterruptedMutex() {
  static std::mutex mutex;
  return mutex;
}

/// Those of kSignals that the program was not started to ignore (as `nohup` does).
sigset_t wantedSignals() {
  sigset_t set;
  sigemptyset(&set);
  for (const int number : kSignals) {
    struct sigaction now = {};
    sigaction(number, nullptr, &now);
    if (now.sa_handler != SIG_IGN) sigaddset(&set, number);
  }
  return set;
}

[[noreturn]] void endFromOutside(const std::function<void()>& cleanUp) {
  // Never let go again: whoever waits for it must not begin anything.
  uninterruptedMutex().lock();
  cleanUp();
  constexpr char kSentence[] = "chartflood: Interrupted.\n";
  [[maybe_unused]] const ssize_t told = ::write(STDERR_FILENO, kSentence, sizeof kSentence - 1);
  ::_exit(kExitCode);
}

void listen(const sigset_t& set, const std::function<void()>& cleanUp) {
  int number = 0;
  while (sigwait(&set, &number) != 0) {
  }
  signalled.store(true);
  sigtimedwait(&set, nullptr, &kGrace);
  endFromOutside(cleanUp);
}

}  // namespace

void catchInterruptions(std::function<void()> cleanUp) {
  static std::atomic<bool> caught{false};
  if (caught.exchange(true)) return;
  uninterruptedMutex();  // made now: it must outlive the listening thread
  const sigset_t set = wantedSignals();
  pthread_sigmask(SIG_BLOCK, &set, nullptr);
  std::thread([set, cleanUp = std::move(cleanUp)] { listen(set, cleanUp); }).detach();
}

bool interrupted() noexcept { return signalled.load(std::memory_order_relaxed); }

void throwIfInterrupted() {
  if (interrupted()) throw Interrupted();
}

UninterruptedScope::UninterruptedScope() { uninterruptedMutex().lock(); }
UninterruptedScope::~UninterruptedScope() { uninterruptedMutex().unlock(); }

}  // namespace chartflood
