#pragma once
// The mark of a view that still shows the focus before a region.

#include <QString>

#include "viewer/model/Document.h"

namespace fenestra::viewer {

/// What a view says of the region in focus while it shows another focus; empty where it need not.
inline QString regionMark(const Document& document) {
  if (document.asksToOpen()) return Document::tr("The focus before still shows, until you open to the region");
  if (document.awaitsGrowth() && !document.showsGrowth())
    return Document::tr("Growing the region; the focus before still shows");
  return document.awaitsGrowth() ? Document::tr("Growing the region; this is a first part") : QString();
}

}  // namespace fenestra::viewer
