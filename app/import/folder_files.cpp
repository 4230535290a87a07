#include "app/import/folder_files.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <memory>
#include <utility>

#include <assimp/IOStream.hpp>
#include <assimp/IOSystem.hpp>

#include "core/base/error.h"
#include "core/base/file_bytes.h"
#include "core/io/read/reference_path.h"

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
    const std::size_t from = origin == aiOrigin_SET   ? 0
                             : origin == aiOrigin_CUR ? at_
                                                      : bytes_.size();
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
      : folder_(folder), meshName_(std::move(meshName)), mesh_(mesh) {}

  bool Exists(const char* name) const override { return name == meshName_ || find(name); }
  char getOsSeparator() const override { return '/'; }
  Assimp::IOStream* Open(const char* name, const char* mode) override {
    if (mode == nullptr || *mode != 'r') return nullptr;
    if (name == meshName_) return new BytesStream(mesh_);
    const Reference found = find(name);
    if (!found) return nullptr;
    try {
      return new BytesStream(std::make_unique<FileBytes>(found.file));
    } catch (const ReadError&) {
      return nullptr;
    }
  }
  void Close(Assimp::IOStream* stream) override { delete stream; }
  bool CreateDirectory(const std::string&) override { return false; }
  bool ChangeDirectory(const std::string&) override { return false; }
  bool DeleteFile(const std::string&) override { return false; }

 private:
  Reference find(const char* name) const {
    return findReference(folder_, name == nullptr ? "" : name);
  }

  std::filesystem::path folder_;
  std::string meshName_;
  std::string_view mesh_;
};

}  // namespace

Assimp::IOSystem* newFolderFiles(const std::filesystem::path& folder, const std::string& meshName,
                                 std::string_view mesh) {
  return new FolderFiles(folder, meshName, mesh);
}

}  // namespace chartflood
