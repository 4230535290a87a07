#include "app/gui/tools/seeds_tool.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "app/gui/panels/panels.h"
#include "app/gui/tools/hints_tool.h"
#include "app/gui/widgets/widgets.h"

namespace chartflood {

namespace {

constexpr float kReach = 12;  // pixels at scale 1 from the middle of a mark

std::string faceText(const Ui& ui, Index face) {
  return std::to_string(ui.state.results().mesh->inputFace(face));
}

ImVec2 placeOf(const Camera& camera, const ViewRectangle& view, const glm::dvec3& point) {
  const glm::dvec3 ndc = camera.project(point, view.aspect(), BoundingSphere{});
  return {view.min.x + static_cast<float>((ndc.x + 1) / 2 * view.width()),
          view.min.y + static_cast<float>((1 - ndc.y) / 2 * view.height())};
}

/// Whether nothing lies before a point of the surface: marks stand out of it by their own size.
bool canBeSeen(const Ui& ui, SceneSource* source, const ViewRectangle& view,
               const glm::dvec3& point, ImVec2 place) {
  const Camera& camera = ui.state.view.camera;
  const auto depth = [&](const glm::dvec3& p) {
    return glm::dot(p - camera.eye(), camera.forward());
  };
  if (!camera.orthographic && depth(point) <= 0) return false;
  const Pick pick = pickAt(source, view, place);
  const double pixel = 2 * camera.halfHeight() / std::max(1.0, view.height());
  const double size = static_cast<double>(ui.state.view.render.seedRadius * ui.theme.scale);
  return !pick.hit() || depth(pick.point) > depth(point) - size * pixel;
}

bool isFree(const std::vector<PlacedSeed>& seeds, Index face) {
  return std::none_of(seeds.begin(), seeds.end(),
                      [&](const PlacedSeed& seed) { return seed.face == face; });
}

bool usesSeeds(const Ui& ui) { return ui.state.panels.tool == PanelState::Tool::Seeds; }

std::string seedLine(const char* action, Index seed) {
  return std::string(action) + " seed=" + std::to_string(seed);
}

void clickLeft(const Ui& ui, SceneSource* source, const ViewRectangle& view, SceneMouse& mouse) {
  const ImGuiIO& io = ImGui::GetIO();
  mouse.clickAdded = false;
  if (mouse.seed != kNone) {
    if (io.KeyCtrl) ui.run(seedLine("delete-seed", mouse.seed));
    return;
  }
  if (io.KeyCtrl || io.KeyShift || io.KeyAlt) return;
  const Pick pick = pickAt(source, view, io.MousePos);
  if (!pick.hit()) return;
  ui.run("add-seed face=" + faceText(ui, pick.face));
  mouse.clickAdded = true;
}

}  // namespace

Pick pickAt(SceneSource* source, const ViewRectangle& view, ImVec2 place) {
  if (source == nullptr) return {};
  const ImVec2 scale = ImGui::GetIO().DisplayFramebufferScale;
  return source->pick(static_cast<int>((place.x - view.min.x) * scale.x),
                      static_cast<int>((place.y - view.min.y) * scale.y));
}

Index seedAt(const Ui& ui, SceneSource* source, const ViewRectangle& view, ImVec2 place) {
  if (source == nullptr || !ui.state.hasMesh() || !ui.state.view.render.seedMarks) return kNone;
  const Mesh& mesh = *ui.state.results().mesh;
  const std::vector<PlacedSeed> seeds = ui.state.presentSeeds();
  std::vector<std::pair<float, Index>> near;
  for (Index i = 0; i < seeds.size(); ++i) {
    if (seeds[i].face >= mesh.faceCount()) continue;
    const ImVec2 at = placeOf(ui.state.view.camera, view, faceMiddle(mesh, seeds[i].face));
    const float away = std::hypot(at.x - place.x, at.y - place.y);
    if (away <= ui.px(kReach)) near.emplace_back(away, i);
  }
  std::sort(near.begin(), near.end());
  for (const auto& [away, seed] : near) {
    const glm::dvec3 middle = faceMiddle(mesh, seeds[seed].face);
    const ImVec2 at = placeOf(ui.state.view.camera, view, middle);
    if (canBeSeen(ui, source, view, middle, at)) return seed;
  }
  return kNone;
}

void pressSeed(const Ui& ui, SceneSource* source, const ViewRectangle& view, SceneMouse& mouse) {
  const ImGuiIO& io = ImGui::GetIO();
  mouse.seed = kNone;
  mouse.seedDragged = false;
  if (!usesSeeds(ui) || mouse.button == 2 || io.KeyAlt) return;
  mouse.seed = seedAt(ui, source, view, io.MousePos);
  const bool twice = mouse.button == 0 && io.MouseDoubleClicked[0] && !io.KeyCtrl;
  // The second click on a fresh seed was meant for the surface.
  if (twice && mouse.seed != kNone && !mouse.clickAdded) ui.run(seedLine("lock-seed", mouse.seed));
}

void dragSeed(const Ui& ui, SceneSource* source, const ViewRectangle& view, SceneMouse& mouse) {
  const ImGuiIO& io = ImGui::GetIO();
  AppState& state = ui.state;
  const bool moves = io.MouseDelta.x != 0 || io.MouseDelta.y != 0;
  const std::vector<PlacedSeed> seeds = state.presentSeeds();
  if (!mouse.seedDragged) {
    if (mouse.seed >= seeds.size()) return;
    mouse.seedDragged = true;
    state.seedDrag = SeedDrag{mouse.seed, seeds[mouse.seed].face};
  }
  if (!state.seedDrag || state.seedDrag->seed >= seeds.size()) return;  // it was put back
  SeedDrag& drag = *state.seedDrag;
  if (moves) {
    const Pick pick = pickAt(source, view, io.MousePos);
    if (pick.hit() && (isFree(seeds, pick.face) || seeds[drag.seed].face == pick.face)) {
      drag.face = pick.face;
    }
  }
  if (drag.face == seeds[drag.seed].face) return;
  // A flood that is under way is not thrown away for each step of the hand.
  if (state.changing()) return ui.wakeIn(0);
  const std::string line = seedLine("move-seed", mouse.seed) + " face=" + faceText(ui, drag.face);
  if (!state.perform(ui.actions, line + " drag=on")) drag.face = seeds[drag.seed].face;
}

void releaseSeed(const Ui& ui, SceneSource* source, const ViewRectangle& view, SceneMouse& mouse) {
  AppState& state = ui.state;
  if (mouse.seedDragged) {
    if (state.seedDrag) {
      ui.run(seedLine("move-seed", mouse.seed) + " face=" + faceText(ui, state.seedDrag->face));
      state.seedDrag.reset();
    }
  } else if (mouse.travelled < SceneMouse::kClickTravel) {
    if (mouse.button == 0) clickLeft(ui, source, view, mouse);
    if (mouse.button == 1 && mouse.seed != kNone) {
      mouse.menuSeed = mouse.seed;
      ImGui::OpenPopup("seed menu");
    }
  }
  mouse.seed = kNone;
  mouse.seedDragged = false;
  mouse.pickedAt = {-1, -1};  // what is under the mouse may be another seed now
}

void seedMenu(const Ui& ui, SceneSource* source, const ViewRectangle& view, SceneMouse& mouse) {
  if (std::exchange(ui.state.requests.seedInView, false)) {
    const ImVec2 middle{(view.min.x + view.max.x) / 2, (view.min.y + view.max.y) / 2};
    const Pick pick = pickAt(source, view, middle);
    if (pick.hit()) {
      ui.run("add-seed face=" + faceText(ui, pick.face));
    } else {
      ui.state.notices.add(Notice::Kind::Info, "The middle of the view shows no surface.");
    }
  }
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(ui.px(8), ui.px(6)));
  const bool open = ImGui::BeginPopup("seed menu");
  ImGui::PopStyleVar();
  if (!open) return;
  const std::vector<PlacedSeed> seeds = ui.state.presentSeeds();
  if (mouse.menuSeed < seeds.size()) {
    ImGui::PushStyleColor(ImGuiCol_Text, ui.theme.palette.dim);
    ImGui::Text("Seed %u", mouse.menuSeed);
    ImGui::PopStyleColor();
    actionMenuItem(ui, seedLine("lock-seed", mouse.menuSeed),
                   seeds[mouse.menuSeed].locked ? "Unlock" : "Lock");
    actionMenuItem(ui, seedLine("delete-seed", mouse.menuSeed), "Delete");
    ImGui::Separator();
    swapEntries(ui, mouse.menuSeed);
    actionMenuItem(ui, "chart-in-texture " + std::to_string(mouse.menuSeed));
  }
  ImGui::EndPopup();
}

