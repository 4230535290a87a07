#include "core/io/text/parse_number.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>

#include <gtest/gtest.h>

namespace chartflood::test {
namespace {

RealResult parse(const std::string& text) {
  return parseReal(text.data(), text.data() + text.size());
}

TEST(ParseReal, EqualsTheLibraryBitForBit) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 200000; ++i) {
    std::array<char, 64> text;
    const double magnitude =
        std::ldexp(static_cast<double>(random()), static_cast<int>(random() % 140) - 130);
    const char* const formats[] = {"%.6f", "%.9g", "%.17g", "%.3e", "%g", "%+.12f", "%.0f"};
    std::snprintf(text.data(), text.size(), formats[i % 7],
                  random() % 2 == 0 ? magnitude : -magnitude);
    const std::string word = text.data();
    const RealResult result = parse(word);
    ASSERT_EQ(result.status, NumberStatus::Ok) << word;
    EXPECT_EQ(result.value, std::strtod(word.c_str(), nullptr)) << word;
  }
}

TEST(ParseDigits, StopsAtWhateverIsNoDigit) {
  for (int other = 0; other < 256; ++other) {
    if (other >= '0' && other <= '9') continue;
    for (std::size_t count = 0; count <= 19; ++count) {
      const std::string digits = std::string("9081726354506172839").substr(0, count);
      const std::string text = digits + static_cast<char>(other) + "12345678901234567890";
      std::uint64_t value = 7;
      const char* const end = parseDigits(text.data(), text.data() + text.size(), value);
      ASSERT_EQ(static_cast<std::size_t>(end - text.data()), count) << other;
      // Wraps around as plain arithmetic does.
      std::uint64_t expected = 7;
      for (const char digit : digits) expected = 10 * expected + static_cast<unsigned>(digit - '0');
      ASSERT_EQ(value, expected) << other;
      // The same at the very end of the text.
      value = 7;
      EXPECT_EQ(parseDigits(text.data(), text.data() + count, value), text.data() + count);
      ASSERT_EQ(value, expected);
    }
  }
}

TEST(ParseReal, StopsBehindTheNumber) {
  const std::string text = "12.5e1/7";
  const RealResult result = parse(text);
  EXPECT_EQ(result.value, 125);
  EXPECT_EQ(result.end - text.data(), 6);
}

TEST(ParseReal, TakesSignsPointsAndZeros) {
  EXPECT_EQ(parse("+1").value, 1);
  EXPECT_EQ(parse(".5").value, 0.5);
  EXPECT_EQ(parse("5.").value, 5);
  EXPECT_EQ(parse("1E+2").value, 100);
  EXPECT_EQ(parse("+1e+2").value, 100);
  EXPECT_TRUE(std::signbit(parse("-0").value));
  EXPECT_EQ(parse("0000000000000000000000001.5").value, 1.5);
  EXPECT_TRUE(std::isnan(parse("nan").value));
  EXPECT_TRUE(std::isinf(parse("-inf").value));
}

TEST(ParseReal, TellsTooLargeFromTooSmall) {
  EXPECT_EQ(parse("1e999").status, NumberStatus::TooLarge);
  EXPECT_EQ(parse("-1e999").status, NumberStatus::TooLarge);
  EXPECT_EQ(parse("1" + std::string(400, '0')).status, NumberStatus::TooLarge);
  EXPECT_EQ(parse("1e-999").value, 0);
  EXPECT_EQ(parse("0." + std::string(400, '0') + "1").value, 0);
  EXPECT_EQ(parse("0." + std::string(400, '0') + "1e401").value, 1);
  EXPECT_EQ(parse("1e99999999999999999999").status, NumberStatus::TooLarge);
  EXPECT_EQ(parse("1e-99999999999999999999").value, 0);
  EXPECT_EQ(parse("4.9406564584124654e-324").value, std::numeric_limits<double>::denorm_min());
  EXPECT_EQ(parse("1.7976931348623157e308").value, std::numeric_limits<double>::max());
}

TEST(ParseReal, RefusesWhatIsNoNumber) {
  for (const char* word : {"", "-", "+", ".", "e5", "x", "+-1", "--1"}) {
    EXPECT_EQ(parse(word).status, NumberStatus::NotANumber) << word;
  }
}

TEST(ParseInteger, TakesSignsAndRefusesTheRest) {
  const auto integer = [](const std::string& text) {
    return parseInteger(text.data(), text.data() + text.size());
  };
  EXPECT_EQ(integer("-12/3").value, -12);
  EXPECT_EQ(integer("+7").value, 7);
  EXPECT_EQ(integer("99999999999999999999").status, NumberStatus::TooLarge);
  EXPECT_EQ(integer("-").status, NumberStatus::NotANumber);
  EXPECT_EQ(integer("a").status, NumberStatus::NotANumber);
}

}  // namespace
}  // namespace chartflood::test
