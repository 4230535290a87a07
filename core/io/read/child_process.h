#pragma once
/// A program that is started beside this one, reads bytes and answers through a pipe.

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <sys/types.h>

namespace chartflood {

/// Lives no longer than this object: it is ended and waited for at the latest when that goes. Other
/// threads may start programs, read files and handle signals meanwhile; nothing of this program's
/// files is open in the other one but its standard streams. Signals of the terminal do not reach
/// it.
class ChildProcess {
 public:
  /// Starts it with `input` as its standard input and nothing behind its standard error.
  /// \throws std::system_error when it cannot be started
  ChildProcess(const std::filesystem::path& program, const std::vector<std::string>& arguments,
               std::string_view input);
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  enum class Read { Done, Ended, TooLate, Cancelled };
  /// Fills `to` with what the program answers next. `Ended` when the answer stops before.
  /// \param cancelled asked a few times a second and more
  Read read(std::span<std::byte> to, std::chrono::steady_clock::time_point deadline,
            const std::function<bool()>& cancelled);
  /// Waits for the end of a program that answers no more; one that does not end is ended.
  /// \returns the number of the signal that ended it, 0 for an end of its own
  int waitForEnd();

 private:
  void kill();

  pid_t process_ = -1;  ///< -1 once waited for
  int answer_ = -1;     ///< the end of the pipe from which its answer comes
};

}  // namespace chartflood
