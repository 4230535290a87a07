#include "core/base/log.h"

#include <algorithm>
#include <mutex>
#include <utility>
#include <vector>

namespace chartflood {

namespace {
struct Listener {
  int number;
  LogLevel level;
  LogSink sink;
};
std::mutex listenersMutex;
std::vector<Listener> listeners;
int nextNumber = 1;
}  // namespace

int addLogSink(LogLevel level, LogSink sink) {
  std::lock_guard lock(listenersMutex);
  listeners.push_back({nextNumber, level, std::move(sink)});
  return nextNumber++;
}

void removeLogSink(int number) {
  std::lock_guard lock(listenersMutex);
  std::erase_if(listeners, [&](const Listener& l) { return l.number == number; });
}

void logMessage(LogLevel level, std::string_view sentence) {
  const std::string text(sentence);
  std::lock_guard lock(listenersMutex);
  for (const Listener& listener : listeners) {
    if (level >= listener.level) listener.sink(level, text);
  }
}

}  // namespace chartflood
