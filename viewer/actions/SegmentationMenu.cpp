#include "viewer/actions/SegmentationMenu.h"

#include <QCoreApplication>
#include <QMenu>

#include "viewer/jobs/StudyLoader.h"
#include "viewer/model/Paths.h"

namespace fenestra::viewer {

QString titleOf(const io::SegmentationInfo& segmentation, SegmentationTitle kind) {
  constexpr std::size_t few = 3;
  QStringList structures;
  for (std::size_t i = 0; i < std::min(few, segmentation.structures.size()); ++i)
    structures << QString::fromStdString(segmentation.structures[i]);
  QString list = structures.join(QStringLiteral(", "));
  if (segmentation.structures.size() > few)
    list = QCoreApplication::translate("SegmentationMenu", "%1 and %n more", nullptr,
                                       static_cast<int>(segmentation.structures.size() - few))
               .arg(list);
  const QString format = QString::fromStdString(segmentation.kind);
  if (kind == SegmentationTitle::Nameless) return QStringLiteral("%1: %2").arg(format, list);
  const QString name = segmentation.description.empty() ? toQString(segmentation.file.filename())
                                                        : QString::fromStdString(segmentation.description);
  return QStringLiteral("%1 (%2): %3").arg(name, format, list);
}

void fillSegmentationMenu(QMenu& menu, const std::vector<io::SegmentationInfo>& segmentations, SegmentationTitle kind,
                          StudyLoader& loader) {
  menu.clear();
  for (const io::SegmentationInfo& segmentation : segmentations) {
    QString title = titleOf(segmentation, kind);
    title.replace(QLatin1Char('&'), QStringLiteral("&&"));
    QObject::connect(menu.addAction(title), &QAction::triggered, &loader,
                     [&loader, file = segmentation.file] { loader.openLabels(file); });
  }
}

}  // namespace fenestra::viewer
