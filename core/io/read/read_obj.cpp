#include "core/io/read/read_obj.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <vector>

#include "core/base/counted.h"
#include "core/io/read/face_builder.h"
#include "core/io/text/parse_number.h"

namespace chartflood {

namespace {

/// Keywords of the format that say nothing about vertices and faces.
constexpr std::array<std::string_view, 38> kOtherKeywords = {
    "vp",    "deg",      "bmat",       "step",      "cstype", "curv",  "curv2", "surf",
    "parm",  "trim",     "hole",       "scrv",      "sp",     "end",   "con",   "mg",
    "bevel", "c_interp", "d_interp",   "lod",       "ctech",  "stech", "call",  "csh",
    "res",   "bsp",      "shadow_obj", "trace_obj", "bzp",    "cdc",   "cdp",   "s",
    "g",     "o",        "usemap",     "maplib",    "mtllib", "usemtl"};

/// Lines that end in a name, where a final backslash belongs to the name.
constexpr std::array<std::string_view, 6> kNameKeywords = {"g",      "o",      "usemtl",
                                                           "mtllib", "usemap", "maplib"};

template <std::size_t n>
bool contains(const std::array<std::string_view, n>& words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

class ObjReader {
 public:
  explicit ObjReader(const Source& source)
      : source_(source), p_(source.text()), end_(source.end()), faces_(mesh_) {
    if (source.bytes.find('\n') == std::string_view::npos) lineEnd_ = '\r';
  }

  InputMesh read();

 private:
  /// A face that named something which had not come yet when it was read.
  struct Early {
    const char* position = nullptr;
    std::int64_t vertex = 0, texture = 0, normal = 0;
  };

  bool atBlank() const { return *p_ == ' ' || *p_ == '\t' || (*p_ == '\r' && lineEnd_ != '\r'); }
  bool atLineEnd() const { return p_ == end_ || *p_ == lineEnd_; }
  bool skipContinuation();
  void skipBlanks();
  void skipLine(bool continues);
  void readLine();
  void readVertex();
  double readCoordinate();
  void readFace();
  Index readCorner(Early& early);
  std::int64_t readVertexNumber(std::int64_t& early);
  void readUnneeded(std::size_t count, std::int64_t& early);
  void readOther();
  void checkEarlyFaces();
  void addRepairs();

  const Source& source_;
  const char* p_;
  const char* end_;
  char lineEnd_ = '\n';
  InputMesh mesh_;
  FaceBuilder faces_;
  std::size_t textureCount_ = 0, normalCount_ = 0;
  std::size_t pointsAndLines_ = 0, unknownLines_ = 0, missingReferences_ = 0;
  std::vector<Early> earlyFaces_;
};

/// Skips a backslash at the end of a line together with the line's end.
bool ObjReader::skipContinuation() {
  if (*p_ != '\\') return false;
  const char* next = p_ + 1;
  if (next < end_ && *next == '\r' && lineEnd_ != '\r') ++next;
  if (next == end_ || *next != lineEnd_) return false;
  p_ = next + 1;
  return true;
}

void ObjReader::skipBlanks() {
  // Nearly always one blank between two words.
  if (p_ < end_ && *p_ == ' ') ++p_;
  if (p_<end_&& * p_> ' ' && *p_ != '\\') return;
  while (p_ < end_ && (atBlank() || skipContinuation())) {
    if (atBlank()) ++p_;
    if (p_ == end_) return;
  }
}

void ObjReader::skipLine(bool continues) {
  if (p_ < end_ && *p_ == lineEnd_) {
    ++p_;
    return;
  }
  while (p_ < end_) {
    const void* found = std::memchr(p_, lineEnd_, static_cast<std::size_t>(end_ - p_));
    if (found == nullptr) {
      p_ = end_;
      return;
    }
    const char* const stop = static_cast<const char*>(found);
    const char* last = stop;
    while (last > p_ && last[-1] == '\r') --last;
    const bool again = continues && last > p_ && last[-1] == '\\';
    p_ = stop + 1;
    if (!again) return;
  }
}

InputMesh ObjReader::read() {
  source_.requireText("OBJ");
  for (std::size_t lines = 0; p_ < end_; ++lines) {
    if (lines % 65536 == 0 && source_.report(p_)) return {};
    readLine();
  }
  checkEarlyFaces();
  addRepairs();
  return std::move(mesh_);
}

void ObjReader::readLine() {
  skipBlanks();
  if (p_ == end_) return;
  const char key = *p_;
  const char next = p_ + 1 < end_ ? p_[1] : lineEnd_;
  const bool single = next == ' ' || next == '\t';
  if (key == 'v' && single) {
    ++p_;
    readVertex();
  } else if (key == 'f' && (single || next == '\r' || next == lineEnd_)) {
    ++p_;
    readFace();
  } else if (key == 'v' && next == 't') {
    ++textureCount_;
    skipLine(true);
  } else if (key == 'v' && next == 'n') {
    ++normalCount_;
    skipLine(true);
  } else if (key == '#' || key == lineEnd_) {
    skipLine(false);
  } else {
    readOther();
  }
}

void ObjReader::readVertex() {
  glm::dvec3 position;
  position.x = readCoordinate();
  position.y = readCoordinate();
  position.z = readCoordinate();
  mesh_.positions.push_back(position);
  skipLine(true);
}

double ObjReader::readCoordinate() {
  skipBlanks();
  if (atLineEnd()) source_.failAtLine(p_, "gives fewer than three coordinates for a vertex");
  const RealResult number = parseReal(p_, end_);
  if (number.status == NumberStatus::TooLarge) {
    source_.failAtLine(p_, "has " + quotedWord(p_, end_) + ", which is too large a number");
  }
  const bool whole = number.end == end_ || *number.end == ' ' || *number.end == '\t' ||
                     *number.end == '\r' || *number.end == '\n' || *number.end == '\\';
  if (number.status != NumberStatus::Ok || !whole) {
    source_.failAtLine(p_, "has " + quotedWord(p_, end_) + " where a coordinate is expected");
  }
  p_ = number.end;
  return number.value;
}

void ObjReader::readFace() {
  Early early;
  early.position = p_;
  for (;;) {
    skipBlanks();
    if (atLineEnd() || *p_ == '#') break;
    faces_.addCorner(readCorner(early));
  }
  faces_.endFace();
  if (early.vertex + early.texture + early.normal > 0) earlyFaces_.push_back(early);
  skipLine(false);
}

/// Reads "v", "v/t", "v//n" or "v/t/n"; returns the vertex, counted from 0.
Index ObjReader::readCorner(Early& early) {
  const char* const begin = p_;
  const Index vertex = static_cast<Index>(readVertexNumber(early.vertex));
  if (p_ < end_ && *p_ == '/') {
    ++p_;
    readUnneeded(textureCount_, early.texture);
    if (p_ < end_ && *p_ == '/') {
      ++p_;
      readUnneeded(normalCount_, early.normal);
    }
  }
  if (p_ < end_ && !atBlank() && !atLineEnd() && *p_ != '\\') {
    source_.failAtLine(p_, "has " + quotedWord(begin, end_) + " where a vertex number is expected");
  }
  return vertex;
}

/// The number of a vertex, counted from 0; one that has not come yet is kept in `early`, counted
/// from 1.
std::int64_t ObjReader::readVertexNumber(std::int64_t& early) {
  // Plain short numbers of vertices that came before: nearly all.
  std::uint64_t plain = 0;
  const char* const p = parseDigits(p_, end_, plain);
  const bool ended = p < end_ && p - p_ < 10 && (*p == ' ' || *p == '/' || *p == '\n');
  if (ended && plain - 1 < mesh_.positions.size()) {
    p_ = p;
    return static_cast<std::int64_t>(plain) - 1;
  }
  const IntegerResult number = parseInteger(p_, end_);
  if (number.status == NumberStatus::NotANumber) {
    source_.failAtLine(p_, "has " + quotedWord(p_, end_) + " where a vertex number is expected");
  }
  if (number.status == NumberStatus::TooLarge || number.value >= kNone) {
    source_.failAtLine(p_, "names vertex " + quotedWord(p_, end_) + ", which cannot exist");
  }
  if (number.value == 0) {
    source_.failAtLine(p_, "names vertex 0, but OBJ files count vertices from 1");
  }
  const std::int64_t known = static_cast<std::int64_t>(mesh_.positions.size());
  if (number.value < -known) {
    source_.failAtLine(p_, "counts " + std::to_string(-number.value) + " vertices back, but only " +
                               std::to_string(known) + " came before it");
  }
  p_ = number.end;
  if (number.value < 0) return known + number.value;
  if (number.value > known) early = std::max(early, number.value);
  return number.value - 1;
}

/// Reads the number of a texture coordinate or normal, if one is there. `early` keeps the largest
/// that has not come yet; those that never can are taken as kNone.
void ObjReader::readUnneeded(std::size_t count, std::int64_t& early) {
  const IntegerResult number = parseInteger(p_, end_);
  if (number.status == NumberStatus::NotANumber) return;
  p_ = number.end;
  const std::int64_t known = static_cast<std::int64_t>(count);
  const bool impossible = number.status == NumberStatus::TooLarge || number.value >= kNone ||
                          number.value == 0 || number.value < -known;
  if (impossible) {
    early = kNone;
  } else if (number.value > known) {
    early = std::max(early, number.value);
  }
}

void ObjReader::readOther() {
  const char* const begin = p_;
  while (p_ < end_ && !atBlank() && !atLineEnd()) ++p_;
  const std::string_view word(begin, static_cast<std::size_t>(p_ - begin));
  if (word == "l" || word == "p") {
    ++pointsAndLines_;
  } else if (!contains(kOtherKeywords, word)) {
    ++unknownLines_;
  }
  skipLine(!contains(kNameKeywords, word));
}

void ObjReader::checkEarlyFaces() {
  for (const Early& face : earlyFaces_) {
    if (face.vertex > static_cast<std::int64_t>(mesh_.positions.size())) {
      source_.failAtLine(face.position, "names vertex " + std::to_string(face.vertex) +
                                            " but there are " +
                                            std::to_string(mesh_.positions.size()));
    }
    if (face.texture > static_cast<std::int64_t>(textureCount_) ||
        face.normal > static_cast<std::int64_t>(normalCount_)) {
      ++missingReferences_;
    }
  }
}

void ObjReader::addRepairs() {
  if (mesh_.faceCount() == 0) {
    if (mesh_.positions.empty()) source_.fail("it is not an OBJ mesh: no line gives a vertex");
    source_.fail("it has " + counted(mesh_.positions.size(), "vertex", "vertices") +
                 " but no faces");
  }
  if (missingReferences_ > 0) {
    mesh_.repairs.push_back({"missing-texture-coordinates", missingReferences_,
                             counted(missingReferences_, "face names", "faces name") +
                                 " texture coordinates or normals that do not exist; they are not "
                                 "needed."});
  }
  if (pointsAndLines_ > 0) {
    mesh_.repairs.push_back(
        {"points-and-lines-ignored", pointsAndLines_,
         counted(pointsAndLines_, "point or line was", "points or lines were") + " left out."});
  }
  if (unknownLines_ > 0) {
    mesh_.repairs.push_back(
        {"unknown-lines-ignored", unknownLines_,
         counted(unknownLines_, "line is", "lines are") + " not in the OBJ format and left out."});
  }
}

}  // namespace

InputMesh readObj(const Source& source) { return ObjReader(source).read(); }

}  // namespace chartflood
