#pragma once
/// The bytes that the views of a glTF file show: out of the file itself, out of text, or out of
/// files in its folder; decompressed where they are packed.

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/file_bytes.h"
#include "core/io/read/gltf_document.h"
#include "core/io/text/source.h"

namespace chartflood {

/// Loads buffers and unpacks views when they are asked for first, so that what no geometry uses is
/// not looked at. Source and document stay where they are meanwhile.
class GltfBuffers {
 public:
  /// \param binary the binary part of a GLB file, "" without one
  GltfBuffers(const Source& source, const GltfDocument& document, std::string_view binary);
  ~GltfBuffers();

  /// The bytes of a view.
  /// \param owner "its accessor 3", for messages
  /// \throws ReadError when view or buffer is not there, or ends before the view does
  std::string_view view(std::size_t number, const std::string& owner);

  /// All bytes that belong to the file as far as they were loaded.
  std::size_t size() const { return size_; }

 private:
  struct Buffer {
    std::string_view bytes;
    std::string decoded;  ///< of text
    std::unique_ptr<FileBytes> file;
  };

  std::string_view buffer(std::size_t number, const std::string& owner);
  std::string_view part(std::size_t buffer, std::size_t offset, std::size_t length,
                        const std::string& owner);
  void loadFile(std::size_t number, Buffer& buffer);
  bool isPacked(const GltfView& view) const;

  const Source& source_;
  const GltfDocument& document_;
  std::string_view binary_;
  std::vector<std::unique_ptr<Buffer>> buffers_;
  std::vector<std::unique_ptr<std::string>> unpacked_;  ///< of each view
  std::size_t size_ = 0;
};

}  // namespace chartflood
