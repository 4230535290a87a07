/// Rows of a binary PLY file, in either byte order.

#include <algorithm>
#include <array>
#include <bit>
#include <type_traits>

#include "core/io/read/ply_elements.h"

namespace chartflood {

namespace {

static_assert(std::endian::native == std::endian::little, "byte orders below assume it");

constexpr std::size_t kRowBlock = 1 << 12;  ///< rows between two reports; fits the nearest cache

/// One value of the file.
template <class T, bool swapped>
T load(const char* p) {
  std::array<char, sizeof(T)> bytes;
  for (std::size_t i = 0; i < sizeof(T); ++i) bytes[i] = p[swapped ? sizeof(T) - 1 - i : i];
  return std::bit_cast<T>(bytes);
}

/// Calls `use` with a zero of the C++ type of a PLY type.
template <class Use>
auto withType(PlyType type, Use&& use) {
  switch (type) {
  case PlyType::Int8:
    return use(std::int8_t{});
  case PlyType::UInt8:
    return use(std::uint8_t{});
  case PlyType::Int16:
    return use(std::int16_t{});
  case PlyType::UInt16:
    return use(std::uint16_t{});
  case PlyType::Int32:
    return use(std::int32_t{});
  case PlyType::UInt32:
    return use(std::uint32_t{});
  case PlyType::Float32:
    return use(float{});
  case PlyType::Float64:
    break;
  }
  return use(double{});
}

/// A value of any type; whole numbers of PLY are exact as doubles.
double loadAny(const char* p, PlyType type, bool swapped) {
  return withType(type, [&](auto zero) {
    using T = decltype(zero);
    return static_cast<double>(swapped ? load<T, true>(p) : load<T, false>(p));
  });
}

class BinaryReader {
 public:
  BinaryReader(const Source& source, const PlyHeader& header, InputMesh& mesh, PlyFaces& faces)
      : source_(source), p_(header.data),
        swapped_(header.encoding == PlyHeader::Encoding::BigEndian), mesh_(mesh), faces_(faces) {}

  bool read(const PlyElement& element);

 private:
  std::size_t rest() const { return static_cast<std::size_t>(source_.end() - p_); }
  void requireRoom(const PlyElement& element) const;
  void require(std::size_t bytes) const;
  [[noreturn]] void failVertex(std::int64_t vertex) const;

  bool readPlainVertices(const PlyElement& element);
  void readAxis(const PlyElement& element, std::size_t column, std::size_t axis, std::size_t begin,
                std::size_t end);
  bool readFaces(const PlyElement& element);
  template <class Count, class Entry, bool isSwapped>
  bool readListRows(const PlyElement& element, std::size_t before, std::size_t after);
  template <class Count, class Entry, bool isSwapped>
  bool readTriangleRows(const PlyElement& element, std::size_t before, std::size_t after,
                        std::size_t& row);
  bool readAnyRows(const PlyElement& element);
  void readAnyRow(const PlyElement& element, const PlyAxes& axes, std::size_t indexColumn);
  void readList(const PlyProperty& property, bool isIndices);

