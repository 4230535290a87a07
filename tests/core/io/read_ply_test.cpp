#include <bit>

#include <gtest/gtest.h>

#include "io_support.h"

namespace chartflood::test {
namespace {

using Faces = std::vector<std::vector<Index>>;

/// A square of two triangles and a quad over it, in any encoding and types.
struct Encoding {
  const char* format;
  bool binary, bigEndian;
};
constexpr Encoding kAscii = {"ascii", false, false};
constexpr Encoding kLittle = {"binary_little_endian", true, false};
constexpr Encoding kBig = {"binary_big_endian", true, true};

/// Writes values one after another as a PLY file wants them.
class Rows {
 public:
  explicit Rows(Encoding encoding) : encoding_(encoding) {}
  template <class T>
  Rows& value(T x) {
    if (encoding_.binary) {
      bytes_ += bytesOf(x, encoding_.bigEndian);
    } else {
      bytes_ += std::to_string(x) + " ";
    }
    return *this;
  }
  Rows& end() {
    if (!encoding_.binary) bytes_ += "\n";
    return *this;
  }
  const std::string& bytes() const { return bytes_; }

 private:
  Encoding encoding_;
  std::string bytes_;
};

std::string header(Encoding encoding, const std::string& elements) {
  return "ply\nformat " + std::string(encoding.format) + " 1.0\ncomment made by a test\n" +
         elements + "end_header\n";
}

template <class Coordinate, class Count, class Entry>
std::string squareFile(Encoding encoding, const std::string& coordinate, const std::string& list) {
  Rows rows(encoding);
  const Coordinate corners[4][3] = {{0, 0, 1}, {2, 0, 1}, {2, 2, 1}, {0, 2, 1}};
  for (const auto& c : corners) {
    rows.value(std::uint8_t{7}).value(c[0]).value(c[1]).value(c[2]).value(1.5f).end();
  }
  const std::vector<std::vector<int>> faces = {{0, 1, 2}, {0, 2, 3}, {3, 2, 1, 0}, {1, 2, 3}};
  for (const auto& face : faces) {
    rows.value(std::int16_t{-3}).value(static_cast<Count>(face.size()));
    for (const int v : face) rows.value(static_cast<Entry>(v));
    rows.value(2.5).end();
  }
  return header(encoding, "element vertex 4\nproperty uchar red\nproperty " + coordinate +
                              " x\nproperty " + coordinate + " y\nproperty " + coordinate +
                              " z\nproperty float quality\nelement face 4\nproperty short flags\n" +
                              "property list " + list +
                              " vertex_indices\nproperty double weight\n") +
         rows.bytes();
}

const Faces kSquareFaces = {{0, 1, 2}, {0, 2, 3}, {3, 2, 1, 0}, {1, 2, 3}};

class ReadPly : public testing::TestWithParam<Encoding> {};

TEST_P(ReadPly, TakesAnyTypesAmongOtherProperties) {
  const std::string files[] = {
      squareFile<float, std::uint8_t, std::int32_t>(GetParam(), "float", "uchar int"),
      squareFile<double, std::int32_t, std::uint32_t>(GetParam(), "float64", "int uint32"),
      squareFile<std::int16_t, std::uint16_t, std::uint16_t>(GetParam(), "short", "ushort uint16"),
      squareFile<std::int32_t, std::int8_t, std::int8_t>(GetParam(), "int", "char int8"),
      squareFile<std::uint8_t, std::uint32_t, std::uint8_t>(GetParam(), "uint8", "uint uchar")};
  for (const std::string& file : files) {
    const auto mesh = readBytes("a.ply", file);
    ASSERT_EQ(mesh->positions.size(), 4u);
    EXPECT_EQ(mesh->positions[2], glm::dvec3(2, 2, 1));
    EXPECT_EQ(mesh->positions[3], glm::dvec3(0, 2, 1));
    EXPECT_EQ(facesOf(*mesh), kSquareFaces);
    EXPECT_TRUE(mesh->repairs.empty());
  }
}

TEST_P(ReadPly, PassesOverOtherElementsAndLists) {
  Rows rows(GetParam());
  rows.value(std::uint8_t{2}).value(1.f).value(2.f).end();
  rows.value(0.f).value(0.f).value(0.f).value(std::uint8_t{1}).value(std::int32_t{4}).end();
  rows.value(1.f).value(0.f).value(0.f).value(std::uint8_t{0}).end();
  rows.value(0.f).value(1.f).value(0.f).value(std::uint8_t{2}).value(std::int32_t{4});
  rows.value(std::int32_t{5}).end();
  rows.value(std::uint8_t{2}).value(.5f).value(.5f);
  rows.value(std::uint8_t{3}).value(std::int32_t{2}).value(std::int32_t{1}).value(std::int32_t{0});
  const auto mesh =
      readBytes("a.ply", header(GetParam(), "element material 1\nproperty list uchar float values\n"
                                            "element vertex 3\nproperty float x\nproperty float y\n"
                                            "property float z\nproperty list uchar int tags\n"
                                            "element face 1\nproperty list uchar float texcoord\n"
                                            "property list uchar int vertex_index\n") +
                             rows.end().bytes());
  EXPECT_EQ(mesh->positions[1], glm::dvec3(1, 0, 0));
  EXPECT_EQ(facesOf(*mesh), (Faces{{2, 1, 0}}));
}

TEST_P(ReadPly, ExpandsStrips) {
  Rows rows(GetParam());
  for (int i = 0; i < 6; ++i) {
    rows.value(static_cast<float>(i / 2)).value(static_cast<float>(i % 2)).value(0.f).end();
  }
  rows.value(std::int32_t{9});
  for (const std::int32_t v : {0, 1, 2, 3, -1, 2, 3, 3, 4}) rows.value(v);
  const auto mesh =
      readBytes("a.ply", header(GetParam(), "element vertex 6\nproperty float x\nproperty float y\n"
                                            "property float z\nelement tristrips 1\n"
                                            "property list int int vertex_indices\n") +
                             rows.end().bytes());
  EXPECT_EQ(facesOf(*mesh), (Faces{{0, 1, 2}, {2, 1, 3}}));
}

TEST_P(ReadPly, RefusesVerticesThatDoNotExist) {
  for (const std::int32_t bad : {3, -1, 1 << 30}) {
    Rows rows(GetParam());
    for (int i = 0; i < 9; ++i) rows.value(static_cast<float>(i)).end();
    rows.value(std::uint8_t{3}).value(std::int32_t{0}).value(std::int32_t{1}).value(bad).end();
    const std::string cause = refusalOf(
        "a.ply", header(GetParam(), "element vertex 3\nproperty float x\nproperty float y\n"
                                    "property float z\nelement face 1\n"
                                    "property list uchar int vertex_indices\n") +
                     rows.bytes());
    EXPECT_NE(
        cause.find("names vertex " + std::to_string(bad) + " but there are 3 (counted from 0)"),
        std::string::npos)
        << cause;
  }
}

INSTANTIATE_TEST_SUITE_P(Encodings, ReadPly, testing::Values(kAscii, kLittle, kBig),
                         [](const auto& row) {
                           return std::string(
                               row.param.binary ? row.param.bigEndian ? "Big" : "Little" : "Ascii");
                         });

const char* const kVertices =
    "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
const char* const kFaces = "element face 1\nproperty list uchar int vertex_indices\n";

TEST(ReadPlyText, RowsMayGoOnInTheNextLineOrHoldMoreThanTheHeaderSays) {
  const auto mesh = readBytes("a.ply", header(kAscii, std::string(kVertices) + kFaces) +
                                           "0 0\n0\n1 0 0 255 255\n0 1 0\n3 0 1 2 6 0 0 1 0 0 1\n");
  EXPECT_EQ(facesOf(*mesh), (Faces{{0, 1, 2}}));
  EXPECT_EQ(countOf(mesh->repairs, "surplus-values-ignored"), 2u);
}

TEST(ReadPlyHeader, LinesMayEndInAnyWay) {
  Rows rows(kLittle);
  // The first byte of the data looks like a line end.
  rows.value(std::bit_cast<float>(0x3f80000au)).value(0.f).value(0.f);
  for (int i = 0; i < 6; ++i) rows.value(static_cast<float>(i));
  rows.value(std::uint8_t{3}).value(0).value(1).value(2);
  const std::string text = header(kLittle, std::string(kVertices) + kFaces);
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    std::string file;
    for (const char c : text) file += c == '\n' ? end : std::string(1, c);
    EXPECT_EQ(facesOf(*readBytes("a.ply", file + rows.bytes())), (Faces{{0, 1, 2}}));
  }
}

TEST(ReadPlyHeader, RefusesWhatItCannotMean) {
  const auto refusal = [](const std::string& elements) {
    return refusalOf("a.ply", header(kLittle, elements) + std::string(100, '\0'));
  };
  EXPECT_EQ(refusalOf("a.ply", "plx\n"), "it is not a PLY mesh: it does not begin with ply");
  EXPECT_EQ(refusalOf("a.ply", "ply\nformat ascii 1.0\n"), "its header has no end_header line");
  EXPECT_EQ(refusalOf("a.ply", "ply\nend_header\n"), "its header has no format line");
  EXPECT_EQ(refusal("element vertex 3\nproperty float x\nproperty float y\n" + std::string(kFaces)),
            "its vertices have no number named z");
  EXPECT_EQ(refusal(std::string(kVertices) +
                    "element face 1\nproperty list uchar float vertex_indices\n"),
            "its faces have no list of whole numbers named vertex_indices");
  EXPECT_EQ(refusal(kVertices), "it has 3 vertices but no faces");
  EXPECT_EQ(refusal(kFaces), "its header has no element named vertex");
  EXPECT_EQ(refusal("element vertex\n"), "line 4 gives no name and count for an element");
  EXPECT_EQ(refusal("element vertex -3\n"), "line 4 gives no usable count for an element");
  EXPECT_EQ(refusal("property float x\n"), "line 4 has a property before any element");
  EXPECT_EQ(refusal("element vertex 3\nproperty half x\n"), "line 5 has the unknown type \"half\"");
  EXPECT_EQ(refusal("element face 1\nproperty list float int vertex_indices\n"),
            "line 5 counts a list in numbers with fractions");
}

TEST(ReadPlyHeader, CountsThatTheFileCannotHoldAskForNoMemory) {
  for (const Encoding& encoding : {kAscii, kLittle}) {
    const std::string file =
        header(encoding, "element vertex 4000000000\nproperty float x\nproperty float y\n"
                         "property float z\n" +
                             std::string(kFaces)) +
        "0 0 0\n";
    EXPECT_EQ(refusalOf("a.ply", file),
              "its header counts 4000000000 rows of \"vertex\", more than "
              "the file holds");
  }
}

TEST(ReadPlyBinary, ListsLongerThanTheFileAreRefused) {
  Rows rows(kLittle);
  for (int i = 0; i < 9; ++i) rows.value(0.f);
  rows.value(std::uint32_t{0xffffffff}).value(0).value(1).value(2);
  const std::string head = header(
      kLittle, std::string(kVertices) + "element face 1\nproperty list uint int vertex_indices\n");
  EXPECT_EQ(refusalOf("a.ply", head + rows.bytes()),
            "byte " + std::to_string(head.size() + 36) + ": the file ends inside this row");
}

}  // namespace
}  // namespace chartflood::test