void toolSwitch(const Ui& ui, ImVec2 areaMin) {
  constexpr ImGuiWindowFlags kFlags =
      ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
      ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing;
  ImGui::SetNextWindowPos({areaMin.x + ui.px(12), areaMin.y + ui.px(12)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(ui.px(3), ui.px(3)));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, ui.px(5));
  ImGui::PushStyleColor(ImGuiCol_WindowBg, ui.theme.palette.bar);
  ImGui::Begin("tool switch", nullptr, kFlags);
  const auto tool = [&](const char* words, PanelState::Tool which, const char* line) {
    const bool chosen = ui.state.panels.tool == which;
    ImGui::PushStyleColor(ImGuiCol_Button, chosen ? ui.theme.palette.accentSoft : 0);
    textButton(ui, words, line, {ui.px(68), 0});
    ImGui::PopStyleColor();
  };
  tool("Select", PanelState::Tool::Select, "tool select");
  ImGui::SameLine(0, ui.px(2));
  tool("Seeds", PanelState::Tool::Seeds, "tool seeds");
  ImGui::SameLine(0, ui.px(2));
  tool("Hints", PanelState::Tool::Hints, "tool hints");
  if (ui.state.panels.tool == PanelState::Tool::Hints) brushSwitch(ui);
  ImGui::End();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar(2);
}

}  // namespace chartflood
