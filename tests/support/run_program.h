#pragma once
/// Starts a program as a user would and collects what it says.

#include <filesystem>
#include <string>
#include <vector>

#include "tests/support/temporary_folder.h"

namespace chartflood {

struct ProgramRun {
  int exitCode = -1;  ///< 128 + number of the signal when one ended it
  std::string output, errors;
};

/// Runs `words` (the first is the program) in `folder` with an empty standard input and no display.
/// With `interruptAfter` >= 0 it gets SIGINT after so many milliseconds.
/// \throws std::runtime_error when it cannot be started
ProgramRun runProgramIn(const std::filesystem::path& folder, const std::vector<std::string>& words,
                        int interruptAfter = -1);

std::string readAll(const std::filesystem::path& file);
void writeAll(const std::filesystem::path& file, const std::string& text);

}  // namespace chartflood
