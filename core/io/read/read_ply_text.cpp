/// Rows of an ASCII PLY file: one a line, though a row may go on in the next line.

#include <algorithm>

#include "core/base/counted.h"
#include "core/io/read/ply_elements.h"
#include "core/io/text/text_rows.h"

namespace chartflood {

namespace {

constexpr std::size_t kReportEvery = 1 << 16;

class TextReader {
 public:
  TextReader(const Source& source, const PlyHeader& header, InputMesh& mesh, PlyFaces& faces)
      : source_(source), rows_(source, header.data, 0), mesh_(mesh), faces_(faces) {}

  bool read(const PlyElement& element);
  std::size_t longRows() const { return longRows_; }

 private:
  void requireRoom(const PlyElement& element) const;
  void readVertex(const PlyElement& element, const PlyAxes& axes);
  void readFace(const PlyElement& element, std::size_t indexColumn);
  void skipRow(const PlyElement& element);
  std::size_t listLength();

  const Source& source_;
  TextRows rows_;
  InputMesh& mesh_;
  PlyFaces& faces_;
  std::size_t longRows_ = 0;
};

/// Refuses a count that the rest of the file cannot hold, before memory is asked for it: a value
/// takes a character and the blank behind it.
void TextReader::requireRoom(const PlyElement& element) const {
  const std::size_t room = static_cast<std::size_t>(source_.end() - rows_.position()) + 1;
  if (element.count <= room / (2 * element.properties.size())) return;
  source_.fail("its header counts " + std::to_string(element.count) + " rows of " +
               quotedWord(element.name.data(), element.name.data() + element.name.size()) +
               ", more than the file holds");
}

std::size_t TextReader::listLength() {
  const std::int64_t length = rows_.integer("the length of a list");
  if (length < 0) source_.failAtLine(rows_.position(), "has a list of negative length");
  return static_cast<std::size_t>(length);
}

void TextReader::readVertex(const PlyElement& element, const PlyAxes& axes) {
  glm::dvec3 position(0);
  for (std::size_t column = 0; column < element.properties.size(); ++column) {
    const std::size_t values = element.properties[column].list ? listLength() : 1;
    for (std::size_t i = 0; i < values; ++i) {
      const double value = rows_.real("a number");
      for (std::size_t axis = 0; axis < 3; ++axis) {
        if (axes[axis] == column) position[static_cast<int>(axis)] = value;
      }
    }
  }
  mesh_.positions.push_back(position);
}

void TextReader::readFace(const PlyElement& element, std::size_t indexColumn) {
  for (std::size_t column = 0; column < element.properties.size(); ++column) {
    const std::size_t values = element.properties[column].list ? listLength() : 1;
    for (std::size_t i = 0; i < values; ++i) {
      if (column != indexColumn) {
        rows_.real("a number");
        continue;
      }
      const std::int64_t vertex = rows_.integer("a vertex number");
      if (!faces_.add(vertex)) {
        source_.failAtLine(rows_.position(),
                           "names vertex " + std::to_string(vertex) + " but there are " +
                               std::to_string(faces_.vertexCount()) + " (counted from 0)");
      }
    }
  }
  faces_.endRow();
}

void TextReader::skipRow(const PlyElement& element) {
  for (const PlyProperty& property : element.properties) {
    const std::size_t values = property.list ? listLength() : 1;
    for (std::size_t i = 0; i < values; ++i) rows_.real("a number");
  }
}

bool TextReader::read(const PlyElement& element) {
  requireRoom(element);
  const bool vertices = element.name == "vertex", hasFaces = plyHoldsFaces(element);
  const PlyAxes axes = vertices ? plyAxes(source_, element) : PlyAxes{};
  const std::size_t indexColumn = hasFaces ? plyIndexColumn(source_, element) : 0;
  if (vertices) mesh_.positions.reserve(element.count);
  faces_.beginElement(element);
  for (std::size_t row = 0; row < element.count; ++row) {
    if (row % kReportEvery == 0 && source_.report(rows_.position())) return false;
    if (vertices) {
      readVertex(element, axes);
    } else if (hasFaces) {
      readFace(element, indexColumn);
    } else {
      skipRow(element);
    }
    if (rows_.moreOnLine()) {
      ++longRows_;
      rows_.skipLine();
    }
  }
  return true;
}

}  // namespace

bool readPlyText(const Source& source, const PlyHeader& header, InputMesh& mesh, PlyFaces& faces) {
  TextReader reader(source, header, mesh, faces);
  for (const PlyElement& element : header.elements) {
    if (!element.properties.empty() && !reader.read(element)) return false;
  }
  if (reader.longRows() > 0) {
    mesh.repairs.push_back({"surplus-values-ignored", reader.longRows(),
                            counted(reader.longRows(), "row holds", "rows hold") +
                                " more values than the header describes; they were left out."});
  }
  return true;
}

}  // namespace chartflood
