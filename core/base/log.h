#pragma once
/// Messages for the person at the program, with levels, to whoever listens.

#include <functional>
#include <string>
#include <string_view>

namespace chartflood {

enum class LogLevel { Debug, Info, Warning, Error, Quiet };

/// Receives each message as one sentence. Called under a lock: must not log itself.
using LogSink = std::function<void(LogLevel, const std::string&)>;

/// Adds a listener for messages of `level` and above; returns a number for `removeLogSink`.
int addLogSink(LogLevel level, LogSink sink);
void removeLogSink(int number);

/// Sends one sentence to every listener that wants its level. Any thread.
void logMessage(LogLevel level, std::string_view sentence);

}  // namespace chartflood