  const Source& source_;
  const char* p_;
  bool swapped_;
  InputMesh& mesh_;
  PlyFaces& faces_;
};

bool BinaryReader::read(const PlyElement& element) {
  requireRoom(element);
  faces_.beginElement(element);
  if (element.name == "vertex" && !element.hasList()) return readPlainVertices(element);
  const auto lists = std::count_if(element.properties.begin(), element.properties.end(),
                                   [](const PlyProperty& p) { return p.list; });
  if (element.name == "face" && lists == 1) return readFaces(element);
  return readAnyRows(element);
}

/// Refuses a count that the rest of the file cannot hold, before memory is asked for it.
void BinaryReader::requireRoom(const PlyElement& element) const {
  if (element.count <= rest() / element.smallestRow()) return;
  source_.fail("its header counts " + std::to_string(element.count) + " rows of " +
               quotedWord(element.name.data(), element.name.data() + element.name.size()) +
               ", more than the file holds");
}

void BinaryReader::require(std::size_t bytes) const {
  if (bytes > rest()) source_.failAtByte(p_, "the file ends inside this row");
}

void BinaryReader::failVertex(std::int64_t vertex) const {
  source_.failAtByte(p_, "a face names vertex " + std::to_string(vertex) + " but there are " +
                             std::to_string(faces_.vertexCount()) + " (counted from 0)");
}

/// Rows of fixed size: column by column, block by block.
bool BinaryReader::readPlainVertices(const PlyElement& element) {
  const PlyAxes axes = plyAxes(source_, element);
  mesh_.positions.resize(element.count);
  for (std::size_t begin = 0; begin < element.count; begin += kRowBlock) {
    if (source_.report(p_)) return false;
    const std::size_t end = std::min(begin + kRowBlock, element.count);
    for (std::size_t axis = 0; axis < 3; ++axis) readAxis(element, axes[axis], axis, begin, end);
    p_ += element.smallestRow() * (end - begin);
  }
  return true;
}

/// One coordinate of the vertices [begin, end), the first of which is at p_.
void BinaryReader::readAxis(const PlyElement& element, std::size_t column, std::size_t axis,
                            std::size_t begin, std::size_t end) {
  const char* from = p_;
  for (std::size_t i = 0; i < column; ++i) from += plySize(element.properties[i].type);
  const std::size_t stride = element.smallestRow();
  double* to = &mesh_.positions[begin].x + axis;
  withType(element.properties[column].type, [&](auto zero) {
    using T = decltype(zero);
    for (std::size_t v = begin; v < end; ++v, from += stride, to += 3) {
      *to = static_cast<double>(swapped_ ? load<T, true>(from) : load<T, false>(from));
    }
  });
}

/// Rows with one list between values of fixed size.
bool BinaryReader::readFaces(const PlyElement& element) {
  const std::size_t indices = plyIndexColumn(source_, element);
  std::size_t before = 0, after = 0;
  for (std::size_t column = 0; column < element.properties.size(); ++column) {
    if (column < indices) before += plySize(element.properties[column].type);
    if (column > indices) after += plySize(element.properties[column].type);
  }
  const PlyProperty& list = element.properties[indices];
  return withType(list.countType, [&](auto count) {
    return withType(list.type, [&](auto entry) {
      using Count = decltype(count);
      using Entry = decltype(entry);
      if constexpr (std::is_integral_v<Count> && std::is_integral_v<Entry>) {
        return swapped_ ? readListRows<Count, Entry, true>(element, before, after)
                        : readListRows<Count, Entry, false>(element, before, after);
      } else {
        return readAnyRows(element);
      }
    });
  });
}

template <class Count, class Entry, bool isSwapped>
bool BinaryReader::readListRows(const PlyElement& element, std::size_t before, std::size_t after) {
  std::size_t row = 0;
  if (!readTriangleRows<Count, Entry, isSwapped>(element, before, after, row)) return false;
  for (; row < element.count; ++row) {
    if (row % kRowBlock == 0 && source_.report(p_)) return false;
    require(before + sizeof(Count));
    const Count written = load<Count, isSwapped>(p_ + before);
    if (written < 0) source_.failAtByte(p_, "this face has a negative number of corners");
    const std::size_t corners = static_cast<std::size_t>(written);
    if (corners > rest() / sizeof(Entry)) source_.failAtByte(p_, "the file ends inside this row");
    require(before + sizeof(Count) + corners * sizeof(Entry) + after);
    const char* entry = p_ + before + sizeof(Count);
    for (std::size_t i = 0; i < corners; ++i, entry += sizeof(Entry)) {
      const std::int64_t vertex = load<Entry, isSwapped>(entry);
      if (!faces_.add(vertex)) failVertex(vertex);
    }
    faces_.endRow();
    p_ = entry + after;
  }
  return true;
}

/// The quick way for the triangles that a file begins with, usually all: `row` becomes the first
/// row that is another polygon. Stops with an error at a vertex that does not exist.
template <class Count, class Entry, bool isSwapped>
bool BinaryReader::readTriangleRows(const PlyElement& element, std::size_t before,
                                    std::size_t after, std::size_t& row) {
  if (!mesh_.corners.empty() || !mesh_.faceStart.empty()) return true;
  const std::size_t size = before + sizeof(Count) + 3 * sizeof(Entry) + after;
  const std::size_t most = std::min(element.count, rest() / size);
  mesh_.corners.resize(3 * most);
  Index* out = mesh_.corners.data();
  const std::size_t vertexCount = faces_.vertexCount();
  bool triangle = true;
  for (row = 0; row < most && triangle;) {
    if (source_.report(p_)) return false;
    const std::size_t end = std::min(row + kRowBlock, most);
    for (; row < end; ++row, p_ += size, out += 3) {
      if (load<Count, isSwapped>(p_ + before) != 3) {
        triangle = false;
        break;
      }
      for (std::size_t i = 0; i < 3; ++i) {
        const std::int64_t vertex =
            load<Entry, isSwapped>(p_ + before + sizeof(Count) + i * sizeof(Entry));
        // A negative number becomes a large one.
        if (static_cast<std::uint64_t>(vertex) >= vertexCount) failVertex(vertex);
        out[i] = static_cast<Index>(vertex);
      }
    }
  }
  mesh_.corners.resize(3 * row);
  faces_.builder().adoptTriangles();
  return true;
}

/// Any rows, value by value: strips, several lists, elements that are passed over.
bool BinaryReader::readAnyRows(const PlyElement& element) {
  const bool vertices = element.name == "vertex";
  const std::size_t none = element.properties.size();
  const PlyAxes axes = vertices ? plyAxes(source_, element) : PlyAxes{none, none, none};
  const std::size_t indexColumn = plyHoldsFaces(element) ? plyIndexColumn(source_, element) : none;
  for (std::size_t row = 0; row < element.count; ++row) {
    if (row % kRowBlock == 0 && source_.report(p_)) return false;
    if (vertices) mesh_.positions.emplace_back(0);
    readAnyRow(element, axes, indexColumn);
    if (indexColumn != none) faces_.endRow();
  }
  return true;
}

void BinaryReader::readAnyRow(const PlyElement& element, const PlyAxes& axes,
                              std::size_t indexColumn) {
  for (std::size_t column = 0; column < element.properties.size(); ++column) {
    const PlyProperty& property = element.properties[column];
    if (property.list) {
      readList(property, column == indexColumn);
      continue;
    }
    require(plySize(property.type));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (axes[axis] != column) continue;
      mesh_.positions.back()[static_cast<int>(axis)] = loadAny(p_, property.type, swapped_);
    }
    p_ += plySize(property.type);
  }
}

void BinaryReader::readList(const PlyProperty& property, bool isIndices) {
  require(plySize(property.countType));
  const double written = loadAny(p_, property.countType, swapped_);
  if (written < 0) source_.failAtByte(p_, "this list has a negative length");
  p_ += plySize(property.countType);
  const std::size_t length = static_cast<std::size_t>(written), size = plySize(property.type);
  if (length > rest() / size) source_.failAtByte(p_, "the file ends inside this list");
  for (std::size_t i = 0; isIndices && i < length; ++i) {
    const auto vertex = static_cast<std::int64_t>(loadAny(p_ + i * size, property.type, swapped_));
    if (!faces_.add(vertex)) failVertex(vertex);
  }
  p_ += length * size;
}

}  // namespace

bool readPlyBinary(const Source& source, const PlyHeader& header, InputMesh& mesh,
                   PlyFaces& faces) {
  BinaryReader reader(source, header, mesh, faces);
  for (const PlyElement& element : header.elements) {
    if (!element.properties.empty() && !reader.read(element)) return false;
  }
  return true;
}

}  // namespace chartflood
