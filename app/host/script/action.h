#pragma once
/// One thing the user can do, whatever starts it: menu, button, key, script line or test.

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "app/host/script/command.h"
#include "core/base/error.h"

namespace chartflood {

class AppState;

/// What cannot be done now, though it was asked for in the right way: told in passing.
class Refusal : public Error {
 public:
  using Error::Error;
};

enum class ArgumentType { Text, Integer, Number, Switch, Choice };

struct ArgumentInfo {
  std::string name;
  ArgumentType type = ArgumentType::Text;
  std::string help;
  bool required = true;
  std::vector<std::string> choices = {};  ///< of a Choice
  std::vector<std::string> labels = {};   ///< of these in menus; none: as they are
  std::vector<std::string> former = {};   ///< more choices, of older versions, that are still read
};

/// Arguments of one call, checked against the action's table.
class Arguments {
 public:
  /// Positional values take the names of `table` in order.
  /// \throws UsageError that names the action and the argument.
  Arguments(std::string_view action, const std::vector<ArgumentInfo>& table,
            const ArgumentMap& given);

  bool has(std::string_view name) const { return values_.find(name) != values_.end(); }
  /// The value of a given argument; "" when it was left out.
  std::string text(std::string_view name) const;
  double number(std::string_view name, double fallback = 0) const;
  long integer(std::string_view name, long fallback = 0) const;
  /// True for "on", "true", "yes", "1"; `fallback` when left out.
  bool flag(std::string_view name, bool fallback) const;

 private:
  ArgumentMap values_;
};

struct Action {
  std::string id;     ///< "color-by": the first word of a script line
  std::string title;  ///< "Colour": as menus and buttons show it
  std::string help;   ///< one sentence: what it does
  std::vector<ArgumentInfo> arguments;
  /// Why it cannot run now, as one sentence; "" when it can.
  std::function<std::string(const AppState&)> refusal;
  /// \throws Error when it fails.
  std::function<void(AppState&, const Arguments&)> run;
  /// For menus: whether the thing that it sets or toggles is on. May be empty.
  std::function<bool(const AppState&, const Arguments&)> checked = {};
  std::string former = {};  ///< id that older versions gave it, still read
};

}  // namespace chartflood
