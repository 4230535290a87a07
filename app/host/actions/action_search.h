#pragma once
/// Finds actions and parameters by a few letters of their names, for the search of the window.

#include <string>
#include <string_view>
#include <vector>

namespace chartflood {

class ActionRegistry;
class AppState;

/// One thing that can be done.
struct FoundAction {
  std::string line;    ///< the script line that does it
  std::string title;   ///< "Colour: balance", "Charts to 30"
  std::string key;     ///< "" for none
  std::string help;    ///< what it does
  std::string reason;  ///< why it cannot be done now, "" when it can
};

/// How well the letters of `words` appear in `text`, in order and whatever their case: larger is
/// better, -1 is not at all. Letters at the beginning of words and in a row count most; blanks
/// separate words that may stand in any order.
int matchScore(std::string_view words, std::string_view text);

/// What `words` may mean, best first: actions without arguments or with one choice, and parameters;
/// "charts 30" sets one. Without words: what was done last, then everything else.
std::vector<FoundAction> searchActions(const ActionRegistry& actions, const AppState& state,
                                       std::string_view words);

}  // namespace chartflood
