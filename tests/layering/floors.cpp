#include "tests/layering/floors.h"

#include <algorithm>

namespace chartflood {

namespace {

using Names = std::vector<std::string>;

const Names kGl{"epoxy/", "GL/", "EGL/", "KHR/"};
const Names kWindow{"GLFW/", "imgui"};
const Names kCommandLine{"CLI/"};
const Names kImport{"assimp/"};

Names together(std::initializer_list<Names> lists) {
  Names all;
  for (const Names& list : lists) all.insert(all.end(), list.begin(), list.end());
  return all;
}

HousePart corePart() {
  return {"core",
          {{{"core/base", "errors, log, progress, random numbers, threads"}},
           {{"core/model", "plain values: mesh, Gauss area, flood record, charts, report"}},
           {{"core/gauss", "Gauss area of vertices, edges and faces"},
            {"core/samples", "models that the program makes itself"}},
           {{"core/flood", "the graph of faces and one t-flood over it"}},
           {{"core/segment/parts", "what the methods share: seeds, shares, balance"}},
           {{"core/segment/borders", "short seams by minimum cuts, tidied borders"}},
           {{"core/segment/rounds", "Lloyd-Max rounds, offsets, when to stop"},
            {"core/segment/creases", "charts that begin between sharp edges"}},
           {{"core/segment/fast", "rounds on a coarse graph, then a band of faces"},
            {"core/segment/growth", "the two methods of the comparison"}},
           {{"core/segment", "every method by name, and t-flooding"}},
           {{"core/charts", "cutting charts until each is a disk, and measuring them"}},
           {{"core/param", "charts laid flat: unwrap, stretch, overlaps"},
            {"core/pack", "charts laid into one texture"},
            {"core/io/text", "words and numbers of text files"}},
           {{"core/io/read", "a reader for each format, and the importing program's caller"},
            {"core/io/write", "a writer for each format, staged beside its target"}},
           {{"core/io", "every format by its ending"}},
           {{"core/session/settings", "the parameter table"}},
           {{"core/session/pipeline", "the stages from mesh to texture, and what is stale"}},
           {{"core/session", "the running program without a window, its worker"}},
           {{"core/session/files", "session files"}}},
          {},
          together({kGl, kWindow, kCommandLine, kImport})};
}

HousePart renderPart() {
  return {"render",
          {{{"render/gl", "OpenGL 3.3 through epoxy: contexts, programs, framebuffers"}},
           {{"render/text", "letters as distance fields"},
            {"render/scene", "cameras, colours, ranges, images: what is drawn, without GL"}},
           {{"render/passes", "surface, lines, points, overlay and texture, drawn"}}},
          {"core/base", "core/model"},
          together({kWindow, kCommandLine, kImport})};
}

HousePart hostPart() {
  return {"host",
          {{{"app/host/script", "actions, keys and lines of script"},
            {"app/host/settings", "what the user likes, and where it is kept"},
            {"app/host/insight", "plots, Gauss sphere, thickness, problems"}},
           {{"app/host/film", "playback of floods, rounds and cuts"},
            {"app/host/files", "exports, session view, recovery copies"}},
           {{"app/host/state", "the state of the viewer"}},
           {{"app/host/actions", "everything that a user can do"}}},
          {"core", "render"},
          together({kGl, kWindow, kCommandLine, kImport})};
}

HousePart guiPart() {
  return {"gui",
          {{{"app/gui/widgets", "sliders, icons, themes, the drawing of Dear ImGui"}},
           {{"app/gui/views", "pictures of the model and of the texture"}},
           {{"app/gui/panels", "menus, sliders, tables, plots, dialogs"}},
           {{"app/gui/tools", "the views' panels and the hand in them"}},
           {{"app/gui", "the window and where everything stands in it"}}},
          {"core", "render", "host"},
          together({kCommandLine, kImport})};
}

}  // namespace

const std::vector<HousePart>& house() {
  static const std::vector<HousePart> parts{
      corePart(),
      renderPart(),
      hostPart(),
      guiPart(),
      {"cli",
       {{{"app/cli", "options, batch runs, what is printed"}}},
       {"core", "render", "host"},
       together({kGl, kWindow, kImport})},
      // A program of its own: what the import library does to it, it does to nothing else.
      {"import",
       {{{"app/import", "the program around the import library"}}},
       {"core"},
       together({kGl, kWindow, kCommandLine})},
      {"main",
       {{{"app", "window or batch"}}},
       {"core", "gui", "cli"},
       together({kGl, kWindow, kCommandLine, kImport})}};
  return parts;
}

std::vector<std::string> foldersOf(const HousePart& part) {
  Names folders;
  for (const Floor& floor : part.floors) {
    for (const RoomInfo& room : floor) folders.push_back(room.folder);
  }
  return folders;
}

std::vector<std::string> borrowedBy(const HousePart& part) {
  Names folders;
  for (const std::string& name : part.mayUse) {
    const auto whole = std::find_if(house().begin(), house().end(),
                                    [&](const HousePart& other) { return other.name == name; });
    if (whole == house().end()) {
      folders.push_back(name);
      continue;
    }
    const Names rooms = foldersOf(*whole);
    folders.insert(folders.end(), rooms.begin(), rooms.end());
  }
  return folders;
}

}  // namespace chartflood
