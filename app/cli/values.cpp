#include "app/cli/values.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "core/base/error.h"
#include "core/base/spelling.h"
#include "core/base/text.h"
#include "core/io/text/parse_number.h"
#include "core/session/settings/parameters.h"

namespace chartflood {

namespace {

[[noreturn]] void refuse(std::string_view option, std::string_view text, std::string_view reason,
                         const std::string& allowed) {
  throw UsageError("--" + std::string(option) + "=" + std::string(text) + " " +
                   std::string(reason) + ": give " + allowed + ".");
}

template <typename T>
std::optional<T> parse(std::string_view text) {
  T value{};
  const std::string_view digits = withoutPlus(text);
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  const bool whole = error == std::errc() && end == digits.data() + digits.size();
  return whole ? std::optional(value) : std::nullopt;
}

std::vector<std::string_view> split(std::string_view text) {
  std::vector<std::string_view> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    parts.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

}  // namespace

std::size_t readCount(std::string_view option, std::string_view text, std::size_t least,
                      std::size_t most) {
  const auto value = parse<std::size_t>(text);
  const std::string allowed =
      "a whole number from " + std::to_string(least) + " to " + std::to_string(most);
  if (!value) refuse(option, text, "is not such a number", allowed);
  if (*value < least || *value > most) refuse(option, text, "is out of range", allowed);
  return *value;
}

double readNumber(std::string_view option, std::string_view text) {
  const auto value = parse<double>(text);
  if (!value || !std::isfinite(*value)) refuse(option, text, "is not a number", "a finite number");
  return *value;
}

bool readSwitch(std::string_view option, std::string_view text) {
  if (const std::optional<bool> on = switchValue(text)) return *on;
  refuse(option, text, "is neither on nor off", "on or off");
}

std::string readChoice(std::string_view option, std::string_view text,
                       std::span<const std::string> choices) {
  std::string allowed;
  for (const std::string& choice : choices) {
    if (choice == text) return choice;
    allowed += (allowed.empty() ? "" : ", ") + choice;
  }
  const std::string near = nearestSpelling(text, choices);
  refuse(option, text, near.empty() ? "is not known" : "is not known (nearest: " + near + ")",
         choices.size() == 1 ? allowed : "one of " + allowed);
}

std::pair<int, int> readSize(std::string_view option, std::string_view text, int most) {
  const auto parts = split(text);
  const std::string allowed = "W,H, whole numbers from 1 to " + std::to_string(most);
  if (parts.size() != 2) refuse(option, text, "is no size", allowed);
  const auto width = parse<int>(parts[0]), height = parse<int>(parts[1]);
  if (!width || !height) refuse(option, text, "is no size", allowed);
  if (std::min(*width, *height) < 1 || std::max(*width, *height) > most) {
    refuse(option, text, "is out of range", allowed);
  }
  return {*width, *height};
}

std::vector<Index> readFaces(std::string_view option, std::string_view text) {
  const std::string allowed = "face numbers with commas between, such as 0,250,731";
  std::vector<Index> faces;
  for (const std::string_view part : split(text)) {
    const auto face = parse<Index>(part);
    if (!face || *face == kNone) refuse(option, text, "is not a list of faces", allowed);
    faces.push_back(*face);
  }
  std::vector<Index> sorted = faces;
  std::sort(sorted.begin(), sorted.end());
  if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) {
    refuse(option, text, "names a face twice", "each face once");
  }
  return faces;
}

std::vector<double> readNumbers(std::string_view option, std::string_view text, std::size_t count,
                                std::string_view form) {
  std::vector<double> numbers;
  for (const std::string_view part : split(text)) {
    const auto number = parse<double>(part);
    if (!number || !std::isfinite(*number)) break;
    numbers.push_back(*number);
  }
  if (numbers.size() != count || split(text).size() != count) {
    refuse(option, text, "is not of the right form", std::string(form));
  }
  return numbers;
}

glm::dvec3 readVector(std::string_view option, std::string_view text, bool direction) {
  const std::vector<double> n = readNumbers(option, text, 3, "three numbers, X,Y,Z");
  if (direction && n[0] == 0 && n[1] == 0 && n[2] == 0) {
    refuse(option, text, "is no direction", "X,Y,Z that are not all 0");
  }
  return {n[0], n[1], n[2]};
}

std::string fileEnding(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  for (char& c : ending) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  return ending;
}

}  // namespace chartflood
