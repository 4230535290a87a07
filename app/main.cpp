// The program: the command line decides between batch work and the window.

#include <span>
#include <string>
#include <vector>

#include "app/cli/program.h"
#include "app/gui/window_main.h"
#include "core/base/log.h"

namespace {

int openWindow(const chartflood::Invocation& call) {
  if (!call.session) {  // a session's are told when it is opened
    for (const std::string& sentence : call.warnings) {
      chartflood::logMessage(chartflood::LogLevel::Warning, sentence);
    }
  }
  chartflood::WindowOptions options;
  options.parameters = call.parameters;
  options.seeds = call.seeds;
  options.hints = call.hints;
  options.session = call.session;
  options.sessionFile = call.sessionFile;
  options.file = call.file;
  options.sample = call.sample;
  options.triangles = call.triangles;
  options.preferences = call.preferences;
  options.render = call.picture.settings;
  options.up = call.picture.camera.up;
  options.orthographic = call.picture.camera.orthographic;
  return chartflood::runWindow(options);
}

}  // namespace

int main(int count, char** arguments) {
  const std::vector<std::string> words(arguments + 1, arguments + count);
  return chartflood::runProgram(words, openWindow);
}
