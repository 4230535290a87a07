#include "app/gui/widgets/key_names.h"

#include <cctype>
#include <string>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace chartflood {

namespace {

/// Keys that print nothing.
std::string specialName(int key) {
  if (key >= GLFW_KEY_F1 && key <= GLFW_KEY_F25) return "F" + std::to_string(key - GLFW_KEY_F1 + 1);
  if (key >= GLFW_KEY_KP_0 && key <= GLFW_KEY_KP_9) {
    return "Kp" + std::to_string(key - GLFW_KEY_KP_0);
  }
  switch (key) {
  case GLFW_KEY_SPACE:
    return "Space";
  case GLFW_KEY_ENTER:
  case GLFW_KEY_KP_ENTER:
    return "Enter";
  case GLFW_KEY_ESCAPE:
    return "Esc";
  case GLFW_KEY_LEFT:
    return "Left";
  case GLFW_KEY_RIGHT:
    return "Right";
  case GLFW_KEY_UP:
    return "Up";
  case GLFW_KEY_DOWN:
    return "Down";
  case GLFW_KEY_HOME:
    return "Home";
  case GLFW_KEY_END:
    return "End";
  case GLFW_KEY_TAB:
    return "Tab";
  case GLFW_KEY_INSERT:
    return "Insert";
  case GLFW_KEY_DELETE:
    return "Delete";
  case GLFW_KEY_KP_ADD:
    return "+";
  case GLFW_KEY_KP_SUBTRACT:
    return "-";
  default:
    return "";
  }
}

/// "=" with Shift is "+" on many keyboards: both mean more.
std::string printedName(int key, int scancode) {
  const char* name = glfwGetKeyName(key, scancode);
  if (name == nullptr || *name == '\0') return "";
  std::string text = name;
  if (text.size() == 1) {
    text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  }
  return text == "=" ? "+" : text;
}

}  // namespace

std::optional<Chord> chordOf(int key, int scancode, int modifiers) {
  Chord chord;
  chord.key = specialName(key);
  const bool special = !chord.key.empty();
  if (!special) chord.key = printedName(key, scancode);
  if (chord.key.empty()) return std::nullopt;
  chord.ctrl = (modifiers & GLFW_MOD_CONTROL) != 0;
  chord.alt = (modifiers & GLFW_MOD_ALT) != 0;
  const bool sign =
      chord.key.size() == 1 && std::isalnum(static_cast<unsigned char>(chord.key[0])) == 0;
  chord.shift = !sign && (modifiers & GLFW_MOD_SHIFT) != 0;
  return chord;
}

}  // namespace chartflood
