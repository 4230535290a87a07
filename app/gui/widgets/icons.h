#pragma once
/// Small pictures of the transport and tools, drawn as shapes so that they are sharp at any scale.

#include <imgui.h>

namespace chartflood {

enum class Icon {
  Play,
  Pause,
  StepForward,
  StepBack,
  StepChart,
  StepMany,
  ToStart,
  ToEnd,
  NextRound,
  RunToEnd,
  Stop,
  Camera,
  Reset,
  Dice,
  Close,
  Folder,
  File,
  Up,
};

/// Draws the icon centred in a square of side `size`.
void drawIcon(ImDrawList& list, Icon icon, ImVec2 center, float size, ImU32 color);

}  // namespace chartflood
