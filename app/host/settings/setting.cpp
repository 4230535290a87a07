// Values of settings as text, and what is wrong with them.

#include "app/host/settings/setting.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "core/base/spelling.h"
#include "core/base/text.h"
#include "core/io/text/parse_number.h"

namespace chartflood {

namespace {

std::string settingNumberText(double value) {
  std::array<char, 32> text;
  const bool whole = value == std::floor(value) && std::abs(value) < 1e15;
  const auto end =
      whole ? std::to_chars(text.data(), text.data() + text.size(), static_cast<long long>(value))
            : std::to_chars(text.data(), text.data() + text.size(), value);
  return {text.data(), end.ptr};
}

bool isNumber(const SettingDomain& domain) {
  return domain.type == SettingType::Whole || domain.type == SettingType::Number;
}

/// The choice of this name, or former name.
const SettingChoice* findChoice(const SettingDomain& domain, std::string_view id) {
  for (const SettingChoice& each : domain.choices) {
    if (id == each.id || (!each.former.empty() && id == each.former)) return &each;
  }
  return nullptr;
}

std::string joined(const std::vector<std::string>& words, const char* between) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
  return text;
}

std::optional<SettingValue> numberFromText(const SettingDomain& domain, std::string_view text,
                                           std::string& reason) {
  if (std::find(domain.words.begin(), domain.words.end(), text) != domain.words.end()) {
    return std::string(text);
  }
  const std::string_view digits = withoutPlus(text);
  const char* const last = digits.data() + digits.size();
  double value = 0;
  const bool whole = domain.type == SettingType::Whole;
  const auto kind = whole ? std::chars_format::fixed : std::chars_format::general;
  const auto [end, error] = std::from_chars(digits.data(), last, value, kind);
  if (error != std::errc() || end != last || (whole && value != std::floor(value))) {
    reason = whole ? "is not a whole number" : "is not a number";
    return std::nullopt;
  }
  return value;
}

}  // namespace

std::string valueText(const SettingValue& value) {
  if (const bool* on = std::get_if<bool>(&value)) return switchWord(*on);
  if (const double* number = std::get_if<double>(&value)) return settingNumberText(*number);
  if (const std::string* text = std::get_if<std::string>(&value)) return *text;
  std::vector<std::string> numbers;
  for (const double each : std::get<std::vector<double>>(value)) {
    numbers.push_back(settingNumberText(each));
  }
  return joined(numbers, ",");
}

std::optional<SettingValue> valueFromText(const SettingDomain& domain, std::string_view text,
                                          std::string& reason) {
  if (isNumber(domain)) return numberFromText(domain, text, reason);
  if (domain.type == SettingType::Choice) {
    const SettingChoice* choice = findChoice(domain, text);
    return choice == nullptr ? std::string(text) : choice->id;
  }
  if (domain.type != SettingType::Switch) return std::string(text);
  if (const std::optional<bool> on = switchValue(text)) return *on;
  reason = "is neither on nor off";
  return std::nullopt;
}

std::string valueProblem(const SettingDomain& domain, const SettingValue& value) {
  constexpr const char* kWrongKind = "is of the wrong kind";
  if (domain.type == SettingType::Switch) {
    return std::holds_alternative<bool>(value) ? "" : kWrongKind;
  }
  if (isNumber(domain)) {
    const double* number = std::get_if<double>(&value);
    if (number == nullptr) return kWrongKind;
    if (!std::isfinite(*number)) return "is not a finite number";
    if (!(*number >= domain.least && *number <= domain.most)) return "is out of range";
    const bool fits = domain.type == SettingType::Number || *number == std::floor(*number);
    return fits ? "" : "is not a whole number";
  }
  const std::string* text = std::get_if<std::string>(&value);
  if (text == nullptr) return kWrongKind;
  if (domain.type == SettingType::Text || findChoice(domain, *text) != nullptr) return "";
  const std::string near = nearestSpelling(*text, choiceIds(domain));
  return near.empty() ? "is not known" : "is not known (nearest: " + near + ")";
}

std::string allowedText(const SettingDomain& domain) {
  if (!domain.allowed.empty()) return domain.allowed;
  if (domain.type == SettingType::Switch) return "on or off";
  if (domain.type == SettingType::Text) return "another text";
  if (!isNumber(domain)) return "one of " + joined(choiceIds(domain), ", ");
  std::string text = domain.words.empty() ? "" : listed(domain.words, "or") + ", or ";
  text += domain.type == SettingType::Whole ? "a whole number from " : "a number from ";
  return text + settingNumberText(domain.least) + " to " + settingNumberText(domain.most);
}

std::string formText(const SettingDomain& domain) {
  if (!domain.form.empty() || domain.type == SettingType::Switch) return domain.form;
  if (domain.type == SettingType::Choice) return joined(choiceIds(domain), "|");
  return isNumber(domain) ? "N" : "TEXT";
}

std::vector<std::string> choiceIds(const SettingDomain& domain) {
  std::vector<std::string> ids;
  for (const SettingChoice& each : domain.choices) ids.push_back(each.id);
  return ids;
}

std::string refusalText(std::string_view name, std::string_view text, const std::string& reason,
                        const SettingDomain& domain) {
  return std::string(name) + "=" + std::string(text) + " " + reason + ": give " +
         allowedText(domain) + ".";
}

}  // namespace chartflood
