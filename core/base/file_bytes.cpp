#include "core/base/file_bytes.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <new>
#include <string>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/base/error.h"

namespace chartflood {

namespace {

bool isLink(const std::filesystem::path& file) {
  struct stat status = {};
  return ::lstat(file.c_str(), &status) == 0 && S_ISLNK(status.st_mode);
}

std::string causeOf(int error, const std::filesystem::path& file) {
  switch (error) {
  case ENOENT:
    return isLink(file) ? "it is a symbolic link to a file that does not exist"
                        : "there is no such file";
  case ENOTDIR:
    return "a part of its path is not a folder";
  case EACCES:
  case EPERM:
    return "you have no permission to read it";
  case ELOOP:
    return "it is a symbolic link that leads back to itself";
  case ENAMETOOLONG:
    return "its name is too long";
  default:
    return std::strerror(error);
  }
}

void requireRegular(const struct stat& status, const std::string& name) {
  if (S_ISREG(status.st_mode)) return;
  if (S_ISDIR(status.st_mode)) throw ReadError(name, "it is a folder; name a file in it");
  if (S_ISFIFO(status.st_mode)) throw ReadError(name, "it is a pipe; only files can be read");
  throw ReadError(name, "it is a device or socket; only files can be read");
}

void requireSize(std::size_t size, const FileLimit& limit, const std::string& name) {
  constexpr std::size_t kMega = 1'000'000;
  if (size <= limit.bytes) return;
  throw ReadError(name, std::string("it is too large for ") + limit.kind + ": it has " +
                            std::to_string((size + kMega - 1) / kMega) + " MB, and " +
                            std::to_string(limit.bytes / kMega) + " MB is the most");
}

}  // namespace

RegularFile::RegularFile(const std::filesystem::path& file, const FileLimit& limit) : name_(file) {
  const std::string name = file.string();
  struct stat status = {};
  // Asked before opening, because opening a device can already do something.
  if (::stat(file.c_str(), &status) != 0) throw ReadError(name, causeOf(errno, file));
  requireRegular(status, name);
  // Without waiting, should a pipe have taken the file's place.
  descriptor_ = ::open(file.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  if (descriptor_ < 0) throw ReadError(name, causeOf(errno, file));
  try {
    if (::fstat(descriptor_, &status) != 0) throw ReadError(name, causeOf(errno, file));
    requireRegular(status, name);
    size_ = static_cast<std::size_t>(status.st_size);
    requireSize(size_, limit, name);
  } catch (...) {
    ::close(descriptor_);  // the destructor does not run
    throw;
  }
}

RegularFile::~RegularFile() { ::close(descriptor_); }

std::size_t RegularFile::read(char* to, std::size_t most) {
  std::size_t size = 0;
  while (size < most) {
    const ssize_t got = ::read(descriptor_, to + size, most - size);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) throw ReadError(name_.string(), causeOf(errno, name_));
    if (got == 0) break;
    size += static_cast<std::size_t>(got);
  }
  return size;
}

FileBytes::FileBytes(const std::filesystem::path& file, const FileLimit& limit) {
  RegularFile opened(file, limit);
  try {
    bytes_ = std::make_unique_for_overwrite<char[]>(std::max<std::size_t>(opened.size(), 1));
  } catch (const std::bad_alloc&) {
    throw ReadError(file.string(), "it does not fit into memory");
  }
  // When the file became shorter meanwhile, its reader says what is missing.
  size_ = opened.read(bytes_.get(), opened.size());
}

}  // namespace chartflood
