#include "core/io/read/gltf_buffers.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/io/read/data_uri.h"
#include "core/io/read/gltf_meshopt.h"
#include "core/io/read/reference_path.h"

namespace chartflood {

GltfBuffers::GltfBuffers(const Source& source, const GltfDocument& document,
                         std::string_view binary)
    : source_(source), document_(document), binary_(binary), buffers_(document.buffers.size()),
      unpacked_(document.views.size()), size_(source.bytes.size()) {}

GltfBuffers::~GltfBuffers() = default;

/// Reads the file that a buffer names: with escapes resolved, or as the name stands.
void GltfBuffers::loadFile(std::size_t number, Buffer& buffer) {
  const std::string& uri = document_.buffers[number].uri;
  const std::string name = withoutEscapes(uri);
  Reference reference = findReference(source_.folder, name);
  if (!reference && name != uri) {
    if (Reference asItStands = findReference(source_.folder, uri)) reference = asItStands;
  }
  const std::string words = "its buffer " + shownName(name);
  if (!reference) source_.fail(words + " " + reference.refusal);
  try {
    buffer.file = std::make_unique<FileBytes>(reference.file);
  } catch (const ReadError& error) {
    source_.fail(words + " could not be read: " + error.cause());
  }
  buffer.bytes = buffer.file->view();
  size_ += buffer.bytes.size();
}

std::string_view GltfBuffers::buffer(std::size_t number, const std::string& owner) {
  if (number >= buffers_.size()) source_.fail(owner + " names a buffer that does not exist");
  if (buffers_[number]) return buffers_[number]->bytes;
  auto loaded = std::make_unique<Buffer>();
  const std::string& uri = document_.buffers[number].uri;
  if (uri.empty()) {
    loaded->bytes = number == 0 ? binary_ : std::string_view();
    if (loaded->bytes.empty()) {
      source_.fail(owner + " needs buffer " + std::to_string(number) + ", which has no data");
    }
  } else if (isDataUri(uri)) {
    std::optional<std::string> decoded = decodeDataUri(uri);
    if (!decoded) {
      source_.fail("its buffer " + std::to_string(number) +
                   " is written into the file as text that is no whole base64");
    }
    loaded->decoded = std::move(*decoded);
    loaded->bytes = loaded->decoded;
  } else {
    loadFile(number, *loaded);
  }
  buffers_[number] = std::move(loaded);
  return buffers_[number]->bytes;
}

std::string_view GltfBuffers::part(std::size_t number, std::size_t offset, std::size_t length,
                                   const std::string& owner) {
  const std::string_view bytes = buffer(number, owner);
  if (offset > bytes.size() || length > bytes.size() - offset) {
    source_.fail(owner + " lies in a buffer view that is longer than its buffer");
  }
  return bytes.substr(offset, length);
}

/// A packed view may stand beside plain data for programs that cannot unpack it.
bool GltfBuffers::isPacked(const GltfView& view) const {
  if (!view.meshopt) return false;
  const bool known = view.buffer < document_.buffers.size();
  const GltfBuffer plain = known ? document_.buffers[view.buffer] : GltfBuffer{"", true};
  const bool hasPlain = !plain.fallback && (!plain.uri.empty() || view.buffer == 0);
  const bool required =
      std::any_of(document_.required.begin(), document_.required.end(),
                  [](const std::string& name) { return name.ends_with("_meshopt_compression"); });
  return required || !hasPlain;
}

std::string_view GltfBuffers::view(std::size_t number, const std::string& owner) {
  if (number >= document_.views.size()) {
    source_.fail(owner + " names a buffer view that does not exist");
  }
  const GltfView& view = document_.views[number];
  if (!isPacked(view)) return part(view.buffer, view.offset, view.length, owner);
  if (!unpacked_[number]) {
    const GltfMeshopt& packed = *view.meshopt;
    const std::string_view bytes = part(packed.buffer, packed.offset, packed.length, owner);
    const MeshoptResult result = decodeMeshopt(packed, bytes);
    if (!result.refusal.empty()) {
      source_.fail(
          "its buffer view " + std::to_string(number) +
          " is compressed (EXT_meshopt_compression) and cannot be unpacked: " + result.refusal);
    }
    unpacked_[number] = std::make_unique<std::string>(std::move(result.bytes));
    size_ += unpacked_[number]->size();
  }
  return *unpacked_[number];
}

}  // namespace chartflood
