#include "app/host/script/chord.h"

#include "core/base/error.h"

namespace chartflood {

Chord parseChord(std::string_view text) {
  Chord chord;
  std::string_view rest = text;
  for (std::size_t plus = rest.find('+'); plus != std::string_view::npos && plus > 0;
       plus = rest.find('+')) {
    const std::string_view modifier = rest.substr(0, plus);
    if (modifier == "Ctrl") {
      chord.ctrl = true;
    } else if (modifier == "Shift") {
      chord.shift = true;
    } else if (modifier == "Alt") {
      chord.alt = true;
    } else {
      throw UsageError("Unknown modifier '" + std::string(modifier) + "' in the keys '" +
                       std::string(text) + "'; use Ctrl, Shift or Alt.");
    }
    rest.remove_prefix(plus + 1);
  }
  if (rest.empty()) throw UsageError("The keys '" + std::string(text) + "' name no key.");
  chord.key = rest;
  return chord;
}

std::string chordText(const Chord& chord) {
  std::string text;
  if (chord.ctrl) text += "Ctrl+";
  if (chord.shift) text += "Shift+";
  if (chord.alt) text += "Alt+";
  return text + chord.key;
}

}  // namespace chartflood
