#pragma once
// What the mouse does in the views and in the editor of transfer functions, and the keys that only these take: the key
// list shows them beside the keys of the menus. tests/gui/ConventionsTest.cpp performs each entry and each menu key.

#include <array>

#include <QtGlobal>

namespace fenestra::viewer {

struct Gesture {
  const char* where;  ///< the views that it is for
  const char* gesture;
  const char* meaning;
};

inline constexpr auto gestures = std::to_array<Gesture>({
    {QT_TRANSLATE_NOOP("Dialogs", "Slices"), QT_TRANSLATE_NOOP("Dialogs", "Click"),
     QT_TRANSLATE_NOOP("Dialogs", "crosshair; the label there, or the region around the place, becomes the focus")},
    {"Slices", QT_TRANSLATE_NOOP("Dialogs", "Ctrl+click"),
     QT_TRANSLATE_NOOP("Dialogs", "the label joins or leaves the focus")},
    {"Slices", QT_TRANSLATE_NOOP("Dialogs", "Drag"),
     QT_TRANSLATE_NOOP("Dialogs", "window width (across) and level (up and down)")},
    {"Slices", QT_TRANSLATE_NOOP("Dialogs", "Ctrl+double-click"),
     QT_TRANSLATE_NOOP("Dialogs", "window and level of the data")},
    {"Slices", QT_TRANSLATE_NOOP("Dialogs", "Wheel, arrows"), QT_TRANSLATE_NOOP("Dialogs", "next and previous slices")},
    {"Slices", QT_TRANSLATE_NOOP("Dialogs", "Page up, Page down"), QT_TRANSLATE_NOOP("Dialogs", "ten slices")},
    {"Slices", QT_TRANSLATE_NOOP("Dialogs", "Home, End"), QT_TRANSLATE_NOOP("Dialogs", "first and last slice")},
    {QT_TRANSLATE_NOOP("Dialogs", "Measures, on the slices"), QT_TRANSLATE_NOOP("Dialogs", "Drag, or clicks"),
     QT_TRANSLATE_NOOP("Dialogs", "draw the measure whose tool is chosen; Esc ends it")},
    {"Measures, on the slices", QT_TRANSLATE_NOOP("Dialogs", "Drag a handle or line"),
     QT_TRANSLATE_NOOP("Dialogs", "move the end, or the measure")},
    {"Measures, on the slices", QT_TRANSLATE_NOOP("Dialogs", "Right click on it"),
     QT_TRANSLATE_NOOP("Dialogs", "copy and delete")},
    {QT_TRANSLATE_NOOP("Dialogs", "Clipping, while its tab is in sight"), QT_TRANSLATE_NOOP("Dialogs", "Drag a square"),
     QT_TRANSLATE_NOOP("Dialogs", "move a face of the box, or a plane")},
    {"Clipping, while its tab is in sight", QT_TRANSLATE_NOOP("Dialogs", "Drag the ball at an arrow"),
     QT_TRANSLATE_NOOP("Dialogs", "tilt the plane")},
    {QT_TRANSLATE_NOOP("Dialogs", "Walls of slices, in the 3-D views"), QT_TRANSLATE_NOOP("Dialogs", "Drag a square"),
     QT_TRANSLATE_NOOP("Dialogs", "move the slice of that colour")},
    {QT_TRANSLATE_NOOP("Dialogs", "3-D views"), QT_TRANSLATE_NOOP("Dialogs", "Drag, arrows"),
     QT_TRANSLATE_NOOP("Dialogs", "rotate; the linked view follows")},
    {"3-D views", QT_TRANSLATE_NOOP("Dialogs", "Click"),
     QT_TRANSLATE_NOOP("Dialogs", "crosshair to what is seen there; its label or region becomes the focus")},
    {"3-D views", QT_TRANSLATE_NOOP("Dialogs", "Ctrl+click"),
     QT_TRANSLATE_NOOP("Dialogs", "its label joins or leaves the focus")},
    {"3-D views", QT_TRANSLATE_NOOP("Dialogs", "Shift+drag"),
     QT_TRANSLATE_NOOP("Dialogs", "move the picture; on the body only while clicks choose no focus (Focus menu)")},
    {"3-D views", QT_TRANSLATE_NOOP("Dialogs", "Wheel"), QT_TRANSLATE_NOOP("Dialogs", "zoom")},
    {QT_TRANSLATE_NOOP("Dialogs", "A grown region, in all views"), QT_TRANSLATE_NOOP("Dialogs", "Shift+click"),
     QT_TRANSLATE_NOOP("Dialogs", "add what is there to the region")},
    {"A grown region, in all views", QT_TRANSLATE_NOOP("Dialogs", "Ctrl+click"),
     QT_TRANSLATE_NOOP("Dialogs", "take what is there away from the region")},
    {"A grown region, in all views", QT_TRANSLATE_NOOP("Dialogs", "Shift+drag"),
     QT_TRANSLATE_NOOP("Dialogs", "draw a ball around a structure: the region that grows there stays within it")},
    {"A grown region, in all views", QT_TRANSLATE_NOOP("Dialogs", "Alt+wheel"),
     QT_TRANSLATE_NOOP("Dialogs", "tolerance")},
    {QT_TRANSLATE_NOOP("Dialogs", "Painting the region, in all views"), QT_TRANSLATE_NOOP("Dialogs", "Drag"),
     QT_TRANSLATE_NOOP("Dialogs", "add what the ball passes over")},
    {"Painting the region, in all views", QT_TRANSLATE_NOOP("Dialogs", "Shift+drag"),
     QT_TRANSLATE_NOOP("Dialogs", "take it away")},
    {QT_TRANSLATE_NOOP("Dialogs", "Brush, in the 3-D views"), QT_TRANSLATE_NOOP("Dialogs", "Drag"),
     QT_TRANSLATE_NOOP("Dialogs", "paint")},
    {"Brush, in the 3-D views", QT_TRANSLATE_NOOP("Dialogs", "Ctrl+drag"), QT_TRANSLATE_NOOP("Dialogs", "rotate")},
    {"Brush, in the 3-D views", QT_TRANSLATE_NOOP("Dialogs", "Shift+wheel, Shift+drag"),
     QT_TRANSLATE_NOOP("Dialogs", "depth, or by how much the context's edges change")},
    {QT_TRANSLATE_NOOP("Dialogs", "Carving, in all views"), QT_TRANSLATE_NOOP("Dialogs", "Drag"),
     QT_TRANSLATE_NOOP("Dialogs", "remove what lies along it, once the button is let go")},
    {"Carving, in all views", QT_TRANSLATE_NOOP("Dialogs", "Shift+drag"),
     QT_TRANSLATE_NOOP("Dialogs", "bend the plane that was laid last")},
    {"Carving, in all views", QT_TRANSLATE_NOOP("Dialogs", "Ctrl+drag"), QT_TRANSLATE_NOOP("Dialogs", "rotate")},
    {QT_TRANSLATE_NOOP("Dialogs", "A transfer function"),
     QT_TRANSLATE_NOOP("Dialogs", "Drag a point, or a trapezoid's edge, top or inside"),
     QT_TRANSLATE_NOOP("Dialogs", "move it; with Shift across or up and down alone; Esc takes it back")},
    {"A transfer function", QT_TRANSLATE_NOOP("Dialogs", "Double-click"),
     QT_TRANSLATE_NOOP("Dialogs", "add a point, or choose the colour of the point there")},
    {"A transfer function", QT_TRANSLATE_NOOP("Dialogs", "Right click"),
     QT_TRANSLATE_NOOP("Dialogs", "colour, delete, and add a point or a trapezoid")},
    {"A transfer function", QT_TRANSLATE_NOOP("Dialogs", "Wheel, middle drag"),
     QT_TRANSLATE_NOOP("Dialogs", "enlarge the values, and move along them")},
    {"A transfer function", QT_TRANSLATE_NOOP("Dialogs", "Arrows"),
     QT_TRANSLATE_NOOP("Dialogs", "move the point; with Shift ten times as far, with Alt its whole trapezoid")},
    {"A transfer function", QT_TRANSLATE_NOOP("Dialogs", "Page up, Page down, Home, End"),
     QT_TRANSLATE_NOOP("Dialogs", "choose another point")},
    {"A transfer function", QT_TRANSLATE_NOOP("Dialogs", "Ins, Del, Return"),
     QT_TRANSLATE_NOOP("Dialogs", "add a point, delete the point, choose its colour")},
    {QT_TRANSLATE_NOOP("Dialogs", "All views"), QT_TRANSLATE_NOOP("Dialogs", "Middle drag"),
     QT_TRANSLATE_NOOP("Dialogs", "move the picture")},
    {"All views", QT_TRANSLATE_NOOP("Dialogs", "Right drag, Ctrl+wheel"), QT_TRANSLATE_NOOP("Dialogs", "zoom")},
    {"All views", QT_TRANSLATE_NOOP("Dialogs", "Right click"), QT_TRANSLATE_NOOP("Dialogs", "a menu for that place")},
    {"All views", QT_TRANSLATE_NOOP("Dialogs", "Shift+move"),
     QT_TRANSLATE_NOOP("Dialogs", "crosshair follows the mouse")},
    {"All views", QT_TRANSLATE_NOOP("Dialogs", "Double-click"),
     QT_TRANSLATE_NOOP("Dialogs", "show this view alone; Esc shows all")},
});

}  // namespace fenestra::viewer
