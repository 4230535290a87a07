#include "app/gui/widgets/theme.h"

#include <cmath>

#include <imgui_freetype.h>

#include "render/text/font_data.h"

namespace chartflood {

namespace {

constexpr ImU32 rgb(unsigned hex, unsigned alpha = 255) {
  return IM_COL32((hex >> 16) & 255u, (hex >> 8) & 255u, hex & 255u, alpha);
}

constexpr Palette kDark = {
    .ground = rgb(0x2B2B2B),
    .panel = rgb(0x242526),
    .bar = rgb(0x1D1E1F),
    .popup = rgb(0x2C2E30),
    .control = rgb(0x35373A),
    .controlHovered = rgb(0x404347),
    .controlActive = rgb(0x45494D),
    .line = rgb(0x3A3C3F),
    .text = rgb(0xE6E7E8),
    .dim = rgb(0xB6BABE),
    .accent = rgb(0x57ABCF),
    .accentSoft = rgb(0x284D5F),
    .front = rgb(0xF2C14E),
    .good = rgb(0x6CC08B),
    .warning = rgb(0xE5B567),
    .error = rgb(0xEB8A82),
    .veil = rgb(0x181818, 200),
    .axisX = rgb(0xD97B73),
    .axisY = rgb(0x8CBF7A),
    .axisZ = rgb(0x749FD6),
    .ball = rgb(0x46484B),
    .ballRim = rgb(0x292A2C),
};

constexpr Palette kLight = {
    .ground = rgb(0xE9EAEC),
    .panel = rgb(0xF6F6F7),
    .bar = rgb(0xE6E8EA),
    .popup = rgb(0xFFFFFF),
    .control = rgb(0xDFE1E4),
    .controlHovered = rgb(0xD3D6DA),
    .controlActive = rgb(0xC9CDD2),
    .line = rgb(0xC4C8CD),
    .text = rgb(0x1B1D1F),
    .dim = rgb(0x494E53),
    .accent = rgb(0x1A6A90),
    .accentSoft = rgb(0xB5D8E8),
    .front = rgb(0x8A4A00),
    .good = rgb(0x1B6E3E),
    .warning = rgb(0x7D5200),
    .error = rgb(0xA82E25),
    .veil = rgb(0xF8F8F8, 200),
    .axisX = rgb(0xB03A30),
    .axisY = rgb(0x35702A),
    .axisZ = rgb(0x2459A5),
    .ball = rgb(0xE2E4E6),
    .ballRim = rgb(0xBFC3C7),
};

constexpr Palette kHighContrast = {
    .ground = rgb(0x000000),
    .panel = rgb(0x000000),
    .bar = rgb(0x000000),
    .popup = rgb(0x0A0A0A),
    .control = rgb(0x1C1C1C),
    .controlHovered = rgb(0x333333),
    .controlActive = rgb(0x3D3D3D),
    .line = rgb(0xC8C8C8),
    .text = rgb(0xFFFFFF),
    .dim = rgb(0xE4E4E4),
    .accent = rgb(0x5CD3FF),
    .accentSoft = rgb(0x004A6E),
    .front = rgb(0xFFD400),
    .good = rgb(0x6CFF9E),
    .warning = rgb(0xFFD066),
    .error = rgb(0xFFA9A2),
    .veil = rgb(0x000000, 235),
    .axisX = rgb(0xFF9C94),
    .axisY = rgb(0x9CF08A),
    .axisZ = rgb(0x9CC6FF),
    .ball = rgb(0x303030),
    .ballRim = rgb(0x101010),
};

ImVec4 vec(ImU32 color) { return ImGui::ColorConvertU32ToFloat4(color); }

void setColors(ImGuiStyle& style, const Palette& p) {
  const bool light = &p == &kLight;
  if (light) {
    ImGui::StyleColorsLight(&style);
  } else {
    ImGui::StyleColorsDark(&style);
  }
  auto set = [&](ImGuiCol index, ImU32 color) { style.Colors[index] = vec(color); };
  set(ImGuiCol_Text, p.text);
  set(ImGuiCol_TextDisabled, p.dim);
  set(ImGuiCol_WindowBg, p.panel);
  set(ImGuiCol_ChildBg, rgb(0, 0));
  set(ImGuiCol_PopupBg, p.popup);
  set(ImGuiCol_MenuBarBg, p.bar);
  set(ImGuiCol_Border, p.line);
  set(ImGuiCol_Separator, p.line);
  set(ImGuiCol_FrameBg, p.control);
  set(ImGuiCol_FrameBgHovered, p.controlHovered);
  set(ImGuiCol_FrameBgActive, p.controlActive);
  set(ImGuiCol_Button, p.control);
  set(ImGuiCol_ButtonHovered, p.controlHovered);
  set(ImGuiCol_ButtonActive, p.controlActive);
  set(ImGuiCol_Header, p.accentSoft);
  set(ImGuiCol_HeaderHovered, p.controlHovered);
  set(ImGuiCol_HeaderActive, p.controlActive);
  set(ImGuiCol_CheckMark, p.accent);
  set(ImGuiCol_SliderGrab, p.accent);
  set(ImGuiCol_SliderGrabActive, p.accent);
  set(ImGuiCol_Tab, p.panel);
  set(ImGuiCol_TabHovered, p.controlHovered);
  set(ImGuiCol_TabActive, p.control);
  set(ImGuiCol_TableHeaderBg, p.bar);
  set(ImGuiCol_TableRowBg, rgb(0, 0));
  set(ImGuiCol_TableRowBgAlt, light ? rgb(0x000000, 8) : rgb(0xFFFFFF, 6));
  set(ImGuiCol_TableBorderLight, p.line);
  set(ImGuiCol_TableBorderStrong, p.line);
  set(ImGuiCol_ScrollbarBg, rgb(0, 0));
  set(ImGuiCol_ScrollbarGrab, p.control);
  set(ImGuiCol_ScrollbarGrabHovered, p.controlHovered);
  set(ImGuiCol_ScrollbarGrabActive, p.controlActive);
  set(ImGuiCol_NavHighlight, p.accent);
  set(ImGuiCol_ModalWindowDimBg, rgb(0x000000, 110));
  set(ImGuiCol_TextSelectedBg, p.accentSoft);
  set(ImGuiCol_TitleBg, p.bar);
  set(ImGuiCol_TitleBgActive, p.bar);
  // Where grounds hardly differ, controls and what floats over the views have edges.
  const bool edges = &p == &kHighContrast;
  style.FrameBorderSize = style.TabBorderSize = style.WindowBorderSize = edges ? 1.0f : 0.0f;
  if (edges) set(ImGuiCol_ScrollbarGrab, p.line);
}

void setSizes(ImGuiStyle& style, float scale) {
  style.WindowPadding = {10, 8};
  style.FramePadding = {8, 4};
  style.ItemSpacing = {8, 5};
  style.ItemInnerSpacing = {6, 4};
  style.IndentSpacing = 14;
  style.ScrollbarSize = 11;
  style.GrabMinSize = 10;
  style.ChildBorderSize = 0;
  style.PopupBorderSize = 1;
  style.WindowRounding = 0;
  style.ChildRounding = 0;
  style.FrameRounding = 4;
  style.PopupRounding = 5;
  style.ScrollbarRounding = 6;
  style.GrabRounding = 4;
  style.TabRounding = 4;
  style.WindowMinSize = {16, 16};
  style.CellPadding = {6, 3};
  style.ScaleAllSizes(scale);
}

ImFont* addFont(std::span<const unsigned char> data, float pixels) {
  // Latin with accents, Greek, Cyrillic (file names), punctuation, subscripts, arrows, mathematics.
  static const ImWchar kRanges[] = {0x0020, 0x024F, 0x0370, 0x03FF, 0x0400, 0x052F, 0x1E00,
                                    0x1EFF, 0x2010, 0x205E, 0x2070, 0x209F, 0x2190, 0x2199,
                                    0x2200, 0x2265, 0x25A0, 0x25CF, 0};
  ImFontConfig config;
  config.FontDataOwnedByAtlas = false;
  config.FontBuilderFlags = ImGuiFreeTypeBuilderFlags_LightHinting;
  // The atlas never writes to data that it does not own.
  return ImGui::GetIO().Fonts->AddFontFromMemoryTTF(const_cast<unsigned char*>(data.data()),
                                                    static_cast<int>(data.size()), pixels, &config,
                                                    kRanges);
}

}  // namespace

float Theme::px(float length) const { return std::round(length * scale); }

const Palette& themePalette(ThemeKind kind) {
  switch (kind) {
  case ThemeKind::Light:
    return kLight;
  case ThemeKind::HighContrast:
    return kHighContrast;
  case ThemeKind::Dark:
    break;
  }
  return kDark;
}

void recolor(Theme& theme, ThemeKind kind) {
  theme.kind = kind;
  theme.palette = themePalette(kind);
  setColors(ImGui::GetStyle(), themePalette(kind));
}

Theme applyTheme(float scale, ThemeKind kind) {
  Theme theme;
  theme.scale = scale;

  ImGuiStyle& style = ImGui::GetStyle();
  style = ImGuiStyle();
  recolor(theme, kind);
  setSizes(style, scale);

  ImFontAtlas* atlas = ImGui::GetIO().Fonts;
  atlas->Clear();
  atlas->FontBuilderIO = ImGuiFreeType::GetBuilderForFreeType();
  theme.regular = addFont(interRegular(), std::round(15 * scale));
  theme.strong = addFont(interSemiBold(), std::round(15 * scale));
  theme.small = addFont(interRegular(), std::round(12 * scale));
  atlas->Build();
  return theme;
}

}  // namespace chartflood
