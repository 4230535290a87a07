#include "core/io/file_bytes.h"

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

struct Descriptor {
  int number = -1;
  ~Descriptor() {
    if (number >= 0) ::close(number);
  }
};

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
  if (S_ISDIR(status.st_mode)) throw ReadError(name, "it is a folder; name a mesh file in it");
  if (S_ISFIFO(status.st_mode)) throw ReadError(name, "it is a pipe; only files can be read");
  throw ReadError(name, "it is a device or socket; only files can be read");
}

}  // namespace

FileBytes::FileBytes(const std::filesystem::path& file) {
  const std::string name = file.string();
  struct stat status = {};
  // Asked before opening, because opening a device can already do something.
  if (::stat(file.c_str(), &status) != 0) throw ReadError(name, causeOf(errno, file));
  requireRegular(status, name);
  // Without waiting, should a pipe have taken the file's place.
  const Descriptor opened{::open(file.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC)};
  if (opened.number < 0) throw ReadError(name, causeOf(errno, file));
  if (::fstat(opened.number, &status) != 0) throw ReadError(name, causeOf(errno, file));
  requireRegular(status, name);

  const std::size_t expected = static_cast<std::size_t>(status.st_size);
  try {
    bytes_ = std::make_unique_for_overwrite<char[]>(std::max<std::size_t>(expected, 1));
  } catch (const std::bad_alloc&) {
    throw ReadError(name, "it does not fit into memory");
  }
  while (size_ < expected) {
    const ssize_t got = ::read(opened.number, bytes_.get() + size_, expected - size_);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) throw ReadError(name, causeOf(errno, file));
    if (got == 0) break;  // the file became shorter; its reader says what is missing
    size_ += static_cast<std::size_t>(got);
  }
}

}  // namespace chartflood
