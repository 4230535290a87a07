#pragma once
/// --compare: one mesh, several methods, the same number of charts, the same cuts and unwrap.

#include "app/cli/options.h"

namespace chartflood {

/// Runs every method of the call; writes the pictures side by side, the report with one result a
/// method, and prints the table unless the report goes to standard output.
/// \throws Error when something failed, UsageError, Interrupted
void runComparison(const Invocation& call);

}  // namespace chartflood
