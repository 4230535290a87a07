#include "core/io/gltf_accessor.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <string>
#include <type_traits>

#include <tiny_gltf.h>

namespace chartflood {

namespace {

/// Where the elements of an accessor (or of its sparse part) lie.
struct Layout {
  const unsigned char* first = nullptr;
  std::size_t stride = 0;
};

std::size_t componentSize(int type) {
  switch (type) {
  case TINYGLTF_COMPONENT_TYPE_BYTE:
  case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
    return 1;
  case TINYGLTF_COMPONENT_TYPE_SHORT:
  case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
    return 2;
  case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
  case TINYGLTF_COMPONENT_TYPE_FLOAT:
    return 4;
  default:
    return 0;
  }
}

template <class T>
double component(const unsigned char* p, bool normalized) {
  T value{};
  std::memcpy(&value, p, sizeof value);
  if constexpr (std::is_integral_v<T>) {
    if (normalized) {
      return std::max(static_cast<double>(value) / std::numeric_limits<T>::max(), -1.0);
    }
  }
  return static_cast<double>(value);
}

double component(const unsigned char* p, int type, bool normalized) {
  switch (type) {
  case TINYGLTF_COMPONENT_TYPE_BYTE:
    return component<std::int8_t>(p, normalized);
  case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
    return component<std::uint8_t>(p, normalized);
  case TINYGLTF_COMPONENT_TYPE_SHORT:
    return component<std::int16_t>(p, normalized);
  case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
    return component<std::uint16_t>(p, normalized);
  case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
    return component<std::uint32_t>(p, normalized);
  default:
    return component<float>(p, false);
  }
}

class AccessorReader {
 public:
  AccessorReader(const Source& source, const tinygltf::Model& model, int number)
      : source_(source), model_(model), number_(number) {
    if (number < 0 || static_cast<std::size_t>(number) >= model.accessors.size()) {
      source.fail("it names accessor " + std::to_string(number) + " but there are " +
                  std::to_string(model.accessors.size()));
    }
    accessor_ = &model.accessors[static_cast<std::size_t>(number)];
  }

  const tinygltf::Accessor& accessor() const { return *accessor_; }
  [[noreturn]] void fail(const std::string& cause) const {
    source_.fail("its accessor " + std::to_string(number_) + " " + cause);
  }
  /// Calls `use(i, element)` for each element, the sparse ones last. Elements without data are 0.
  template <class Use>
  void forEach(std::size_t components, Use&& use) const;

 private:
  Layout layout(int view, std::size_t offset, std::size_t count, std::size_t elementSize,
                bool mayStride) const;
  std::size_t bytesOfFile() const;

