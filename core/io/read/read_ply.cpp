#include "core/io/read/read_ply.h"

#include <utility>

#include "core/base/counted.h"
#include "core/io/read/ply_elements.h"

namespace chartflood {

namespace {

/// Looks at the header as a whole; finds the number of vertices beforehand, so that each index can
/// be checked where it is read.
std::size_t checkHeader(const Source& source, const PlyHeader& header) {
  std::size_t vertexElements = 0, faceElements = 0, vertexCount = 0;
  for (const PlyElement& element : header.elements) {
    if (element.name == "vertex") {
      ++vertexElements;
      vertexCount = element.count;
      plyAxes(source, element);
    } else if (plyHoldsFaces(element)) {
      ++faceElements;
      plyIndexColumn(source, element);
    }
  }
  if (vertexElements != 1) {
    source.fail(vertexElements == 0 ? "its header has no element named vertex"
                                    : "its header has more than one element named vertex");
  }
  if (faceElements == 0) {
    source.fail("it has " + counted(vertexCount, "vertex", "vertices") + " but no faces");
  }
  if (vertexCount >= kNone) source.fail("its header counts too many vertices");
  return vertexCount;
}

}  // namespace

PlyAxes plyAxes(const Source& source, const PlyElement& vertices) {
  PlyAxes axes{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::string_view name = std::string_view("xyz").substr(axis, 1);
    axes[axis] = vertices.find(name);
    if (axes[axis] == vertices.properties.size() || vertices.properties[axes[axis]].list) {
      source.fail("its vertices have no number named " + std::string(name));
    }
  }
  return axes;
}

std::size_t plyIndexColumn(const Source& source, const PlyElement& faces) {
  std::size_t column = faces.find("vertex_indices");
  if (column == faces.properties.size()) column = faces.find("vertex_index");
  if (column == faces.properties.size() || !faces.properties[column].list ||
      !plyIsWhole(faces.properties[column].type)) {
    source.fail("its faces have no list of whole numbers named vertex_indices");
  }
  return column;
}

bool PlyFaces::addToStrip(std::int64_t vertex) {
  if (vertex == -1) {
    stripLength_ = 0;
    return true;
  }
  if (vertex < 0 || vertex >= static_cast<std::int64_t>(vertexCount_)) return false;
  const Index c = static_cast<Index>(vertex);
  const Index a = beforeLast_, b = last_;
  // Triangles that repeat a vertex only lead the strip around a corner.
  if (stripLength_ >= 2 && a != b && b != c && c != a) {
    const bool even = stripLength_ % 2 == 0;
    faces_.addTriangle(even ? a : b, even ? b : a, c);
  }
  ++stripLength_;
  beforeLast_ = b;
  last_ = c;
  return true;
}

InputMesh readPly(const Source& source) {
  const PlyHeader header = readPlyHeader(source);
  InputMesh mesh;
  PlyFaces faces(mesh, checkHeader(source, header));
  const bool text = header.encoding == PlyHeader::Encoding::Ascii;
  const bool finished =
      text ? readPlyText(source, header, mesh, faces) : readPlyBinary(source, header, mesh, faces);
  if (!finished) return {};
  if (mesh.faceCount() == 0) {
    source.fail("it has " + counted(faces.vertexCount(), "vertex", "vertices") + " but no faces");
  }
  return mesh;
}

}  // namespace chartflood
