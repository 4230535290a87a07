#include "core/io/read/read_off.h"

#include <algorithm>

#include "core/base/counted.h"
#include "core/io/read/face_builder.h"
#include "core/io/text/text_rows.h"

namespace chartflood {

namespace {

/// The first word up to and with "OFF": "COFF", "ST4OFF"; "" when the text begins otherwise.
std::string_view headerWord(std::string_view word) {
  const std::size_t at = word.find("OFF");
  if (at == std::string_view::npos) return {};
  std::string_view prefix = word.substr(0, at);
  // In any order: programs differ in it.
  for (bool found = true; found;) {
    found = false;
    for (const std::string_view part : {"ST", "C", "N", "4", "n"}) {
      if (!prefix.starts_with(part)) continue;
      prefix.remove_prefix(part.size());
      found = true;
    }
  }
  return prefix.empty() ? word.substr(0, at + 3) : std::string_view{};
}

class OffReader {
 public:
  explicit OffReader(const Source& source)
      : source_(source), rows_(source, source.text(), '#'), faces_(mesh_) {}

  InputMesh read();

 private:
  void readHeader();
  std::size_t readCount(const char* what, std::size_t bytesEach);
  void readVertices();
  bool readFaces();

  const Source& source_;
  TextRows rows_;
  InputMesh mesh_;
  FaceBuilder faces_;
  bool homogeneous_ = false;
  std::size_t vertexCount_ = 0, faceCount_ = 0;
};

void OffReader::readHeader() {
  rows_.next();
  const char* const start = rows_.position();
  const std::string_view word = rows_.word();
  const std::string_view header = headerWord(word);
  if (header.empty()) source_.fail("it is not an OFF mesh: it does not begin with OFF");
  if (header.find('n') != std::string_view::npos) {
    source_.fail("its points have a number of dimensions of their own (nOFF); save it as OFF");
  }
  homogeneous_ = header.find('4') != std::string_view::npos;
  // The counts may follow without a blank.
  rows_.moveTo(start + header.size());
  if (source_.bytes.substr(static_cast<std::size_t>(rows_.position() - source_.begin()))
          .substr(0, 16)
          .find("BINARY") != std::string_view::npos) {
    source_.fail("it is a binary OFF file; save it as text OFF, PLY or OBJ");
  }
}

/// A count, checked against what the rest of the file can hold.
std::size_t OffReader::readCount(const char* what, std::size_t bytesEach) {
  rows_.next();
  const char* const place = rows_.position();
  const std::int64_t count = rows_.integer("a count");
  const std::size_t rest = static_cast<std::size_t>(source_.end() - rows_.position());
  if (count < 0) source_.failAtLine(place, std::string("counts fewer than 0 ") + what);
  if (static_cast<std::size_t>(count) > rest / bytesEach + 1) {
    source_.failAtLine(place, "counts " + std::to_string(count) + " " + what +
                                  ", more than the file can hold");
  }
  return static_cast<std::size_t>(count);
}

void OffReader::readVertices() {
  mesh_.positions.reserve(vertexCount_);
  for (std::size_t v = 0; v < vertexCount_; ++v) {
    if (v % 65536 == 0 && source_.report(rows_.position())) return;
    glm::dvec3 position;
    position.x = rows_.real("a coordinate");
    position.y = rows_.real("a coordinate");
    position.z = rows_.real("a coordinate");
    if (homogeneous_) {
      const char* const place = rows_.position();
      const double w = rows_.real("a fourth coordinate");
      if (w == 0) source_.failAtLine(place, "has a point at infinity (its fourth coordinate is 0)");
      position /= w;
    }
    mesh_.positions.push_back(position);
    if (rows_.moreOnLine()) rows_.skipLine();
  }
}

/// \returns false when cancelled.
bool OffReader::readFaces() {
  for (std::size_t f = 0; f < faceCount_; ++f) {
    if (f % 65536 == 0 && source_.report(rows_.position())) return false;
    const std::int64_t corners = rows_.integer("the number of corners of a face");
    if (corners < 0) source_.failAtLine(rows_.position(), "has a face with fewer than 0 corners");
    for (std::int64_t i = 0; i < corners; ++i) {
      const std::int64_t vertex = rows_.integer("a vertex number");
      if (vertex < 0 || vertex >= static_cast<std::int64_t>(vertexCount_)) {
        source_.failAtLine(rows_.position(), "names vertex " + std::to_string(vertex) +
                                                 " but there are " + std::to_string(vertexCount_) +
                                                 " (counted from 0)");
      }
      faces_.addCorner(static_cast<Index>(vertex));
    }
    faces_.endFace();
    if (rows_.moreOnLine()) rows_.skipLine();
  }
  return true;
}

InputMesh OffReader::read() {
  readHeader();
  source_.requireText("OFF");
  vertexCount_ = readCount("vertices", 6);
  faceCount_ = readCount("faces", 2);
  if (rows_.moreOnLine()) rows_.skipLine();
  if (vertexCount_ >= kNone) source_.fail("it has too many vertices");
  readVertices();
  if (mesh_.positions.size() < vertexCount_ || !readFaces()) return {};
  if (faceCount_ == 0) {
    source_.fail("it has " + counted(vertexCount_, "vertex", "vertices") + " but no faces");
  }
  if (rows_.next()) {
    mesh_.repairs.push_back({"rows-after-end-ignored", 1,
                             "The file goes on after the number of faces that it counts; the rest "
                             "was left out."});
  }
  return std::move(mesh_);
}

}  // namespace

InputMesh readOff(const Source& source) { return OffReader(source).read(); }

bool looksLikeOff(std::string_view bytes) {
  const std::size_t start = bytes.find_first_not_of(" \t\r\n");
  if (start == std::string_view::npos) return false;
  const std::string_view rest = bytes.substr(start, 16);
  return !headerWord(rest.substr(0, rest.find_first_of(" \t\r\n"))).empty();
}

}  // namespace chartflood
