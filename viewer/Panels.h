#pragma once
// The panels, in docks to the right of the views.

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
  DockHeights* heights;
  DockFolding* folding;
};

/// Makes the panels and docks them in the window.
Panels makePanels(QMainWindow& window, Workspace& workspace);

}  // namespace fenestra::viewer
