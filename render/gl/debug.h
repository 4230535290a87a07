#pragma once
/// The driver's complaints, sent to the log.

namespace chartflood::gl {

/// Sends every error that the driver reports for the current context to the log as a warning, at
/// the call that caused it. Returns false where the driver cannot (no KHR_debug).
bool logDriverErrors();

}  // namespace chartflood::gl
