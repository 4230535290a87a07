#pragma once
/// The row type of every setting that is no parameter: what it is called, what it may be, how it is
/// read off and set. Options, actions, session files, preferences, menus and help come from tables
/// of such rows.

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace chartflood {

/// A value as files hold it.
using SettingValue = std::variant<bool, double, std::string, std::vector<double>>;

enum class SettingType { Switch, Whole, Number, Choice, Text };

/// One value of a choice.
struct SettingChoice {
  std::string id;
  std::string label;        ///< in menus
  std::string former = {};  ///< what an older version called it, still read
};

/// What values there are.
struct SettingDomain {
  SettingType type = SettingType::Text;
  double least = 0, most = 0;  ///< of numbers
  std::vector<SettingChoice> choices = {};
  std::vector<std::string> words = {};  ///< that a number may be instead
  std::string form = {};                ///< what stands for the value in help; "": from the above
  std::string allowed = {};             ///< what a refusal offers; "": from the above
};

/// Text that valueFromText() reads back.
std::string valueText(const SettingValue& value);
/// Nothing, with the reason ("is out of range"), for a text that cannot be a value.
std::optional<SettingValue> valueFromText(const SettingDomain& domain, std::string_view text,
                                          std::string& reason);
/// Why it is none of the domain: "is out of range"; "" when it is one.
std::string valueProblem(const SettingDomain& domain, const SettingValue& value);
/// "a whole number from 2 to 10000"
std::string allowedText(const SettingDomain& domain);
/// What stands for the value in help: "auto|on|off", "N", "" for a switch.
std::string formText(const SettingDomain& domain);
std::vector<std::string> choiceIds(const SettingDomain& domain);
/// "NAME=TEXT is out of range: give a number from 1 to 2."
std::string refusalText(std::string_view name, std::string_view text, const std::string& reason,
                        const SettingDomain& domain);

/// Where a setting is kept and what it may be.
template <typename Owner>
struct SettingSource {
  using Get = std::function<SettingValue(const Owner&)>;
  using Set = std::function<std::string(Owner&, const SettingValue&)>;
  using Kept = std::function<bool(const Owner&)>;

  SettingSource(SettingDomain values, Get reader, Set writer, Kept whether = {})
      : domain(std::move(values)), get(std::move(reader)), set(std::move(writer)),
        kept(std::move(whether)) {}

  SettingDomain domain;
  Get get;
  Set set;    ///< why the value cannot be, as valueProblem(); "" when it was taken
  Kept kept;  ///< whether sessions hold it; none: always
};

template <typename Owner>
struct Setting {
  const char* id;     ///< option, action and key in files
  const char* title;  ///< in menus and beside switches; "": only files know it
  const char* help;   ///< one sentence
  SettingSource<Owner> value;
  const char* key = "";            ///< of the keyboard
  const char* argument = "value";  ///< of its action
  const char* note = "";           ///< after the default in the help of the option
  bool option = false;             ///< the command line has it
  const char* former = "";         ///< name that older versions gave it, still read

  /// Why the value was not taken; "" when it was.
  std::string set(Owner& owner, const SettingValue& wanted) const {
    return value.set(owner, wanted);
  }
  std::string setText(Owner& owner, std::string_view text) const {
    std::string reason;
    const std::optional<SettingValue> wanted = valueFromText(value.domain, text, reason);
    return wanted ? set(owner, *wanted) : reason;
  }
  SettingValue get(const Owner& owner) const { return value.get(owner); }
  std::string text(const Owner& owner) const { return valueText(get(owner)); }
  bool isSwitch() const { return value.domain.type == SettingType::Switch; }
  /// Whether the owner has the value of this text.
  bool has(const Owner& owner, std::string_view wanted) const {
    Owner other{};
    return setText(other, wanted).empty() && get(other) == get(owner);
  }
};

template <typename Owner>
using SettingTable = std::vector<Setting<Owner>>;

/// The row of this name or former name, or nullptr.
template <typename Owner>
const Setting<Owner>* findSetting(const SettingTable<Owner>& rows, std::string_view name) {
  for (const Setting<Owner>& row : rows) {
    if (name == row.id) return &row;
  }
  for (const Setting<Owner>& row : rows) {
    if (*row.former != '\0' && name == row.former) return &row;
  }
  return nullptr;
}

/// Rows of a part as rows of the whole.
template <typename Outer, typename Inner>
SettingTable<Outer> lifted(const SettingTable<Inner>& rows, Inner Outer::*part) {
  SettingTable<Outer> result;
  for (const Setting<Inner>& row : rows) {
    const auto get = [=](const Outer& outer) { return row.value.get(outer.*part); };
    const auto set = [=](Outer& outer, const SettingValue& value) {
      return row.value.set(outer.*part, value);
    };
    typename SettingSource<Outer>::Kept kept;
    if (row.value.kept) kept = [=](const Outer& outer) { return row.value.kept(outer.*part); };
    result.push_back({row.id,
                      row.title,
                      row.help,
                      {row.value.domain, get, set, kept},
                      row.key,
                      row.argument,
                      row.note,
                      row.option,
                      row.former});
  }
  return result;
}

template <typename Owner>
void append(SettingTable<Owner>& rows, SettingTable<Owner> more) {
  for (Setting<Owner>& row : more) rows.push_back(std::move(row));
}

/// Takes a value of the domain out of its variant after checking it.
template <typename Owner, typename T, typename Take>
SettingSource<Owner> checkedSource(SettingDomain domain,
                                   std::function<SettingValue(const Owner&)> get, Take take) {
  const auto set = [=](Owner& owner, const SettingValue& value) {
    std::string reason = valueProblem(domain, value);
    if (reason.empty()) take(owner, std::get<T>(value));
    return reason;
  };
  return {domain, std::move(get), set};
}

template <typename Owner>
SettingSource<Owner> onOff(bool Owner::*member) {
  return checkedSource<Owner, bool>(
      {.type = SettingType::Switch}, [=](const Owner& owner) { return owner.*member; },
      [=](Owner& owner, bool on) { owner.*member = on; });
}

/// A member that is an int, float or double.
template <typename Owner, typename Number>
SettingSource<Owner> numberFrom(Number Owner::*member, double least, double most) {
  constexpr auto kType = std::is_integral_v<Number> ? SettingType::Whole : SettingType::Number;
  return checkedSource<Owner, double>(
      {.type = kType, .least = least, .most = most},
      [=](const Owner& owner) { return static_cast<double>(owner.*member); },
      [=](Owner& owner, double number) { owner.*member = static_cast<Number>(number); });
}

/// A text that is one of several.
template <typename Owner>
SettingSource<Owner> oneOf(std::string Owner::*member, std::vector<SettingChoice> choices) {
  return checkedSource<Owner, std::string>(
      {.type = SettingType::Choice, .choices = std::move(choices)},
      [=](const Owner& owner) { return owner.*member; },
      [=](Owner& owner, const std::string& id) { owner.*member = id; });
}

/// A member that is one of the values in a table with columns `id` and `label`; `member` finds it
/// in an owner, constant or not.
template <typename Owner, typename Row, typename Enum, typename Place>
SettingSource<Owner> oneOfTable(Place place, std::span<const Row> table, Enum Row::*column) {
  std::vector<SettingChoice> choices;
  for (const Row& row : table) choices.push_back({row.id, row.label});
  const auto get = [=](const Owner& owner) -> SettingValue {
    for (const Row& row : table) {
      if (row.*column == place(owner)) return std::string(row.id);
    }
    return std::string();
  };
  return checkedSource<Owner, std::string>(
      {.type = SettingType::Choice, .choices = std::move(choices)}, get,
      [=](Owner& owner, const std::string& id) {
        for (const Row& row : table) {
          if (id == row.id) place(owner) = row.*column;
        }
      });
}

template <typename Owner>
SettingSource<Owner> freeText(std::string Owner::*member) {
  return checkedSource<Owner, std::string>(
      {}, [=](const Owner& owner) { return owner.*member; },
      [=](Owner& owner, const std::string& text) { owner.*member = text; });
}

/// A value of an enumeration by name.
template <typename Enum>
struct NamedValue {
  Enum value;
  const char* id;
  const char* label;
};
template <typename Owner, typename Enum>
SettingSource<Owner> oneOf(Enum Owner::*member, std::span<const NamedValue<Enum>> table) {
  return oneOfTable<Owner>(
      [=](auto& owner) -> auto& { return owner.*member; }, table, &NamedValue<Enum>::value);
}

}  // namespace chartflood
