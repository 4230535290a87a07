#pragma once
/// The whole program but its window: reads the command line, does what it asks, and turns failures
/// into one sentence and an exit code.

#include <functional>
#include <span>
#include <string>

#include "app/cli/options.h"

namespace chartflood {

/// Opens the window for a call and returns the program's exit code.
using WindowRunner = std::function<int(const Invocation&)>;

/// Runs one call; `words` are those after the program's name.
/// \returns 0 done, 1 failed, 2 wrong usage, 130 interrupted
int runProgram(std::span<const std::string> words, const WindowRunner& openWindow);

}  // namespace chartflood
