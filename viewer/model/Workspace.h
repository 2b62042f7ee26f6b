#pragma once
// The models of one window: the open study, and how it is viewed and edited.

#include "viewer/model/ActiveTool.h"
#include "viewer/model/Brush.h"
#include "viewer/model/Carving.h"
#include "viewer/model/Document.h"
#include "viewer/model/KeyImages.h"
#include "viewer/model/LookLibrary.h"
#include "viewer/model/MeasureMode.h"
#include "viewer/model/PathCameras.h"
#include "viewer/model/PathMode.h"
#include "viewer/model/PathOpening.h"
#include "viewer/model/PlacementController.h"
#include "viewer/model/Preferences.h"
#include "viewer/model/RegionBall.h"
#include "viewer/model/SelectionBrush.h"
#include "viewer/model/SliceCursor.h"
#include "viewer/model/SlicePlanes.h"
#include "viewer/model/ViewLink.h"
#include "viewer/model/ViewOptions.h"

namespace fenestra::viewer {

struct Workspace {
  explicit Workspace(Preferences::Mode mode = Preferences::Mode::Stored) : preferences(mode) {}

  Document document;
  SliceCursor cursor;
  ViewLink cameras;
  SlicePlanes planes{document, cursor, cameras};
  PlacementController placement{document, cameras};
  ViewOptions options;
  Brush brush;
  Carving carving{document};
  KeyImages keyImages{{document, cursor, planes, cameras, placement}};
  SelectionBrush selection;
  RegionBall ball;
  ActiveTool tool{{&brush, &carving, &selection}};
  MeasureMode measuring{document};
  PathMode path{document, cursor, measuring, tool};
  PathCameras pathCameras{{document, path, cameras, options}};
  PathOpening pathOpening{document};
  Preferences preferences;
  LookLibrary looks{preferences.looksFolder()};
};

}  // namespace fenestra::viewer
