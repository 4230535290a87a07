#pragma once
/// Calls that need no window: one run of the pipeline, all outputs from it.

#include <cstddef>
#include <string_view>

#include "app/cli/options.h"

namespace chartflood {

/// Opens, segments, and writes every output that the call asks for; when one of them fails, none
/// is written.
/// \throws Error when something failed, UsageError, Interrupted
void runBatch(const Invocation& call);

/// Opens the mesh and prints what it holds.
void runInfo(const Invocation& call);

/// Finds out before a long computation whether its results can be written. \throws WriteError
void checkTargets(const Invocation& call);

/// Writes to standard output. \throws WriteError when it cannot take the text.
void printOutput(std::string_view text);

}  // namespace chartflood
