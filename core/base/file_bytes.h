#pragma once
/// The one way in which the program opens files to read them: regular files, in limits, piece by
/// piece or whole.

#include <cstddef>
#include <filesystem>
#include <limits>
#include <memory>
#include <span>
#include <string_view>

namespace chartflood {

/// How large a file of a kind may be. Meshes have no limit but the memory.
struct FileLimit {
  std::size_t bytes = std::numeric_limits<std::size_t>::max();
  const char* kind = "a file";  ///< "a picture", for the sentence that refuses it
};

/// A regular file that is open: never a pipe or device.
class RegularFile {
 public:
  /// \throws ReadError when the file does not exist, is not a regular file, is larger than the
  ///   limit, or may not be read
  explicit RegularFile(const std::filesystem::path& file, const FileLimit& limit = {});
  ~RegularFile();
  RegularFile(const RegularFile&) = delete;
  RegularFile& operator=(const RegularFile&) = delete;

  std::size_t size() const { return size_; }  ///< in bytes, as it was opened
  /// Reads on. \returns the number of bytes, fewer than `most` at the end alone \throws ReadError
  std::size_t read(char* to, std::size_t most);

 private:
  std::filesystem::path name_;
  int descriptor_ = -1;
  std::size_t size_ = 0;
};

/// Reads once instead of mapping: a mapped file that another program shortens meanwhile would end
/// this program with a bus error.
class FileBytes {
 public:
  /// \throws ReadError as RegularFile, and when it does not fit into memory
  explicit FileBytes(const std::filesystem::path& file, const FileLimit& limit = {});

  std::string_view view() const { return {bytes_.get(), size_}; }
  std::span<const unsigned char> bytes() const {
    return {reinterpret_cast<const unsigned char*>(bytes_.get()), size_};
  }

 private:
  std::unique_ptr<char[]> bytes_;
  std::size_t size_ = 0;
};

}  // namespace chartflood
