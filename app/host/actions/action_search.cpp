#include "app/host/actions/action_search.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <utility>

#include "app/host/script/action_registry.h"
#include "app/host/script/command.h"
#include "app/host/state/app_state.h"
#include "core/base/error.h"
#include "core/base/text.h"

namespace chartflood {

namespace {

constexpr int kWordStart = 8, kInARow = 5, kAnywhere = 1, kWholeWord = 6;
constexpr std::size_t kMostRecent = 6;

bool isLetter(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
         static_cast<unsigned char>(c) >= 0x80;  // of more than one byte
}

bool startsWord(std::string_view text, std::size_t at) {
  return at == 0 || !isLetter(text[at - 1]);
}

/// Score of one word from a place on, taking each letter where it comes first.
int scoreFrom(std::string_view word, std::string_view text, std::size_t first) {
  int score = 0;
  std::size_t last = text.size(), at = first;
  for (const char c : word) {
    while (at < text.size() && lowerCase(text[at]) != lowerCase(c)) ++at;
    if (at == text.size()) return -1;
    if (last + 1 == at) {
      score += kInARow;
    } else {
      score += startsWord(text, at) ? kWordStart : kAnywhere;
    }
    last = at++;
  }
  if (at == text.size() || !isLetter(text[at])) score += kWholeWord;
  return score;
}

int wordScore(std::string_view word, std::string_view text) {
  int best = -1;
  for (std::size_t first = 0; first < text.size(); ++first) {
    if (lowerCase(text[first]) == lowerCase(word[0]))
      best = std::max(best, scoreFrom(word, text, first));
  }
  // A few letters strewn over a long title mean something else.
  return best < 2 * static_cast<int>(word.size()) ? -1 : best;
}

std::vector<std::string_view> wordsOf(std::string_view text) {
  std::vector<std::string_view> words;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    if (end > 0) words.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return words;
}

/// Actions that the search leaves out: they only mean something where they are shown.
bool isPlaceBound(std::string_view id) {
  return id == "close-toast" || id == "find-action" || id == "close-browser" ||
         id == "close-naming" || id == "answer" || id == "preset" || id == "show-parameter";
}

FoundAction entryOf(const ActionRegistry& actions, const AppState& state, const Action& action,
                    const std::string& choice) {
  FoundAction found;
  found.line = choice.empty() ? action.id : action.id + ' ' + quotedArgument(choice);
  found.title = choice.empty() ? action.title : action.title + ": " + choice;
  found.key = actions.shortcut(found.line);
  found.help = action.help;
  found.reason = action.refusal ? action.refusal(state) : std::string();
  return found;
}

/// Every line that needs no typed argument.
std::vector<FoundAction> actionEntries(const ActionRegistry& actions, const AppState& state) {
  std::vector<FoundAction> entries;
  for (const Action& action : actions.actions()) {
    if (isPlaceBound(action.id)) continue;
    const auto needed = std::count_if(action.arguments.begin(), action.arguments.end(),
                                      [](const ArgumentInfo& a) { return a.required; });
    if (needed == 0) {
      entries.push_back(entryOf(actions, state, action, ""));
    } else if (needed == 1 && action.arguments[0].type == ArgumentType::Choice) {
      for (const std::string& choice : action.arguments[0].choices) {
        entries.push_back(entryOf(actions, state, action, choice));
      }
    }
  }
  for (const Preset& preset : presetTable()) {
    entries.push_back({std::string("preset ") + preset.id, std::string("Preset: ") + preset.label,
                       "", preset.help, ""});
  }
  for (const UserPreset& preset : state.preferences.presets) {
    entries.push_back({"own-preset " + quotedArgument(preset.name), "Preset: " + preset.name, "",
                       actions.find("own-preset")->help, ""});
  }
  return entries;
}

/// "checker-size 30": a whole script line, with which every action can be reached.
bool lineEntry(const ActionRegistry& actions, const AppState& state, std::string_view words,
               FoundAction& found) {
  try {
    const Command command = parseCommand(words);
    const Action* action = actions.find(command.action);
    if (action == nullptr) return false;
    const Arguments checked(action->id, action->arguments, command.arguments);
    found = {std::string(words), action->title + ": " + std::string(words), "", action->help,
             action->refusal ? action->refusal(state) : std::string()};
    return true;
  } catch (const UsageError&) {
    return false;
  }
}

FoundAction parameterEntry(const ParameterInfo& info, const AppState& state) {
  const ParameterValue value = parameterValue(state.document().parameters, info);
  return {std::string("show-parameter ") + info.id,
          std::string(info.label) + " = " + parameterText(value), "",
          std::string(info.help) + " Type a value after the name to set it.", ""};
}

/// "charts 30": the last word is a value that the parameter takes.
bool valueEntry(const ParameterInfo& info, const AppState& state, std::string_view value,
                FoundAction& found) {
  Parameters trial = state.document().parameters;
  try {
    setParameterFromText(trial, info, value);
  } catch (const UsageError&) {
    return false;
  }
  found.line = std::string("set ") + info.id + ' ' + quotedArgument(value);
  found.title = std::string(info.label) + " to " + std::string(value);
  found.help = info.help;
  return true;
}

int parameterScore(std::string_view words, const ParameterInfo& info) {
  const int byId = matchScore(words, info.id);
  return std::max(std::max(matchScore(words, info.label), byId),
                  !words.empty() && words == info.symbol ? 4 * kWordStart : -1);
}

/// The lines that worked last, each once, newest first.
std::map<std::string, int, std::less<>> recentRanks(const AppState& state) {
  std::map<std::string, int, std::less<>> ranks;
  const std::vector<std::string>& journal = state.journal();
  for (auto line = journal.rbegin(); line != journal.rend() && ranks.size() < kMostRecent; ++line) {
    ranks.emplace(*line, static_cast<int>(kMostRecent - ranks.size()));
  }
  return ranks;
}

}  // namespace

int matchScore(std::string_view words, std::string_view text) {
  int sum = 0;
  for (const std::string_view word : wordsOf(words)) {
    const int score = wordScore(word, text);
    if (score < 0) return -1;
    sum += score;
  }
  return sum;
}

std::vector<FoundAction> searchActions(const ActionRegistry& actions, const AppState& state,
                                       std::string_view words) {
  std::vector<std::pair<int, FoundAction>> scored;
  const auto recent = recentRanks(state);
  const auto take = [&](FoundAction found, int score) {
    if (score < 0) return;
    const auto rank = recent.find(found.line);
    score = 10 * score + (rank == recent.end() ? 0 : rank->second);
    if (!found.reason.empty()) score -= 1;  // what can be done goes first
    scored.emplace_back(score, std::move(found));
  };
  for (FoundAction& entry : actionEntries(actions, state)) {
    const int score = std::max(matchScore(words, entry.title), matchScore(words, entry.line) - 1);
    take(std::move(entry), score);
  }
  const std::vector<std::string_view> parts = wordsOf(words);
  if (FoundAction typed; lineEntry(actions, state, words, typed)) {
    const bool listed = std::any_of(scored.begin(), scored.end(), [&](const auto& entry) {
      return entry.second.line == typed.line;
    });
    if (!listed) take(std::move(typed), matchScore(words, words));
  }
  for (const ParameterInfo& info : parameterTable()) {
    FoundAction row = parameterEntry(info, state);
    const int score = std::max(parameterScore(words, info), matchScore(words, row.title));
    take(std::move(row), score);
    if (parts.size() < 2) continue;
    FoundAction found;
    const auto before = static_cast<std::size_t>(parts.back().data() - words.data());
    const std::string_view name = words.substr(0, words.find_last_not_of(' ', before - 1) + 1);
    const int named = parameterScore(name, info);
    if (named >= 0 && valueEntry(info, state, parts.back(), found)) {
      take(std::move(found), named + kWordStart);
    }
  }
  std::stable_sort(scored.begin(), scored.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<FoundAction> result;
  result.reserve(scored.size());
  for (auto& [score, found] : scored) result.push_back(std::move(found));
  return result;
}

}  // namespace chartflood
