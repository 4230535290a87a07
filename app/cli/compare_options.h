#pragma once
/// Reads what --compare needs.

#include "app/cli/options.h"
#include "app/cli/tokens.h"

namespace chartflood {

/// Methods side by side, each run to its end, and the colours of their rows of pictures. What one
/// result alone can fill is refused. \throws UsageError
void readCompare(const Tokens& tokens, Invocation& call);

}  // namespace chartflood
