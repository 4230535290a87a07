#pragma once
/// Keys with modifiers, named as people write them: "Ctrl+Shift+Z", "Space", "Kp5", "[".

#include <string>
#include <string_view>

namespace chartflood {

struct Chord {
  std::string key;  ///< one upper-case letter, digit or sign, or a name such as "Space", "F12"
  bool ctrl = false, shift = false, alt = false;

  bool operator==(const Chord&) const = default;
};

/// Reads "Ctrl+Shift+Z"; the last part is the key, so that "Ctrl++" is Ctrl and plus.
/// \throws UsageError when a modifier is unknown or no key is named.
Chord parseChord(std::string_view text);

/// The text that parseChord reads back: "Ctrl+Shift+Z".
std::string chordText(const Chord& chord);

}  // namespace chartflood
