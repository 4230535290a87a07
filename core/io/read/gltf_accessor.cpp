#include "core/io/read/gltf_accessor.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <string>
#include <type_traits>

namespace chartflood {

namespace {

// Numbers that the specification gives to OpenGL's constants.
enum Component { kByte = 5120, kUbyte, kShort, kUshort, kUint = 5125, kFloat, kDouble = 5130 };

/// Where the elements of an accessor (or of its sparse part) lie.
struct Layout {
  const char* first = nullptr;
  std::size_t stride = 0;
};

/// 0: no number that an accessor may have.
std::size_t componentSize(int type) {
  switch (type) {
  case kByte:
  case kUbyte:
    return 1;
  case kShort:
  case kUshort:
    return 2;
  case kUint:
  case kFloat:
    return 4;
  case kDouble:
    return 8;
  default:
    return 0;
  }
}

template <class T>
double component(const char* p, bool normalized) {
  T value{};
  std::memcpy(&value, p, sizeof value);
  if constexpr (std::is_integral_v<T>) {
    if (normalized) {
      return std::max(static_cast<double>(value) / std::numeric_limits<T>::max(), -1.0);
    }
  }
  return static_cast<double>(value);
}

double component(const char* p, int type, bool normalized) {
  switch (type) {
  case kByte:
    return component<std::int8_t>(p, normalized);
  case kUbyte:
    return component<std::uint8_t>(p, normalized);
  case kShort:
    return component<std::int16_t>(p, normalized);
  case kUshort:
    return component<std::uint16_t>(p, normalized);
  case kUint:
    return component<std::uint32_t>(p, normalized);
  case kDouble:
    return component<double>(p, false);
  default:
    return component<float>(p, false);
  }
}

class AccessorReader {
 public:
  AccessorReader(const GltfData& data, std::size_t number)
      : data_(data), name_("its accessor " + std::to_string(number)) {
    if (number >= data.document.accessors.size()) {
      data.source.fail("it names accessor " + std::to_string(number) + " but there are " +
                       std::to_string(data.document.accessors.size()));
    }
    accessor_ = &data.document.accessors[number];
  }

  const GltfAccessor& accessor() const { return *accessor_; }
  [[noreturn]] void fail(const std::string& cause) const { data_.source.fail(name_ + " " + cause); }
  /// Calls `use(i, element)` for each element, the sparse ones last. Elements without data are 0.
  template <class Use>
  void forEach(std::size_t components, Use&& use) const;

 private:
  Layout layout(std::size_t view, std::size_t offset, std::size_t count, std::size_t elementSize,
                bool mayStride) const;
  template <class Use>
  void forEachSparse(std::size_t size, Use&& use) const;

  const GltfData& data_;
  std::string name_;
  const GltfAccessor* accessor_ = nullptr;
};

/// Checks that `count` elements lie within their view, and the view within its buffer.
Layout AccessorReader::layout(std::size_t viewNumber, std::size_t offset, std::size_t count,
                              std::size_t elementSize, bool mayStride) const {
  const std::string_view bytes = data_.buffers.view(viewNumber, name_);
  const std::size_t gap = data_.document.views[viewNumber].stride;
  const std::size_t stride = mayStride && gap != 0 ? gap : elementSize;
  if (stride < elementSize) fail("has elements that overlap");
  const bool starts = offset <= bytes.size() && elementSize <= bytes.size() - offset;
  if (count > 0 && (!starts || (bytes.size() - offset - elementSize) / stride < count - 1)) {
    fail("is longer than its buffer view");
  }
  return {bytes.data() + offset, stride};
}

template <class Use>
void AccessorReader::forEach(std::size_t components, Use&& use) const {
  const std::size_t size = componentSize(accessor_->componentType) * components;
  if (size == 0) fail("has numbers of a type that is not part of glTF");
  const bool hasView = accessor_->view != kNoPart;
  if (!hasView && !accessor_->sparse) fail("has no data");
  Layout at;
  if (hasView) at = layout(accessor_->view, accessor_->offset, accessor_->count, size, true);
  // Without a view all elements are 0 at first; they shall not take more than the file is worth.
  if (accessor_->count > data_.buffers.size()) fail("counts more elements than the file can hold");
  if (hasView) {
    for (std::size_t i = 0; i < accessor_->count; ++i) use(i, at.first + i * at.stride);
  }
  if (accessor_->sparse) forEachSparse(size, use);
}

template <class Use>
void AccessorReader::forEachSparse(std::size_t size, Use&& use) const {
  const GltfSparse& sparse = *accessor_->sparse;
  const std::size_t indexSize = componentSize(sparse.indexType);
  if (indexSize == 0) fail("has a sparse part with indices of a type that is not part of glTF");
  const Layout indices =
      layout(sparse.indexView, sparse.indexOffset, sparse.count, indexSize, false);
  const Layout values = layout(sparse.valueView, sparse.valueOffset, sparse.count, size, false);
  for (std::size_t i = 0; i < sparse.count; ++i) {
    const double index = component(indices.first + i * indexSize, sparse.indexType, false);
    if (!(index >= 0) || index >= static_cast<double>(accessor_->count)) {
      fail("has a sparse part that names an element that does not exist");
    }
    use(static_cast<std::size_t>(index), values.first + i * size);
  }
}

template <class Vector>
std::vector<Vector> vectors(const GltfData& data, std::size_t number, const char* wrong) {
  constexpr std::size_t kLength = static_cast<std::size_t>(Vector::length());
  const AccessorReader reader(data, number);
  const GltfAccessor& accessor = reader.accessor();
  if (accessor.components != kLength) reader.fail(wrong);
  const std::size_t size = componentSize(accessor.componentType);
  std::vector<Vector> values;
  // Checks the count against the buffer before memory is asked for it.
  reader.forEach(kLength, [&](std::size_t i, const char* element) {
    if (values.empty()) values.resize(accessor.count);
    for (std::size_t axis = 0; axis < kLength; ++axis) {
      values[i][static_cast<int>(axis)] =
          component(element + axis * size, accessor.componentType, accessor.normalized);
    }
  });
  return values;
}

}  // namespace

std::vector<glm::dvec3> gltfPositions(const GltfData& data, std::size_t accessor) {
  return vectors<glm::dvec3>(data, accessor, "gives positions that are not 3-vectors");
}

std::vector<glm::dvec4> gltfRotations(const GltfData& data, std::size_t accessor) {
  return vectors<glm::dvec4>(data, accessor, "gives rotations that are not 4-vectors");
}

std::vector<std::uint32_t> gltfIndices(const GltfData& data, std::size_t number) {
  const AccessorReader reader(data, number);
  const GltfAccessor& accessor = reader.accessor();
  const int type = accessor.componentType;
  const bool isUnsigned = type == kUbyte || type == kUshort || type == kUint;
  if (accessor.components != 1 || !isUnsigned) {
    reader.fail("gives vertex numbers that are not unsigned whole numbers");
  }
  std::vector<std::uint32_t> indices;
  reader.forEach(1, [&](std::size_t i, const char* element) {
    if (indices.empty()) indices.resize(accessor.count);
    indices[i] = static_cast<std::uint32_t>(component(element, type, false));
  });
  return indices;
}

}  // namespace chartflood
