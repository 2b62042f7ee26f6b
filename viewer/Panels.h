#pragma once
// The panels, in docks beside the views.

class QDockWidget;
class QMainWindow;

namespace fenestra::viewer {

class AppearancePanel;
class BrushPanel;
class CamerasPanel;
class ClippingPanel;
class ContextLayerPanel;
class CutawayPanel;
class DockFolding;
class DockHeights;
class FocusPanel;
class KeyImagesPanel;
class LabelTable;
class ReformatPanel;
class SeriesPanel;
class TagsPanel;
struct Workspace;

/// The window owns them.
struct Panels {
  FocusPanel* focus;
  AppearancePanel* appearance;
  CutawayPanel* cutaway;
  ContextLayerPanel* contextLayer;
  CamerasPanel* cameras;
  BrushPanel* brush;
  ClippingPanel* clipping;
  SeriesPanel* series;
  TagsPanel* tags;
  LabelTable* labelTable;
  KeyImagesPanel* keyImages;
  ReformatPanel* reformat;
  DockHeights* heights;
  QDockWidget* seriesDock;
  DockFolding* folding;
};

/// Makes the panels and docks them in the window: the lists of series, DICOM tags, labels and key images and the curved
/// reformat on the left, where each is hidden until it is asked for, all others on the right.
Panels makePanels(QMainWindow& window, Workspace& workspace);

}  // namespace fenestra::viewer