  const Source& source_;
  const tinygltf::Model& model_;
  int number_;
  const tinygltf::Accessor* accessor_ = nullptr;
};

/// Checks that `count` elements lie within their view, and the view within its buffer.
Layout AccessorReader::layout(int viewNumber, std::size_t offset, std::size_t count,
                              std::size_t elementSize, bool mayStride) const {
  if (viewNumber < 0 || static_cast<std::size_t>(viewNumber) >= model_.bufferViews.size()) {
    fail("names a buffer view that does not exist");
  }
  const tinygltf::BufferView& view = model_.bufferViews[static_cast<std::size_t>(viewNumber)];
  if (view.buffer < 0 || static_cast<std::size_t>(view.buffer) >= model_.buffers.size()) {
    fail("names a buffer that does not exist");
  }
  const std::vector<unsigned char>& data =
      model_.buffers[static_cast<std::size_t>(view.buffer)].data;
  if (view.byteOffset > data.size() || view.byteLength > data.size() - view.byteOffset) {
    fail("lies in a buffer view that is longer than its buffer");
  }
  const std::size_t stride = mayStride && view.byteStride != 0 ? view.byteStride : elementSize;
  if (stride < elementSize) fail("has elements that overlap");
  const bool starts = offset <= view.byteLength && elementSize <= view.byteLength - offset;
  if (count > 0 && (!starts || (view.byteLength - offset - elementSize) / stride < count - 1)) {
    fail("is longer than its buffer view");
  }
  return {data.data() + view.byteOffset + offset, stride};
}

std::size_t AccessorReader::bytesOfFile() const {
  std::size_t bytes = source_.bytes.size();
  for (const tinygltf::Buffer& buffer : model_.buffers) bytes += buffer.data.size();
  return bytes;
}

template <class Use>
void AccessorReader::forEach(std::size_t components, Use&& use) const {
  const std::size_t size = componentSize(accessor_->componentType) * components;
  if (size == 0) fail("has numbers of a type that is not part of glTF");
  if (accessor_->bufferView < 0 && !accessor_->sparse.isSparse) fail("has no data");
  // Without a view all elements are 0 at first; they shall not take more than the file is worth.
  if (accessor_->count > bytesOfFile()) fail("counts more elements than the file can hold");
  if (accessor_->bufferView >= 0) {
    const Layout at =
        layout(accessor_->bufferView, accessor_->byteOffset, accessor_->count, size, true);
    for (std::size_t i = 0; i < accessor_->count; ++i) use(i, at.first + i * at.stride);
  }
  if (!accessor_->sparse.isSparse) return;
  const auto& sparse = accessor_->sparse;
  if (sparse.count < 0 || sparse.indices.byteOffset < 0 || sparse.values.byteOffset < 0) {
    fail("has a sparse part with negative numbers");
  }
  const std::size_t count = static_cast<std::size_t>(sparse.count);
  const std::size_t indexSize = componentSize(sparse.indices.componentType);
  if (indexSize == 0) fail("has a sparse part with indices of a type that is not part of glTF");
  const Layout indices =
      layout(sparse.indices.bufferView, static_cast<std::size_t>(sparse.indices.byteOffset), count,
             indexSize, false);
  const Layout values =
      layout(sparse.values.bufferView, static_cast<std::size_t>(sparse.values.byteOffset), count,
             size, false);
  for (std::size_t i = 0; i < count; ++i) {
    const double index =
        component(indices.first + i * indexSize, sparse.indices.componentType, false);
    if (!(index >= 0) || index >= static_cast<double>(accessor_->count)) {
      fail("has a sparse part that names an element that does not exist");
    }
    use(static_cast<std::size_t>(index), values.first + i * size);
  }
}

}  // namespace

std::vector<glm::dvec3> gltfPositions(const Source& source, const tinygltf::Model& model,
                                      int number) {
  const AccessorReader reader(source, model, number);
  const tinygltf::Accessor& accessor = reader.accessor();
  if (accessor.type != TINYGLTF_TYPE_VEC3) reader.fail("gives positions that are not 3-vectors");
  const std::size_t size = componentSize(accessor.componentType);
  std::vector<glm::dvec3> positions;
  // Checks the count against the buffer before memory is asked for it.
  reader.forEach(3, [&](std::size_t i, const unsigned char* element) {
    if (positions.empty()) positions.resize(accessor.count);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      positions[i][static_cast<int>(axis)] =
          component(element + axis * size, accessor.componentType, accessor.normalized);
    }
  });
  return positions;
}

std::vector<std::uint32_t> gltfIndices(const Source& source, const tinygltf::Model& model,
                                       int number) {
  const AccessorReader reader(source, model, number);
  const tinygltf::Accessor& accessor = reader.accessor();
  const bool isUnsigned = accessor.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
                          accessor.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
                          accessor.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
  if (accessor.type != TINYGLTF_TYPE_SCALAR || !isUnsigned) {
    reader.fail("gives vertex numbers that are not unsigned whole numbers");
  }
  std::vector<std::uint32_t> indices;
  reader.forEach(1, [&](std::size_t i, const unsigned char* element) {
    if (indices.empty()) indices.resize(accessor.count);
    indices[i] = static_cast<std::uint32_t>(component(element, accessor.componentType, false));
  });
  return indices;
}

}  // namespace chartflood
