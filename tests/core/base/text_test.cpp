// Words that mean the same wherever they are read.

#include "core/base/text.h"

#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace chartflood {
namespace {

TEST(SwitchWords, AreThoseOfOnAndOff) {
  for (const char* word : {"on", "true", "yes", "1"}) EXPECT_EQ(switchValue(word), true) << word;
  for (const char* word : {"off", "false", "no", "0"}) EXPECT_EQ(switchValue(word), false) << word;
  for (const char* word : {"", "On", "2", "o", "on "}) EXPECT_FALSE(switchValue(word)) << word;
  for (const bool on : {false, true}) EXPECT_EQ(switchValue(switchWord(on)), on);
}

TEST(LowerCase, LeavesWhatHasNoCase) {
  EXPECT_EQ(lowerCase(".ObJ"), ".obj");
  EXPECT_EQ(lowerCase("\xc3\x84 7"), "\xc3\x84 7");
  EXPECT_EQ(lowerCase(""), "");
}

TEST(Listed, PutsTheWordBeforeTheLast) {
  const std::vector<std::string> words{"a", "b", "c"};
  EXPECT_EQ(listed(words, "or"), "a, b or c");
  EXPECT_EQ(listed(std::span(words).first(2), "and"), "a and b");
  EXPECT_EQ(listed(std::span(words).first(1), "and"), "a");
  EXPECT_EQ(listed({}, "and"), "");
}

}  // namespace
}  // namespace chartflood
