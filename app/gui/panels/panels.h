#pragma once
/// The panels of the window, each in a file of its own name.

#include "app/gui/widgets/ui.h"

namespace chartflood {

class PreviewSource;

/// Menus over the whole width. Call inside a window with a menu bar.
void menuBar(const Ui& ui);
/// Transport, speed, colour mode, picture. Fills the present window.
void toolBar(const Ui& ui);
/// Presets and the parameter table with its sections.
void parameterPanel(const Ui& ui);
/// Colours, overlays, camera.
void viewPanel(const Ui& ui);
/// The strip of rounds and the record of the present flood. Fills the present window.
void timeline(const Ui& ui);
/// State of work, what is under the mouse, figures. Fills the present window.
void statusBar(const Ui& ui);
/// Figures of each chart, sortable.
void chartTable(const Ui& ui);
/// What deserves attention, unfolded by an action, and the button that copies the table.
void problemList(const Ui& ui);
/// Links the row of the chart table that was just submitted: hover and the menu of the right mouse
/// button. Call between its widget and the next cell.
void linkChartRow(const Ui& ui, Index chart);
/// The charts that one can change colours with, as a menu within a menu.
void swapEntries(const Ui& ui, Index chart);
/// What can be done with one chart, as entries of a menu.
void chartEntries(const Ui& ui, Index chart);
/// Normals of the chart pointed at or selected, on the unit sphere, with its figures.
void spherePanel(const Ui& ui);
/// Gauss area and stretch of each chart, values of the colour mode, spread over the rounds.
void plotsPanel(const Ui& ui);
/// The box of presets, the menu of the user's own, and the question for the name of one.
void presetRow(const Ui& ui);
void presetMenu(const Ui& ui);
void presetNameQuestion(const Ui& ui);
/// The search for actions and parameters by words, for the keyboard alone.
void actionPalette(const Ui& ui);
/// What the user likes, in a window of its own.
void preferencesWindow(const Ui& ui);
/// All messages so far, in a window of its own.
void logWindow(const Ui& ui);
/// Keys and what they do, made from the registry, in a window of its own.
void keysWindow(const Ui& ui);
/// What pictures are like, what one would look like, and the button that takes it. Without a source
/// there is no preview.
void pictureDialog(const Ui& ui, PreviewSource* previews);
/// Name, version, paper, fonts.
void aboutWindow(const Ui& ui);
/// Opens the editor of the colours from the bar in the picture, at the bottom right of the area.
void legendPanel(const Ui& ui, ImVec2 areaMin, ImVec2 areaMax);
/// Sentences in the top right corner of the area.
void toasts(const Ui& ui, ImVec2 areaMin, ImVec2 areaMax);
/// The first steps, at the bottom of the area, until a key or click.
void firstStepsCard(const Ui& ui, ImVec2 areaMin, ImVec2 areaMax);
/// The film of the HandleCutter, while there is one; in the 3D view between two corners.
void handleFilmBar(const Ui& ui, ImVec2 low, ImVec2 high);

/// Offers what a crash has left, without holding anything up.
void recoveryCard(const Ui& ui, ImVec2 areaMin, ImVec2 areaMax);
/// Asks, while the state wants it, what to do with unsaved changes.
void unsavedQuestion(const Ui& ui);

}  // namespace chartflood
