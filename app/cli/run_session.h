#pragma once
/// Drives a session from the command line: opens the mesh, segments it, shows progress on a
/// terminal and stops when the user interrupts.

#include <memory>
#include <vector>

#include "app/cli/options.h"
#include "core/base/interruption.h"
#include "core/session/session.h"

namespace chartflood {

/// Waits until the session rests; shows how far it is on a terminal.
/// \throws Error for what failed, Interrupted
void waitForSession(Session& session, const Invocation& call);

/// Opens the file or sample of the call.
/// \throws Error when it cannot be read, UsageError for an unknown sample.
void openInput(Session& session, const Invocation& call);

/// Segments the open mesh as the call asks: to the end, or for some faces or rounds.
/// \throws UsageError for a seed that is no face of the mesh
void segment(Session& session, const Invocation& call);

/// Lays the charts flat when an output of the call shows that; a flood that was stopped before its
/// end has none.
/// \throws Error when an output needs flat charts and there are none
void unwrap(Session& session, const Invocation& call);

}  // namespace chartflood
