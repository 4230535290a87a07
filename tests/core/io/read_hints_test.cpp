// Painted edges as text: core/io/read_hints.

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/io/read/read_hints.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_meshes.h"

namespace chartflood {
namespace {

EdgeHints hintsIn(const std::string& text, const Mesh& mesh) {
  const TemporaryFolder folder;
  return readHints(folder.write("hints.txt", text), mesh);
}

std::string refusal(const std::string& text) {
  try {
    hintsIn(text, *test::quadCube());
  } catch (const ReadError& error) {
    return error.cause();
  }
  return "";
}

TEST(ReadHints, OfEitherKindInAnyOrder) {
  const auto mesh = test::grid(2, true);
  const EdgeHints hints = hintsIn("# seams\nnever 1 0\n\ncut 1 2  # here\nnever 2 1\n", *mesh);
  EXPECT_EQ(hints, (EdgeHints{{0, 1, HintKind::Never}, {1, 2, HintKind::Never}}));
  EXPECT_EQ(hintsIn(hintsText(hints), *mesh), hints);
  EXPECT_EQ(hintsIn("\xef\xbb\xbf" + hintsText(hints), *mesh), hints) << "a mark of UTF-8";
  EXPECT_EQ(hintsIn("# none\n", *mesh), EdgeHints{});
}

TEST(ReadHints, KnowsJoinedVerticesByEitherNumber) {
  // Two squares side by side, each with vertices of its own.
  const auto mesh = test::meshOf(
      {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}},
      {{0, 1, 2, 3}, {4, 5, 6, 7}});
  EXPECT_EQ(hintsIn("cut 1 2\n", *mesh), (EdgeHints{{1, 2, HintKind::Cut}}));
  EXPECT_EQ(hintsIn("cut 7 4\n", *mesh), (EdgeHints{{1, 2, HintKind::Cut}}));
  EXPECT_EQ(hintsIn("never 4 5\n", *mesh), (EdgeHints{{1, 5, HintKind::Never}}));
}

TEST(ReadHints, RefusesWhatIsNone) {
  EXPECT_THAT(refusal("cut 0 99"), testing::HasSubstr("line 1 names vertices 0 and 99"));
  EXPECT_THAT(refusal("cut 0 0"), testing::HasSubstr("no edge"));
  EXPECT_THAT(refusal("\nfold 0 1"), testing::HasSubstr("line 2 has \"fold\""));
  EXPECT_THAT(refusal("cut 0"), testing::HasSubstr("the number of a vertex"));
  EXPECT_THAT(refusal("cut 0 x"), testing::HasSubstr("the number of a vertex"));
  EXPECT_THAT(refusal("cut -1 0"), testing::HasSubstr("no edge"));
}

}  // namespace
}  // namespace chartflood
