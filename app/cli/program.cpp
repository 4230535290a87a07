#include "app/cli/program.h"

#include <algorithm>
#include <cstdio>
#include <exception>

#include "app/cli/batch.h"
#include "app/cli/compare.h"
#include "app/cli/help.h"
#include "app/cli/info.h"
#include "app/cli/run_session.h"
#include "core/base/error.h"
#include "core/base/failure.h"
#include "core/base/log.h"
#include "core/base/parallel.h"

namespace chartflood {

namespace {

constexpr int kDone = 0, kFailed = 1, kWrongUsage = 2, kInterrupted = 130;

/// Shows messages on standard error for as long as it lives.
class ErrorStreamLog {
 public:
  explicit ErrorStreamLog(LogLevel level)
      : number_(addLogSink(level, [](LogLevel, const std::string& sentence) {
          std::fprintf(stderr, "%s\n", sentence.c_str());
        })) {}
  ErrorStreamLog(const ErrorStreamLog&) = delete;
  ErrorStreamLog& operator=(const ErrorStreamLog&) = delete;
  ~ErrorStreamLog() { removeLogSink(number_); }

 private:
  int number_;
};

int run(const Invocation& call, const WindowRunner& openWindow) {
  using Task = Invocation::Task;
  switch (call.task) {
  case Task::Help:
    printOutput(helpText());
    return kDone;
  case Task::Version:
    printOutput("chartflood " CHARTFLOOD_VERSION "\n");
    return kDone;
  case Task::ListSamples:
    printOutput(sampleList());
    return kDone;
  case Task::ListColormaps:
    printOutput(colorMapList());
    return kDone;
  case Task::ListBindings:
    printOutput(bindingList());
    return kDone;
  case Task::Info:
    runInfo(call);
    return kDone;
  case Task::Batch:
    call.compare.empty() ? runBatch(call) : runComparison(call);
    return kDone;
  case Task::Window:
    return openWindow(call);
  }
  return kFailed;
}

int fail(int code, const char* sentence) {
  std::fprintf(stderr, "chartflood: %s\n", sentence);
  return code;
}

}  // namespace

int runProgram(std::span<const std::string> words, const WindowRunner& openWindow) {
  try {
    const Invocation call = readOptions(words);
    // --info lists repairs itself.
    const bool listsRepairs = call.task == Invocation::Task::Info;
    const ErrorStreamLog log(listsRepairs ? std::max(call.verbose, LogLevel::Error) : call.verbose);
    setThreadCount(call.threads);
    return run(call, openWindow);
  } catch (const UsageError& error) {
    return fail(kWrongUsage, error.what());
  } catch (const Interrupted& error) {
    return fail(kInterrupted, error.what());
  } catch (const std::exception& error) {
    return fail(kFailed, failureSentence(error).c_str());
  }
}

}  // namespace chartflood
