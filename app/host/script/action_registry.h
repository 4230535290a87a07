#pragma once
/// All actions and the keys that start them.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/host/script/action.h"
#include "app/host/script/chord.h"

namespace chartflood {

/// Where a key means something of its own, before any other meaning of the same key.
enum class KeyPlace {
  Anywhere,
  SeedsTool,   ///< while that tool is chosen
  HandleFilm,  ///< while that film lies over the model
};

/// A key and the script line it runs.
struct Binding {
  Chord chord;
  std::string line;
  KeyPlace place = KeyPlace::Anywhere;
};

class ActionRegistry {
 public:
  /// Ids must be unique.
  void add(Action action);
  /// Binds a key; the line's action must have been added and the key be free.
  void bind(std::string_view chord, std::string_view line, KeyPlace place = KeyPlace::Anywhere);

  std::span<const Action> actions() const { return actions_; }
  std::span<const Binding> bindings() const { return bindings_; }
  /// By its id or former id; nullptr for others.
  const Action* find(std::string_view id) const;
  /// The binding of a key at a place, or nullptr.
  const Binding* findBinding(const Chord& chord, KeyPlace place = KeyPlace::Anywhere) const;
  /// "Ctrl+Z" for the first key bound to this very line, "" if none is.
  std::string shortcut(std::string_view line) const;

  /// Why the line's action cannot run now; "" when it can.
  std::string refusal(std::string_view line, const AppState& state) const;
  /// Whether the line's action shows as on.
  bool checked(std::string_view line, const AppState& state) const;
  /// Runs one line; an empty one does nothing.
  /// \throws UsageError for an unknown action or wrong arguments, Error when it cannot run now or
  /// fails.
  void run(std::string_view line, AppState& state) const;

 private:
  const Action& at(std::string_view id) const;

  std::vector<Action> actions_;
  std::vector<Binding> bindings_;
};

}  // namespace chartflood
