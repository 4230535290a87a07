// Actions that take pictures, and what pictures are like.

#include <utility>

#include "app/host/actions/action_needs.h"
#include "app/host/actions/actions.h"
#include "app/host/actions/switch_action.h"
#include "app/host/script/action_registry.h"
#include "app/host/state/app_state.h"
#include "core/base/error.h"

namespace chartflood {

namespace {

void takePicture(AppState& state, const Arguments& a) {
  PictureRequest request;
  request.settings = state.preferences.picture;
  request.bare = a.flag("bare", false);
  if (request.bare) {
    request.settings.legend = request.settings.seeds = request.settings.numbers = false;
    request.settings.ground = "transparent";
    if (request.settings.view == "window") request.settings.view = "3d";  // the model alone
  }
  if (a.has("view")) request.settings.view = a.text("view");
  if (a.has("scale")) {
    const long scale = a.integer("scale");
    if (scale != 1 && scale != 2 && scale != 4) {
      throw UsageError("A picture can be 1, 2 or 4 times the size of the view.");
    }
    request.settings.size = scale == 1 ? "window" : "window-" + std::to_string(scale);
  }
  request.file = a.text("file");
  const std::string reason = pictureRefusal(state, request.settings.view);
  if (!reason.empty()) throw Refusal(reason);
  state.requests.pictures.push_back(std::move(request));
}

void takeRow(AppState& state, const Arguments& a, PictureRequest::Row row) {
  PictureRequest request;
  request.settings = state.preferences.picture;
  request.row = row;
  if (a.has("frames")) setPictureValue(request.settings, "frames", a.text("frames"));
  // A row is of the live model; where it turns there is nothing of the texture to see.
  const std::string& view = request.settings.view;
  if (view == "ab" || view == "window" || (view == "uv" && row == PictureRequest::Row::Turntable)) {
    request.settings.view = "3d";
  }
  const std::string reason = pictureRefusal(state, view);
  if (!reason.empty()) throw Refusal(reason);
  if (state.pictureRow.running()) {
    throw Refusal("Pictures are being taken; wait for them or stop them first.");
  }
  state.requests.pictures.push_back(std::move(request));
}

std::string needsFlood(const AppState& state) {
  if (!state.hasMesh()) return needsMesh(state);
  const bool flooded = state.results().record && state.results().record->size() > 0;
  return flooded ? "" : "There is no flood yet; press Play first.";
}

void addRows(ActionRegistry& registry) {
  const std::vector<ArgumentInfo> frames = {
      {"frames", ArgumentType::Integer, "how many pictures; left out: as set", false}};
  registry.add({.id = "turntable",
                .title = "Save turntable",
                .help = "Saves numbered pictures of a whole turn about the upright axis, in a new "
                        "folder.",
                .arguments = frames,
                .refusal = needsMesh,
                .run = [](AppState& state, const Arguments& a) {
                  takeRow(state, a, PictureRequest::Row::Turntable);
                }});
  registry.add({.id = "flood-film",
                .title = "Save flood film",
                .help = "Saves numbered pictures of the present flood on its way, in a new folder; "
                        "the last one shows the charts.",
                .arguments = frames,
                .refusal = needsFlood,
                .run = [](AppState& state, const Arguments& a) {
                  takeRow(state, a, PictureRequest::Row::FloodFilm);
                }});
  registry.add(
      {.id = "stop-pictures",
       .title = "Stop",
       .help = "Takes no more pictures of the row; those that were saved stay.",
       .arguments = {},
       .refusal =
           [](const AppState& state) {
             return state.pictureRow.running() ? "" : "No pictures are being taken.";
           },
       .run = [](AppState& state, const Arguments&) { state.requests.stopPictures = true; }});
}

}  // namespace

void addPictureActions(ActionRegistry& registry) {
  addRows(registry);
  registry.add({.id = "screenshot",
                .title = "Save picture",
                .help = "Saves a PNG picture as set in the dialog of pictures (Shift+F12); bare: "
                        "transparent, without helpers.",
                .arguments = {{"file", ArgumentType::Text, "left out: a new name", false},
                              {"scale", ArgumentType::Integer, "1, 2 or 4 times the view", false},
                              {"view",
                               ArgumentType::Choice,
                               "left out: as set",
                               false,
                               {"3d", "uv", "both", "ab", "window"}},
                              {"bare", ArgumentType::Switch, "without helpers", false}},
                .refusal = needsMesh,
                .run = takePicture});
  registry.bind("F12", "screenshot");
  registry.bind("Ctrl+F12", "screenshot bare=on");
  addSwitch(
      registry, "picture-dialog", "Picture\u2026",
      "What pictures are like: view, size, ground and name.", "Shift+F12",
      [](auto& state) -> auto& { return state.panels.picture; });
  ArgumentInfo key{"key", ArgumentType::Choice, "which one"};
  for (const auto& row : pictureSettingTable()) {
    key.choices.push_back(row.id);
    if (*row.former != '\0') key.former.push_back(row.former);
  }
  registry.add({.id = "picture-set",
                .title = "Set what pictures are like",
                .help = "Gives a setting of pictures a new value.",
                .arguments = {key, {"value", ArgumentType::Text, "the new value", false}},
                .refusal = {},
                .run =
                    [](AppState& state, const Arguments& a) {
                      setPictureValue(state.preferences.picture, a.text("key"), a.text("value"));
                    },
                .checked =
                    [](const AppState& state, const Arguments& a) {
                      return pictureValue(state.preferences.picture, a.text("key")) ==
                             a.text("value");
                    }});
}

}  // namespace chartflood
