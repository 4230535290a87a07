#pragma once
/// The whole content of a regular file, in memory.

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string_view>

namespace chartflood {

/// Reads once instead of mapping: a mapped file that another program shortens meanwhile would end
/// this program with a bus error.
class FileBytes {
 public:
  /// \throws ReadError when the file does not exist, is not a regular file (never opens a pipe or
  ///   device), may not be read, or does not fit into memory.
  explicit FileBytes(const std::filesystem::path& file);

  std::string_view view() const { return {bytes_.get(), size_}; }

 private:
  std::unique_ptr<char[]> bytes_;
  std::size_t size_ = 0;
};

}  // namespace chartflood
