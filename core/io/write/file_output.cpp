#include "core/io/write/file_output.h"

#include <atomic>
#include <cerrno>
#include <cstring>
#include <mutex>
#include <set>
#include <string>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/base/error.h"
#include "core/base/interruption.h"

namespace chartflood {

namespace {

/// Names of the files that wait beside their targets.
class StagedNames {
 public:
  static StagedNames& all() {
    static auto* names = new StagedNames;  // outlives every thread that may still stage
    return *names;
  }
  void add(const std::filesystem::path& file) {
    const std::lock_guard lock(mutex_);
    names_.insert(file);
  }
  void remove(const std::filesystem::path& file) {
    const std::lock_guard lock(mutex_);
    names_.erase(file);
  }
  void unlinkAll() {
    const std::lock_guard lock(mutex_);
    for (const std::filesystem::path& file : names_) ::unlink(file.c_str());
  }

 private:
  std::mutex mutex_;
  std::set<std::filesystem::path> names_;
};

std::string causeOf(int error) {
  switch (error) {
  case ENOENT:
  case ENOTDIR:
    return "its folder does not exist";
  case EACCES:
  case EPERM:
    return "you have no permission to write there";
  case EROFS:
    return "the disk is read-only";
  case ENOSPC:
  case EDQUOT:
    return "the disk is full";
  case ELOOP:
    return "it is a symbolic link that leads back to itself";
  case ENAMETOOLONG:
    return "its name is too long";
  case EISDIR:
    return "it is a folder";
  default:
    return std::strerror(error);
  }
}

/// The file that is to be replaced, behind symbolic links.
std::filesystem::path resolved(const std::filesystem::path& target) {
  constexpr int kMostLinks = 40;
  std::error_code error;
  std::filesystem::path real = target;
  // Step by step, because the file at the end need not be there yet.
  for (int links = 0; std::filesystem::is_symlink(real, error); ++links) {
    if (links == kMostLinks) throw WriteError(target.string(), causeOf(ELOOP));
    const std::filesystem::path next = std::filesystem::read_symlink(real, error);
    if (error) throw WriteError(target.string(), causeOf(error.value()));
    real = real.parent_path() / next;
  }
  return real;
}

/// Refuses targets that cannot be replaced. \returns the rights of the old file, or -1 without one.
int rightsOfOldFile(const std::filesystem::path& asked, const std::filesystem::path& target) {
  struct stat status = {};
  if (::stat(target.c_str(), &status) != 0) return -1;
  if (S_ISDIR(status.st_mode)) throw WriteError(asked.string(), "it is a folder");
  if (!S_ISREG(status.st_mode)) throw WriteError(asked.string(), "it is no regular file");
  if (::access(target.c_str(), W_OK) != 0) {
    throw WriteError(asked.string(), "it is write-protected");
  }
  return static_cast<int>(status.st_mode & 07777);
}

/// Creates a file with a new name in a folder. \returns its descriptor, or -1 with errno set.
int createAside(const std::filesystem::path& folder, std::filesystem::path& aside) {
  static std::atomic<unsigned> counter{0};
  for (int attempt = 0; attempt < 1000; ++attempt) {
    aside = folder / (".chartflood-" + std::to_string(::getpid()) + "-" +
                      std::to_string(counter.fetch_add(1)));
    const int file = ::open(aside.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666);
    if (file >= 0 || errno != EEXIST) return file;
  }
  return -1;
}

/// Writes everything and waits until it is on the disk. \returns 0 or the error number.
int writeAll(int file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(file, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  // Otherwise a power cut after the rename could leave an empty file in place of the old one.
  return ::fsync(file) == 0 || errno == EINVAL ? 0 : errno;
}

}  // namespace

StagedFile::StagedFile(const std::filesystem::path& target, std::string_view bytes)
    : asked_(target), target_(resolved(target)) {
  const int rights = rightsOfOldFile(asked_, target_);
  const int file = createAside(target_.parent_path(), aside_);
  if (file < 0) throw WriteError(asked_.string(), causeOf(errno));
  StagedNames::all().add(aside_);
  int error = rights < 0 || ::fchmod(file, static_cast<mode_t>(rights)) == 0 ? 0 : errno;
  if (error == 0) error = writeAll(file, bytes);
  if (::close(file) != 0 && error == 0) error = errno;
  if (error != 0) {
    discard();  // the destructor does not run
    throw WriteError(asked_.string(), causeOf(error));
  }
}

StagedFile::StagedFile(StagedFile&& other) noexcept
    : asked_(std::move(other.asked_)), target_(std::move(other.target_)),
      aside_(std::exchange(other.aside_, {})) {}

StagedFile::~StagedFile() {
  if (!aside_.empty()) discard();
}

void StagedFile::discard() {
  ::unlink(aside_.c_str());
  StagedNames::all().remove(aside_);
}

void StagedFile::commit() {
  if (::rename(aside_.c_str(), target_.c_str()) != 0) {
    throw WriteError(asked_.string(), causeOf(errno));
  }
  StagedNames::all().remove(aside_);
  aside_.clear();
}

void commitAll(std::span<StagedFile> files) {
  const UninterruptedScope whole;
  for (StagedFile& file : files) file.commit();
}

void removeStagedFiles() noexcept { StagedNames::all().unlinkAll(); }

void writeFileAtomically(const std::filesystem::path& file, std::string_view bytes) {
  StagedFile(file, bytes).commit();
}

}  // namespace chartflood
