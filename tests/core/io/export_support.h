#pragma once
/// Charted meshes for the tests of writers, laid flat by hand, and files taken apart by means of
/// the tests' own.

#include <cstddef>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/io/write/charted_mesh.h"

namespace chartflood::test {

/// Owns what a ChartedMesh refers to.
struct Charted {
  std::shared_ptr<const Mesh> mesh;
  std::vector<Index> label;
  ChartSet charts;
  Atlas atlas;

  ChartedMesh view() const { return {*mesh, label, charts, atlas}; }
};

/// The charts of a labelling, each put into a cell of its own of the texture along its mean normal.
Charted chartedMesh(std::shared_ptr<const Mesh> mesh, std::vector<Index> label);

/// Connected charts of a few faces each: faces are taken breadth first, `size` at a time.
Charted inPatches(std::shared_ptr<const Mesh> mesh, std::size_t size);

/// Opens a chart along sides of the mesh and lays it flat again.
void cutAlong(Charted& charted, Index chart, const std::vector<Index>& meshSides);

/// Faces that repeat corners (one of them is dropped), fans that need a vertex each, an edge of
/// three faces, a triangle, quads, a hexagon, a vertex without faces, numbers of all sizes.
std::shared_ptr<const Mesh> oddMesh();

/// Corners of an OBJ face, counted from 0; kNone without texture coordinate.
struct ObjCorner {
  Index vertex, texture;
};
struct ObjFile {
  std::vector<glm::dvec3> vertices;
  std::vector<glm::dvec2> texture;
  std::vector<std::vector<ObjCorner>> faces;
  std::vector<std::string> group;     ///< of each face
  std::vector<std::string> material;  ///< of each face
  struct Line {
    std::string group;
    Index a, b;
  };
  std::vector<Line> lines;
};
/// With streams and strtod alone.
ObjFile parseObj(const std::string& text);

/// Corners of a chart's faces that follow each other, by texture coordinate.
struct TextureTopology {
  std::set<Index> points;
  std::map<std::pair<Index, Index>, int> edges;  ///< and how many faces use each
  std::size_t faces = 0;

  long euler() const;
  /// Parts that the edges of one face only are connected to.
  std::size_t boundaryLoops() const;
};
/// One entry a group.
std::map<std::string, TextureTopology> textureTopologies(const ObjFile& obj);

struct PlyFile {
  struct Face {
    std::vector<Index> vertices;
    int chart = 0;
    std::vector<glm::vec2> texture;
  };
  std::string header;
  std::vector<glm::dvec3> vertices;
  std::vector<glm::vec2> texture;  ///< of vertices
  std::vector<Face> faces;
  bool finished = false;  ///< the bytes end with the last face
};
/// As plyBytes() writes it, and nothing else.
PlyFile parsePly(const std::string& bytes);

/// Reads values one after the other from bytes, least significant first.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : rest_(bytes) {}
  template <class T>
  T take() {
    T value{};
    if (rest_.size() < sizeof value) {
      overrun_ = true;
      return value;
    }
    rest_.copy(reinterpret_cast<char*>(&value), sizeof value);
    rest_.remove_prefix(sizeof value);
    return value;
  }
  bool finished() const { return rest_.empty() && !overrun_; }

 private:
  std::string_view rest_;
  bool overrun_ = false;
};

}  // namespace chartflood::test
