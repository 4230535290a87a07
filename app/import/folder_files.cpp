#include "app/import/folder_files.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <memory>
#include <optional>
#include <system_error>
#include <utility>

#include <assimp/IOStream.hpp>
#include <assimp/IOSystem.hpp>

#include "core/base/error.h"
#include "core/io/file_bytes.h"

namespace chartflood {

namespace {

/// Bytes in memory as a file of the library.
class BytesStream : public Assimp::IOStream {
 public:
  explicit BytesStream(std::string_view bytes) : bytes_(bytes) {}
  explicit BytesStream(std::unique_ptr<FileBytes> owned)
      : owned_(std::move(owned)), bytes_(owned_->view()) {}

  std::size_t Read(void* to, std::size_t size, std::size_t count) override {
    if (size == 0) return 0;
    const std::size_t whole = std::min(count, (bytes_.size() - at_) / size);
    std::memcpy(to, bytes_.data() + at_, whole * size);
    at_ += whole * size;
    return whole;
  }
  std::size_t Write(const void*, std::size_t, std::size_t) override { return 0; }
  aiReturn Seek(std::size_t offset, aiOrigin origin) override {
    const std::size_t from = origin == aiOrigin_SET ? 0 : origin == aiOrigin_CUR ? at_ : bytes_.size();
    // Backwards is a number that wraps around.
    const std::size_t to = from + offset;
    if (to > bytes_.size()) return aiReturn_FAILURE;
    at_ = to;
    return aiReturn_SUCCESS;
  }
  std::size_t Tell() const override { return at_; }
  std::size_t FileSize() const override { return bytes_.size(); }
  void Flush() override {}

 private:
  std::unique_ptr<FileBytes> owned_;
  std::string_view bytes_;
  std::size_t at_ = 0;
};

class FolderFiles : public Assimp::IOSystem {
 public:
  FolderFiles(const std::filesystem::path& folder, std::string meshName, std::string_view mesh)
      : meshName_(std::move(meshName)), mesh_(mesh) {
    std::error_code error;
    root_ = std::filesystem::canonical(folder, error);
    if (error) root_.clear();
  }

  bool Exists(const char* name) const override { return name == meshName_ || allowed(name); }
  char getOsSeparator() const override { return '/'; }
  Assimp::IOStream* Open(const char* name, const char* mode) override {
    if (mode == nullptr || *mode != 'r') return nullptr;
    if (name == meshName_) return new BytesStream(mesh_);
    const std::optional<std::filesystem::path> file = allowed(name);
    if (!file) return nullptr;
    try {
      return new BytesStream(std::make_unique<FileBytes>(*file));
    } catch (const ReadError&) {
      return nullptr;
    }
  }
  void Close(Assimp::IOStream* stream) override { delete stream; }
  bool CreateDirectory(const std::string&) override { return false; }
  bool ChangeDirectory(const std::string&) override { return false; }
  bool DeleteFile(const std::string&) override { return false; }

 private:
  /// Where the name leads after all links, when that is a regular file in the folder or below.
  std::optional<std::filesystem::path> allowed(const char* name) const;

  std::string meshName_;
  std::string_view mesh_;
  std::filesystem::path root_;  ///< empty when there is none: then nothing is allowed
};

std::optional<std::filesystem::path> FolderFiles::allowed(const char* name) const {
  if (name == nullptr || root_.empty()) return std::nullopt;
  std::error_code error;
  const std::filesystem::path real = std::filesystem::canonical(root_ / name, error);
  if (error || !std::filesystem::is_regular_file(real, error) || error) return std::nullopt;
  const auto [end, rest] = std::mismatch(root_.begin(), root_.end(), real.begin(), real.end());
  if (end != root_.end()) return std::nullopt;
  return real;
}

}  // namespace

Assimp::IOSystem* newFolderFiles(const std::filesystem::path& folder, const std::string& meshName,
                                 std::string_view mesh) {
  return new FolderFiles(folder, meshName, mesh);
}

}  // namespace chartflood
