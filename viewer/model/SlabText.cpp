#include "viewer/model/SlabText.h"

#include <QCoreApplication>

namespace fenestra::viewer {
namespace {

struct SlabWords {
  Q_DECLARE_TR_FUNCTIONS(Slab)
};

}  // namespace

QString nameOf(SlabMode mode) {
  return mode == SlabMode::Maximum   ? SlabWords::tr("MIP")
         : mode == SlabMode::Minimum ? SlabWords::tr("MinIP")
                                     : SlabWords::tr("Mean");
}

QString slabText(const Slab& slab) {
  return SlabWords::tr("%1 %2 mm").arg(nameOf(slab.mode), QString::number(slab.thickness, 'g', 3));
}

}  // namespace fenestra::viewer
