// Actions that keep results beside the live ones and choose how they are looked at.

#include <algorithm>
#include <utility>

#include "app/host/actions/actions.h"
#include "app/host/actions/switch_action.h"
#include "app/host/script/action_registry.h"
#include "app/host/state/app_state.h"
#include "app/host/state/compare_look.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/segment/registry.h"

namespace chartflood {

namespace {

/// "MCGIM (A), VSA (B) and t-flooding (C)".
std::string methodsInOrder() {
  std::vector<std::string> names;
  for (const char* id : comparedMethods()) {
    const char letter = static_cast<char>('A' + names.size());
    names.push_back(segmenterOf(id).shortTitle + std::string(" (") + letter + ")");
  }
  return listed(names, "and");
}

const std::vector<std::string> kSlots = {kCompareSlots.begin(), kCompareSlots.end()};

std::string storeRefusal(const AppState& state) {
  if (!state.hasMesh()) return "There is no model yet; open one first.";
  if (state.changing()) return "The charts are changing: store them when they rest, or press Esc.";
  if (state.methodRuns.running()) {
    return "The methods that are being compared will be stored; Esc gives up.";
  }
  if (!state.results().segmentation || !settled(state.results())) {
    return "There are no charts to store yet; press Play first.";
  }
  return "";
}

std::string needsStored(const AppState& state) {
  return state.compare.stored.empty()
             ? "Nothing is stored yet: store the present charts as A first."
             : "";
}

std::string needsTwo(const AppState& state) {
  return state.compare.stored.size() < 2
             ? "Store another state as B first; until then the right side is the live one."
             : "";
}

const StoredResult& slot(const AppState& state, const std::string& name) {
  const StoredResult* stored = state.compare.find(name);
  if (stored == nullptr) throw Refusal("Nothing is stored as " + name + " yet.");
  return *stored;
}

void store(AppState& state, const std::string& name) {
  state.compare.store(storedNow(state, name));
  if (state.compare.layout == Compare::Layout::Off) {
    state.compare.layout = Compare::Layout::SideBySide;
  }
  state.notices.add(Notice::Kind::Info, "The present charts are kept as " + name + ".");
}

void use(AppState& state, const std::string& name) {
  const StoredResult& stored = slot(state, name);
  if (stored.results->mesh != state.results().mesh) {
    throw Refusal(name + " belongs to another model: open that one first.");
  }
  state.takeUp(stored.document, momentOf(*stored.results), "Use " + name);
}

void addSlots(ActionRegistry& registry) {
  registry.add({.id = "store",
                .title = "Store",
                .help = "Keeps the present parameters, seeds and charts, to compare them with what "
                        "comes later. With A alone the right side is always the live state.",
                .arguments = {{"slot", ArgumentType::Choice, "under which letter", true, kSlots}},
                .refusal = storeRefusal,
                .run = [](AppState& state, const Arguments& a) { store(state, a.text("slot")); }});
  registry.add({.id = "use",
                .title = "Use",
                .help = "Makes a stored state the live one, with the very same charts.",
                .arguments = {{"slot", ArgumentType::Choice, "which one", true, kSlots}},
                .refusal = needsStored,
                .run = [](AppState& state, const Arguments& a) { use(state, a.text("slot")); }});
  registry.add({.id = "swap",
                .title = "Swap A and B",
                .help = "What was left is right. Only the sides change.",
                .arguments = {},
                .refusal = needsTwo,
                .run = [](AppState& state, const Arguments&) {
                  activate(state, {});
                  std::swap(state.compare.stored[0], state.compare.stored[1]);
                  std::swap(state.compare.stored[0].name, state.compare.stored[1].name);
                }});
  registry.bind("X", "swap");
  registry.add({.id = "clear-compare",
                .title = "Clear",
                .help = "Forgets what was stored and shows the live state alone.",
                .arguments = {},
                .refusal = needsStored,
                .run = [](AppState& state, const Arguments&) {
                  activate(state, {});
                  state.compare.stored.clear();
                  state.compare.layout = Compare::Layout::Off;
                }});
  registry.add({.id = "select-stored",
                .title = "Select a stored chart",
                .help = "Selects a chart of a stored state; without a number none.",
                .arguments = {{"slot", ArgumentType::Choice, "of which one", true, kSlots},
                              {"chart", ArgumentType::Integer, "its number", false}},
                .refusal = needsStored,
                .run = [](AppState& state, const Arguments& a) {
                  const StoredResult& stored = slot(state, a.text("slot"));
                  const long chart = a.integer("chart", -1);
                  const auto count = static_cast<long>(stored.results->segmentation->chartCount);
                  if (chart >= count) throw UsageError("There is no such chart.");
                  const auto at = static_cast<std::size_t>(&stored - state.compare.stored.data());
                  state.compare.stored[at].selectedChart =
                      chart < 0 ? kNone : static_cast<Index>(chart);
                }});
}

std::string methodsRefusal(const AppState& state) {
  if (!state.hasMesh()) return "There is no model yet; open one first.";
  if (state.methodRuns.running()) return "The methods are being compared; Esc gives up.";
  const auto& stored = state.compare.stored;
  const bool own = std::any_of(stored.begin(), stored.end(),
                               [](const StoredResult& each) { return !each.ofMethods; });
  return own ? "A, B and C are needed for the methods and hold what you stored: clear them first."
             : "";
}

void addMethods(ActionRegistry& registry) {
  registry.add({.id = "compare-methods",
                .title = "Compare the three methods",
                .help = "Cuts the model by " + methodsInOrder() +
                        " with the present "
                        "number of charts, cuts and unwrap, side by side; the live charts stay.",
                .arguments = {},
                .refusal = methodsRefusal,
                .run = [](AppState& state, const Arguments&) {
                  state.methodRuns.begin(state.results().mesh, state.document());
                }});
}

void addLayout(ActionRegistry& registry, const char* id, const char* title, const char* help,
               Compare::Layout layout) {
  registry.add({.id = id,
                .title = title,
                .help = help,
                .arguments = {{"on", ArgumentType::Switch, "left out: turns it over", false}},
                .refusal = needsStored,
                .run =
                    [layout](AppState& state, const Arguments& a) {
                      const bool on = a.flag("on", state.compare.layout != layout);
                      if (!on) activate(state, {});
                      state.compare.layout = on ? layout : Compare::Layout::Off;
                    },
                .checked = [layout](const AppState& state,
                                    const Arguments&) { return state.compare.layout == layout; }});
}

void addLink(ActionRegistry& registry, const char* id, const char* title, const char* help,
             bool Compare::*member) {
  registry.add({.id = id,
                .title = title,
                .help = help,
                .arguments = {{"on", ArgumentType::Switch, "left out: turns it over", false}},
                .refusal = {},
                .run =
                    [member](AppState& state, const Arguments& a) {
                      bool& value = state.compare.*member;
                      const bool on = a.flag("on", !value);
                      if (on != value) shareLook(state);  // unlinked halves begin alike
                      value = on;
                    },
                .checked = [member](const AppState& state,
                                    const Arguments&) { return state.compare.*member; }});
}

}  // namespace

void addCompareActions(ActionRegistry& registry) {
  addMethods(registry);
  addSlots(registry);
  addLayout(registry, "side-by-side", "Side by side",
            "Shows what is stored side by side; with A alone the live state beside it.",
            Compare::Layout::SideBySide);
  registry.bind("Shift+X", "side-by-side");
  addLayout(registry, "wipe", "Wipe", "Shows A left and B right of a line that can be dragged.",
            Compare::Layout::Wipe);
  registry.add({.id = "wipe-at",
                .title = "Move the wipe",
                .help = "Puts the line at a share of the width.",
                .arguments = {{"share", ArgumentType::Number, "0.02 to 0.98"}},
                .refusal = needsStored,
                .run = [](AppState& state, const Arguments& a) {
                  const double share = a.number("share");
                  if (!(share >= 0.02 && share <= 0.98)) {
                    throw UsageError("The line of the wipe must be at 0.02 to 0.98 of the width.");
                  }
                  state.compare.wipe = share;
                }});
  addLink(registry, "link-cameras", "Link cameras", "All sides are seen from the same place.",
          &Compare::linkCameras);
  addLink(registry, "link-colors", "Link colours",
          "All sides show the same colour mode; else it is that of the side clicked last.",
          &Compare::linkColors);
  addLink(registry, "link-range", "Link colour bars",
          "The same colour means the same value on all sides.", &Compare::linkRange);
  addLink(registry, "link-checker", "Link checkerboards", "All sides have the same squares.",
          &Compare::linkChecker);
}

}  // namespace chartflood
