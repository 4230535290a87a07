#pragma once
/// From GLFW's keys, which are places on the keyboard, to the names of our chords, which are what
/// is printed on them.

#include <optional>

#include "app/host/script/chord.h"

namespace chartflood {

/// The chord of a key event; nothing for modifier keys and keys without a name here. Shift is
/// dropped for signs, which already tell ("+", "["), and kept for letters and named keys.
std::optional<Chord> chordOf(int key, int scancode, int modifiers);

}  // namespace chartflood
