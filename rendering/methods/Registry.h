#pragma once
// The list of all methods. What knows of them goes through it: sessions, the command line, the window, tests, the
// guide's test and the pages that compare methods. A new method is its folder, its header here and its name in the
// list.

#include "rendering/methods/adaptive/Adaptive.h"
#include "rendering/methods/bend/Bend.h"
#include "rendering/methods/clearview/ClearView.h"
#include "rendering/methods/cone/Cone.h"
#include "rendering/methods/context-preserving/ContextPreserving.h"
#include "rendering/methods/explode/Explode.h"
#include "rendering/methods/focal-region/FocalRegion.h"
#include "rendering/methods/importance/Importance.h"
#include "rendering/methods/mip/Mip.h"
#include "rendering/methods/peel/Peel.h"
#include "rendering/methods/sculpt/Sculpt.h"
#include "rendering/methods/selection/Selection.h"
#include "rendering/methods/walls/Walls.h"

namespace fenestra {

template <class... M>
struct MethodTypes {};

/// In the order in which files, --help and the window show them. The first is the method of a new study.
using Methods = MethodTypes<methods::Adaptive, methods::Cone, methods::Importance, methods::ClearView,
                            methods::ContextPreserving, methods::FocalRegion, methods::Walls, methods::Explode,
                            methods::Sculpt, methods::Bend, methods::Selection, methods::Peel, methods::Mip>;

}  // namespace fenestra
