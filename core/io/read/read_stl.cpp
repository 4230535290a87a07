#include "core/io/read/read_stl.h"

#include <cstdint>
#include <cstring>
#include <utility>

#include "core/base/counted.h"
#include "core/base/text.h"
#include "core/io/read/face_builder.h"
#include "core/io/read/weld.h"
#include "core/io/text/text_rows.h"

namespace chartflood {

namespace {

constexpr std::size_t kHeaderSize = 84;  ///< 80 bytes of text and the count
constexpr std::size_t kFacetSize = 50;   ///< normal, three corners, two bytes of attributes
constexpr std::size_t kFacetsPerReport = 1 << 14;

std::size_t facetCount(std::string_view bytes) {
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + 80, sizeof count);
  return count;
}

bool equalsIgnoringCase(std::string_view word, std::string_view lower) {
  if (word.size() != lower.size()) return false;
  for (std::size_t i = 0; i < word.size(); ++i) {
    if (lowerCase(word[i]) != lower[i]) return false;
  }
  return true;
}

/// Text begins with "solid", but so do the headers of some binary files: in those the count fits
/// the length, or bytes follow that are no text.
bool isText(const Source& source) {
  const std::string_view bytes = source.bytes;
  const auto begin = static_cast<std::size_t>(source.text() - source.begin());
  const std::size_t start = bytes.find_first_not_of(" \t\r\n", begin);
  if (start == std::string_view::npos) return false;
  if (!equalsIgnoringCase(bytes.substr(start, 5), "solid")) return false;
  return !looksLikeBinaryStl(bytes) && bytes.substr(0, 1024).find('\0') == std::string_view::npos;
}

InputMesh readBinary(const Source& source) {
  if (source.bytes.size() < kHeaderSize) {
    source.fail("it is too short for an STL mesh (" +
                counted(source.bytes.size(), "byte", "bytes") + ")");
  }
  InputMesh mesh;
  const std::size_t said = facetCount(source.bytes);
  const std::size_t room = source.bytes.size() - kHeaderSize;
  std::size_t count = said;
  if (said > room / kFacetSize) {
    source.fail("its header counts " + std::to_string(said) + " triangles but it has room for " +
                std::to_string(room / kFacetSize));
  }
  if (said < room / kFacetSize && room % kFacetSize == 0) {
    count = room / kFacetSize;
    mesh.repairs.push_back({"facet-count-corrected", 1,
                            "The header counts " + std::to_string(said) + " triangles, but " +
                                std::to_string(count) + " follow; all were read."});
  } else if (said * kFacetSize != room) {
    mesh.repairs.push_back({"bytes-after-end-ignored", room - said * kFacetSize,
                            counted(room - said * kFacetSize, "byte follows", "bytes follow") +
                                " behind the last triangle; they were left out."});
  }
  if (count == 0) source.fail("it has no faces");
  PositionTable table(count / 2);
  mesh.corners.reserve(3 * count);
  const char* p = source.begin() + kHeaderSize;
  for (std::size_t f = 0; f < count; ++f, p += kFacetSize) {
    if (f % kFacetsPerReport == 0 && source.report(p)) return {};
    float corners[9];
    std::memcpy(corners, p + 12, sizeof corners);
    for (std::size_t i = 0; i < 9; i += 3) {
      mesh.corners.push_back(table.indexOf(glm::dvec3(corners[i], corners[i + 1], corners[i + 2])));
    }
  }
  mesh.positions = std::move(table.positions());
  return mesh;
}

/// solid NAME / facet normal .. / outer loop / vertex x y z (three; some programs write polygons) /
/// endloop / endfacet / endsolid.
class TextStl {
 public:
  explicit TextStl(const Source& source)
      : source_(source), rows_(source, source.text(), 0), faces_(mesh_) {}

  InputMesh read();

 private:
  bool readSolid();
  void readFacet();
  void expect(std::string_view keyword);
  [[noreturn]] void failExpected(std::string_view word, const char* what) const;

  const Source& source_;
  TextRows rows_;
  PositionTable table_;
  InputMesh mesh_;
  FaceBuilder faces_;
  std::size_t openSolids_ = 0;
};

void TextStl::failExpected(std::string_view word, const char* what) const {
  if (word.empty()) {
    source_.failAtLine(source_.end(), std::string("ends the file where ") + what + " is due");
  }
  source_.failAtLine(word.data(), "has " + quotedWord(word.data(), word.data() + word.size()) +
                                      " where " + what + " is due");
}

void TextStl::expect(std::string_view keyword) {
  const std::string_view word = rows_.word();
  if (!equalsIgnoringCase(word, keyword)) {
    failExpected(word, ("\"" + std::string(keyword) + "\"").c_str());
  }
}

void TextStl::readFacet() {
  rows_.skipLine();  // the normal
  expect("outer");
  expect("loop");
  for (std::size_t corners = 0;; ++corners) {
    const std::string_view word = rows_.word();
    if (corners >= 3 && equalsIgnoringCase(word, "endloop")) break;
    if (!equalsIgnoringCase(word, "vertex")) {
      failExpected(word, corners < 3 ? "\"vertex\"" : "\"vertex\" or \"endloop\"");
    }
    glm::dvec3 position;
    position.x = rows_.real("a coordinate");
    position.y = rows_.real("a coordinate");
    position.z = rows_.real("a coordinate");
    faces_.addCorner(table_.indexOf(position));
  }
  faces_.endFace();
  expect("endfacet");
}

/// Reads facets up to endsolid or the end of the file. \returns false when cancelled.
bool TextStl::readSolid() {
  rows_.skipLine();  // the name
  for (std::size_t facets = 0;; ++facets) {
    if (facets % kFacetsPerReport == 0 && source_.report(rows_.position())) return false;
    const std::string_view word = rows_.word();
    if (equalsIgnoringCase(word, "facet")) {
      readFacet();
    } else if (equalsIgnoringCase(word, "endsolid")) {
      rows_.skipLine();
      return true;
    } else if (word.empty()) {
      ++openSolids_;
      return true;
    } else {
      failExpected(word, "\"facet\" or \"endsolid\"");
    }
  }
}

InputMesh TextStl::read() {
  while (rows_.next()) {
    const std::string_view word = rows_.word();
    if (!equalsIgnoringCase(word, "solid")) failExpected(word, "\"solid\"");
    if (!readSolid()) return {};
  }
  if (mesh_.corners.empty()) source_.fail("it has no faces");
  if (openSolids_ > 0) {
    mesh_.repairs.push_back({"missing-end", openSolids_,
                             "The file ends without endsolid: it may have been cut short."});
  }
  mesh_.positions = std::move(table_.positions());
  return std::move(mesh_);
}

}  // namespace

InputMesh readStl(const Source& source) {
  return isText(source) ? TextStl(source).read() : readBinary(source);
}

bool looksLikeBinaryStl(std::string_view bytes) {
  return bytes.size() >= kHeaderSize &&
         bytes.size() == kHeaderSize + kFacetSize * facetCount(bytes);
}

}  // namespace chartflood
