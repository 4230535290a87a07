#include "tests/gui/headless_frame.h"

#include <gtest/gtest.h>
#include <imgui.h>

namespace chartflood {

namespace {

constexpr double kFrameSeconds = 1.0 / 60;
constexpr int kDragSteps = 5;

}  // namespace

HeadlessFrame::Context::Context(ImVec2 size) {
  ImGui::CreateContext();
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.DisplaySize = size;
  io.DeltaTime = static_cast<float>(kFrameSeconds);
  io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
  for (int i = 0; i < ImGuiKey_COUNT; ++i) io.KeyMap[i] = i;
}

HeadlessFrame::Context::~Context() { ImGui::DestroyContext(); }

HeadlessFrame::HeadlessFrame(ImVec2 size, float scale)
    : context_(size), frame_(state_, actions_, scale) {
  frames(3);
}

HeadlessFrame::~HeadlessFrame() = default;

void HeadlessFrame::frames(int count) {
  for (int i = 0; i < count; ++i) {
    state_.update(kFrameSeconds);
    ImGui::NewFrame();
    frame_.draw(sceneSource, uvSource, previewSource);
    ImGui::Render();
  }
}

void HeadlessFrame::openFlooded(const std::string& sample, std::size_t triangles) {
  state_.preferences.explore = false;
  state_.openSample(sample, triangles);
  state_.playback.setSpeed(2 * Playback::kFastest);
  frames(8);
}

ProbedItem HeadlessFrame::item(std::string_view label) const {
  const ProbedItem* found = frame_.probe().find(label);
  EXPECT_NE(found, nullptr) << "there is no widget '" << label << "'";
  return found == nullptr ? ProbedItem{} : *found;
}

void HeadlessFrame::moveTo(ImVec2 place) {
  ImGui::GetIO().MousePos = place;
  frames(1);
}

void HeadlessFrame::press(int button) {
  ImGui::GetIO().MouseDown[button] = true;
  frames(1);
}

void HeadlessFrame::release(int button) {
  ImGui::GetIO().MouseDown[button] = false;
  frames(1);
}

void HeadlessFrame::click(std::string_view label) {
  moveTo(item(label).center());
  press();
  release();
  frames(1);
}

void HeadlessFrame::ctrlClick(std::string_view label) {
  ImGui::GetIO().KeyCtrl = true;
  click(label);
  ImGui::GetIO().KeyCtrl = false;
  frames(1);
}

void HeadlessFrame::drag(std::string_view label, float from, float to) {
  const ProbedItem box = item(label);
  const auto at = [&](float share) {
    return ImVec2(box.min.x + share * (box.max.x - box.min.x), box.center().y);
  };
  moveTo(at(from));
  press();
  for (int i = 1; i <= kDragSteps; ++i) {
    moveTo(at(from + (to - from) * static_cast<float>(i) / kDragSteps));
  }
  release();
  frames(1);
}

void HeadlessFrame::wheel(float notches) {
  ImGui::GetIO().MouseWheel = notches;
  frames(1);
}

void HeadlessFrame::type(const char* text) {
  ImGui::GetIO().AddInputCharactersUTF8(text);
  frames(1);
}

void HeadlessFrame::enter() {
  ImGui::GetIO().KeysDown[ImGuiKey_Enter] = true;
  frames(1);
  ImGui::GetIO().KeysDown[ImGuiKey_Enter] = false;
  frames(2);
}

void HeadlessFrame::escape() {
  ImGui::GetIO().KeysDown[ImGuiKey_Escape] = true;
  frames(1);
  ImGui::GetIO().KeysDown[ImGuiKey_Escape] = false;
  frames(2);
}

void HeadlessFrame::arrow(int key) {
  ImGui::GetIO().KeysDown[key] = true;
  frames(1);
  ImGui::GetIO().KeysDown[key] = false;
  frames(1);
}

std::string HeadlessFrame::lastLine() const {
  return state_.journal().empty() ? std::string() : state_.journal().back();
}

}  // namespace chartflood
