#include "app/host/files/recovery.h"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/base/error.h"
#include "core/base/failure.h"
#include "core/base/log.h"
#include "core/io/write/file_output.h"
#include "core/session/files/session_io.h"

namespace chartflood {

namespace {

constexpr const char* kBegin = "running-";
constexpr const char* kLockEnding = ".lock";
constexpr int kMostNames = 100;

std::filesystem::path lockOf(std::filesystem::path copy) {
  return copy.replace_extension(kLockEnding);
}

/// Takes the lock of a file that is made for it; -1 when another process holds it.
int lockFile(const std::filesystem::path& file, int flags) {
  const int descriptor = ::open(file.c_str(), O_RDWR | O_CLOEXEC | flags, 0600);
  if (descriptor < 0) return -1;
  if (::flock(descriptor, LOCK_EX | LOCK_NB) == 0) return descriptor;
  ::close(descriptor);
  return -1;
}

void removeCopy(const std::filesystem::path& copy) {
  std::error_code ignored;  // what is gone already is as good
  std::filesystem::remove(copy, ignored);
  std::filesystem::remove(lockOf(copy), ignored);
}

/// Whether nobody writes to this copy any more.
bool isLeft(const std::filesystem::path& copy) {
  const int lock = lockFile(lockOf(copy), O_CREAT);
  if (lock < 0) return false;
  ::close(lock);
  return true;
}

std::vector<std::filesystem::path> leftCopies(const std::filesystem::path& folder) {
  using Dated = std::pair<std::filesystem::file_time_type, std::filesystem::path>;
  std::vector<Dated> found;
  std::error_code error;
  for (std::filesystem::directory_iterator it(folder, error), end; !error && it != end;
       it.increment(error)) {
    const std::filesystem::path& path = it->path();
    const bool named = path.filename().string().starts_with(kBegin);
    std::error_code unknown;
    if (named && isSessionFile(path) && isLeft(path)) {
      found.emplace_back(it->last_write_time(unknown), path);
    }
    // A lock without a copy is all that is left of a process that had nothing to lose.
    if (named && path.extension() == kLockEnding) {
      std::filesystem::path copy = path;
      copy.replace_extension(kSessionEnding);
      if (!std::filesystem::exists(copy, unknown) && isLeft(copy)) removeCopy(copy);
    }
  }
  std::sort(found.begin(), found.end(), std::greater<>());
  std::vector<std::filesystem::path> copies;
  copies.reserve(found.size());
  for (Dated& each : found) copies.push_back(std::move(each.second));
  return copies;
}

}  // namespace

Recovery::~Recovery() {
  if (!on()) return;
  finishWriting();
  // While an exception ends the program the copy is all that is left of the work.
  std::error_code unknown;
  if (!std::filesystem::exists(file_, unknown)) removeCopy(file_);
  ::close(lock_);
}

void Recovery::end() {
  if (!on()) return;
  drop();
  removeCopy(file_);
  ::close(std::exchange(lock_, -1));
}

void Recovery::begin(const std::filesystem::path& folder) {
  if (on()) return;
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  left_ = leftCopies(folder);
  nameLeft();
  const std::string name = kBegin + std::to_string(::getpid());
  for (int i = 0; i < kMostNames && !on(); ++i) {
    // A name that exists belongs to another process, or holds what one left behind.
    file_ = folder / (name + (i == 0 ? "" : "-" + std::to_string(i)) + kSessionEnding);
    lock_ = lockFile(lockOf(file_), O_CREAT | O_EXCL);
  }
  if (!on()) {
    logMessage(LogLevel::Warning, "No copy of the running session can be kept in " +
                                      folder.string() + "; save it now and then.");
  }
}

bool Recovery::write(std::string text) {
  if (!on()) return true;
  using namespace std::chrono_literals;
  if (writing_.valid() && writing_.wait_for(0s) != std::future_status::ready) return false;
  finishWriting();
  writing_ = std::async(std::launch::async, [file = file_, bytes = std::move(text)] {
    try {
      writeFileAtomically(file, bytes);
    } catch (const std::exception& failure) {
      logMessage(LogLevel::Warning, failureSentence(failure));
    }
  });
  return true;
}

void Recovery::nameLeft() {
  leftTitle_.clear();
  if (left_.empty()) return;
  try {
    const SessionModel model = readSession(left_.front()).model;
    leftTitle_ = model.sample.empty() ? std::filesystem::path(model.file).filename().string()
                                      : "Sample " + model.sample;
  } catch (const std::exception&) {  // restoring it will say why
    leftTitle_ = left_.front().filename().string();
  }
  struct stat status {};
  std::tm local{};
  if (::stat(left_.front().c_str(), &status) != 0) return;
  if (::localtime_r(&status.st_mtime, &local) == nullptr) return;
  char when[64];
  if (std::strftime(when, sizeof when, ", %e %b %H:%M", &local) > 0) leftTitle_ += when;
}

void Recovery::finishWriting() {
  if (writing_.valid()) writing_.get();
}

void Recovery::drop() {
  finishWriting();
  std::error_code ignored;
  std::filesystem::remove(file_, ignored);
}

void Recovery::adopt(const std::filesystem::path& copy) {
  finishWriting();
  std::error_code ignored;  // without it the next write makes a copy
  std::filesystem::rename(copy, file_, ignored);
  removeCopy(copy);
  std::erase(left_, copy);
  nameLeft();
}

void Recovery::forget() {
  if (left_.empty()) return;
  removeCopy(left_.front());
  left_.erase(left_.begin());
  nameLeft();
}

}  // namespace chartflood
