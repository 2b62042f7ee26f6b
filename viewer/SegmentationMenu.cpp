#include "viewer/SegmentationMenu.h"

#include <QCoreApplication>
#include <QMenu>

#include "viewer/jobs/StudyLoader.h"
#include "viewer/model/Paths.h"

namespace fenestra::viewer {

QString titleOf(const io::SegmentationInfo& segmentation) {
  const QString name = segmentation.description.empty() ? toQString(segmentation.file.filename())
                                                        : QString::fromStdString(segmentation.description);
  constexpr std::size_t few = 3;
  QStringList structures;
  for (std::size_t i = 0; i < std::min(few, segmentation.structures.size()); ++i)
    structures << QString::fromStdString(segmentation.structures[i]);
  QString list = structures.join(QStringLiteral(", "));
  if (segmentation.structures.size() > few)
    list = QCoreApplication::translate("SegmentationMenu", "%1 and %2 more")
               .arg(list)
               .arg(segmentation.structures.size() - few);
  return QStringLiteral("%1 (%2): %3").arg(name, QString::fromStdString(segmentation.kind), list);
}

void fillSegmentationMenu(QMenu& menu, const std::vector<io::SegmentationInfo>& segmentations, StudyLoader& loader) {
  menu.clear();
  for (const io::SegmentationInfo& segmentation : segmentations) {
    QString title = titleOf(segmentation);
    title.replace(QLatin1Char('&'), QStringLiteral("&&"));
    QObject::connect(menu.addAction(title), &QAction::triggered, &loader,
                     [&loader, file = segmentation.file] { loader.openLabels(file); });
  }
}

}  // namespace fenestra::viewer
