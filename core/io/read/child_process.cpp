#include "core/io/read/child_process.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <system_error>
#include <thread>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

namespace chartflood {

namespace {

constexpr int kMillisecondsPerLook = 20;
constexpr std::chrono::seconds kTimeToEnd{2};

[[noreturn]] void failWith(int error, const char* what) {
  throw std::system_error(error, std::generic_category(), what);
}

/// A descriptor that is closed at the end. Not one of the three standard streams: where the program
/// was started without those, their numbers are given out, and the child's streams would fall on
/// them.
class OwnDescriptor {
 public:
  explicit OwnDescriptor(int number) : number_(number) {
    if (number_ < 0) failWith(errno, "open");
    if (number_ > STDERR_FILENO) return;
    number_ = ::fcntl(number, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
    const int error = errno;
    ::close(number);
    if (number_ < 0) failWith(error, "fcntl");
  }
  OwnDescriptor(const OwnDescriptor&) = delete;
  OwnDescriptor& operator=(const OwnDescriptor&) = delete;
  ~OwnDescriptor() {
    if (number_ >= 0) ::close(number_);
  }
  int number() const { return number_; }
  int release() { return std::exchange(number_, -1); }

 private:
  int number_;
};

/// The bytes as a file without a name, at its beginning.
int fileOf(std::string_view bytes) {
  OwnDescriptor file(::memfd_create("chartflood-input", MFD_CLOEXEC));
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t put =
        ::pwrite(file.number(), bytes.data() + done, bytes.size() - done, static_cast<off_t>(done));
    if (put < 0 && errno == EINTR) continue;
    if (put < 0) failWith(errno, "write");
    done += static_cast<std::size_t>(put);
  }
  return file.release();
}

/// How the child begins: which descriptors it has, and no signal blocked or ignored.
class SpawnSettings {
 public:
  SpawnSettings(int input, int output) {
    posix_spawn_file_actions_init(&files_);
    posix_spawn_file_actions_adddup2(&files_, input, STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&files_, output, STDOUT_FILENO);
    posix_spawn_file_actions_addopen(&files_, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addclosefrom_np(&files_, STDERR_FILENO + 1);
    posix_spawnattr_init(&attributes_);
    posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK |
                                               POSIX_SPAWN_SETSIGDEF);
    posix_spawnattr_setpgroup(&attributes_, 0);
    sigset_t signals;
    sigemptyset(&signals);
    posix_spawnattr_setsigmask(&attributes_, &signals);
    sigfillset(&signals);
    posix_spawnattr_setsigdefault(&attributes_, &signals);
  }
  SpawnSettings(const SpawnSettings&) = delete;
  SpawnSettings& operator=(const SpawnSettings&) = delete;
  ~SpawnSettings() {
    posix_spawn_file_actions_destroy(&files_);
    posix_spawnattr_destroy(&attributes_);
  }
  const posix_spawn_file_actions_t& files() const { return files_; }
  const posix_spawnattr_t& attributes() const { return attributes_; }

 private:
  posix_spawn_file_actions_t files_;
  posix_spawnattr_t attributes_;
};

}  // namespace

ChildProcess::ChildProcess(const std::filesystem::path& program,
                           const std::vector<std::string>& arguments, std::string_view input) {
  const OwnDescriptor in(fileOf(input));
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) failWith(errno, "pipe");
  OwnDescriptor reading(ends[0]);
  const OwnDescriptor writing(ends[1]);
  std::string name = program.string();
  std::vector<std::string> words = arguments;
  std::vector<char*> argv{name.data()};
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  const SpawnSettings settings(in.number(), writing.number());
  const int error = ::posix_spawn(&process_, name.c_str(), &settings.files(),
                                  &settings.attributes(), argv.data(), environ);
  if (error != 0) {
    process_ = -1;
    failWith(error, "spawn");
  }
  answer_ = reading.release();
}

ChildProcess::~ChildProcess() {
  if (process_ >= 0) kill();
  if (answer_ >= 0) ::close(answer_);
}

ChildProcess::Read ChildProcess::read(std::span<std::byte> to,
                                      std::chrono::steady_clock::time_point deadline,
                                      const std::function<bool()>& cancelled) {
  while (!to.empty()) {
    if (cancelled()) return Read::Cancelled;
    if (std::chrono::steady_clock::now() >= deadline) return Read::TooLate;
    pollfd look{answer_, POLLIN, 0};
    const int ready = ::poll(&look, 1, kMillisecondsPerLook);
    if (ready < 0 && errno != EINTR) return Read::Ended;
    if (ready <= 0) continue;
    // Piece by piece, so that a long answer can be cancelled as well.
    constexpr std::size_t kPiece = 1 << 20;
    const ssize_t got = ::read(answer_, to.data(), std::min(to.size(), kPiece));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return Read::Ended;
    to = to.subspan(static_cast<std::size_t>(got));
  }
  return Read::Done;
}

int ChildProcess::waitForEnd() {
  const auto deadline = std::chrono::steady_clock::now() + kTimeToEnd;
  while (process_ >= 0) {
    int status = 0;
    const pid_t ended = ::waitpid(process_, &status, WNOHANG);
    if (ended == process_) {
      process_ = -1;
      return WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    }
    if (ended < 0 && errno != EINTR) {
      process_ = -1;  // somebody else has waited for it
    } else if (std::chrono::steady_clock::now() >= deadline) {
      kill();
      return SIGKILL;
    } else {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }
  return 0;
}

void ChildProcess::kill() {
  ::kill(process_, SIGKILL);
  while (::waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
  }
  process_ = -1;
}

}  // namespace chartflood
