#include "app/host/script/action.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/io/text/parse_number.h"

namespace chartflood {

namespace {

[[noreturn]] void refuse(std::string_view action, const std::string& sentence) {
  throw UsageError("Action '" + std::string(action) + "': " + sentence);
}

template <typename Number>
bool parseAs(const std::string& text, Number& value) {
  const std::string_view digits = withoutPlus(text);
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  return error == std::errc() && end == digits.data() + digits.size() &&
         std::isfinite(static_cast<double>(value));
}

template <typename Number>
bool parsesAs(const std::string& text) {
  Number value{};
  return parseAs(text, value);
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

bool holdsWord(const std::vector<std::string>& words, const std::string& word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

void checkType(std::string_view action, const ArgumentInfo& info, const std::string& value) {
  const std::string where = "argument '" + info.name + "' is '" + value + "'";
  switch (info.type) {
  case ArgumentType::Text:
    return;
  case ArgumentType::Integer:
    if (!parsesAs<long>(value)) refuse(action, where + ", but must be a whole number.");
    return;
  case ArgumentType::Number:
    if (!parsesAs<double>(value)) refuse(action, where + ", but must be a number.");
    return;
  case ArgumentType::Switch:
    if (!switchValue(value)) refuse(action, where + ", but must be on or off.");
    return;
  case ArgumentType::Choice:
    if (!holdsWord(info.choices, value) && !holdsWord(info.former, value)) {
      refuse(action, where + ", but must be one of " + joined(info.choices) + ".");
    }
    return;
  }
}

}  // namespace

Arguments::Arguments(std::string_view action, const std::vector<ArgumentInfo>& table,
                     const ArgumentMap& given) {
  for (const auto& [key, value] : given) {
    std::string name = key;
    std::size_t position = 0;
    const auto [end, error] = std::from_chars(key.data(), key.data() + key.size(), position);
    if (error == std::errc() && end == key.data() + key.size()) {
      if (position >= table.size()) refuse(action, "there is no argument for '" + value + "'.");
      name = table[position].name;
    }
    const auto info = std::find_if(table.begin(), table.end(),
                                   [&](const ArgumentInfo& row) { return row.name == name; });
    if (info == table.end()) refuse(action, "there is no argument '" + name + "'.");
    checkType(action, *info, value);
    if (!values_.emplace(name, value).second) refuse(action, "'" + name + "' is given twice.");
  }
  for (const ArgumentInfo& row : table) {
    if (row.required && !has(row.name))
      refuse(action, "the argument '" + row.name + "' is missing.");
  }
}

std::string Arguments::text(std::string_view name) const {
  const auto found = values_.find(name);
  return found == values_.end() ? std::string() : found->second;
}

double Arguments::number(std::string_view name, double fallback) const {
  double result = fallback;
  return parseAs(text(name), result) ? result : fallback;
}

long Arguments::integer(std::string_view name, long fallback) const {
  long result = fallback;
  return parseAs(text(name), result) ? result : fallback;
}

bool Arguments::flag(std::string_view name, bool fallback) const {
  return has(name) ? switchValue(text(name)).value_or(false) : fallback;
}

}  // namespace chartflood
