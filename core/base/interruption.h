#pragma once
/// Ctrl+C and the signals that ask the program to end, heard wherever it is.

#include <functional>

#include "core/base/error.h"

namespace chartflood {

/// The user pressed Ctrl+C (or the program was asked to end).
class Interrupted : public Error {
 public:
  Interrupted() : Error("Interrupted: nothing was written.") {}
};

/// From now on SIGINT, SIGTERM and SIGHUP are remembered instead of ending the program at once;
/// those that it was started to ignore stay ignored. A thread of its own hears them: what does not
/// end by itself within 0.2 s of the first, or at a second one, is ended by it after `cleanUp`,
/// with exit code 130. Work that must not be cut in two holds an UninterruptedScope.
///
/// Called by the only thread there is, as all later ones inherit that they leave the signals alone;
/// a second call changes nothing.
/// \param cleanUp called on the listening thread; must wait for nothing that the others may hold
void catchInterruptions(std::function<void()> cleanUp);

/// True once a signal came; false for ever where they are not caught.
bool interrupted() noexcept;

/// For loops whose rounds take long. \throws Interrupted once a signal came
void throwIfInterrupted();

/// While one exists nothing is ended from outside. Short: a signal has to wait for it.
class UninterruptedScope {
 public:
  UninterruptedScope();
  ~UninterruptedScope();
  UninterruptedScope(const UninterruptedScope&) = delete;
  UninterruptedScope& operator=(const UninterruptedScope&) = delete;
};

}  // namespace chartflood
