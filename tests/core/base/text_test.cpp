// Words that mean the same wherever they are read.

#include "core/base/text.h"

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

}  // namespace
}  // namespace chartflood
