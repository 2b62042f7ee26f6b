// The Window/level menu's ready windows, by modality, and the user's own.

#include <QAction>
#include <QActionGroup>
#include <QInputDialog>
#include <QMainWindow>

#include "viewer/actions/Actions.h"
#include "viewer/model/WindowPresets.h"
#include "viewer/model/Workspace.h"

namespace fenestra::viewer {

void Actions::addWindowPresets(QMenu& menu) {
  Document& document = targets_.workspace.document;
  QList<QAction*> ct, percentiles, uptakes;
  for (const WindowPreset& preset : ctWindowPresets)
    ct << volumeAction(tr("CT %1  (%2 / %3)").arg(tr(preset.name)).arg(preset.window.width).arg(preset.window.level),
                       preset.key < 0 ? QKeySequence() : QKeySequence(QString::number(preset.key)),
                       [&document, &preset] { document.setWindow(preset.window); });
  for (const PercentilePreset& preset : percentilePresets)
    percentiles << volumeAction(
        tr("%1  (%2 % to %3 % of the values)").arg(tr(preset.name)).arg(preset.low).arg(preset.high), {},
        [&document, &preset] {
          document.setWindow(windowOfPercentiles(*document.scene().volume, 0.01 * preset.low, 0.01 * preset.high));
        });
  for (const double end : petWindowEnds)
    uptakes << volumeAction(tr("SUV 0 to %1").arg(end), {}, [&document, end] { document.setWindow({end, 0.5 * end}); });
  for (const QList<QAction*>& group : {ct, percentiles, uptakes}) menu.addActions(group);
  const auto show = [&document, ct, percentiles, uptakes] {
    const Volume* volume = document.hasVolume() ? document.scene().volume.get() : nullptr;
    const Modality modality = volume ? volume->modality : Modality::CT;
    const bool isOther = modality == Modality::MR || modality == Modality::PT || modality == Modality::US;
    for (QAction* each : ct) each->setVisible(!isOther);
    for (QAction* each : percentiles) each->setVisible(modality != Modality::CT);
    // "GML" is DICOM's word for g/ml, the unit of standardised uptake values.
    for (QAction* each : uptakes) each->setVisible(modality == Modality::PT && volume && volume->unit == "GML");
  };
  connect(&document, &Document::volumeChanged, this, show);
  show();
}

void Actions::addOwnWindows(QMenu& menu) {
  Document& document = targets_.workspace.document;
  Preferences& preferences = targets_.workspace.preferences;
  QMenu* own = menu.addMenu(tr("&My windows"));
  QAction* keep = own->addAction(tr("&Keep this window…"));
  keep->setObjectName(QStringLiteral("keepWindow"));
  keep->setEnabled(false);
  needVolume_ << keep;
  QMenu* forget = own->addMenu(tr("Forget"));
  own->addSeparator();
  auto* shown = new QActionGroup(own);
  shown->setExclusive(false);
  const auto fill = [this, own, forget, shown, &document, &preferences] {
    for (QAction* old : shown->actions() + forget->actions()) {
      needVolume_.removeAll(old);
      old->deleteLater();
    }
    forget->clear();
    const QVariantMap windows = preferences.ownWindows();
    for (auto each = windows.begin(); each != windows.end(); ++each) {
      const QVariantList numbers = each->toList();
      if (numbers.size() != 2) continue;
      const WindowLevel window{numbers[0].toDouble(), numbers[1].toDouble()};
      if (!(window.width > 0.0)) continue;
      const QString name = QString(each.key()).replace(QLatin1Char('&'), QStringLiteral("&&"));
      QAction* entry = shown->addAction(tr("%1  (%2 / %3)").arg(name).arg(window.width).arg(window.level));
      own->addAction(entry);
      needVolume_ << entry;
      entry->setEnabled(document.hasVolume());
      connect(entry, &QAction::triggered, this, [&document, window] { document.setWindow(window); });
      connect(forget->addAction(name), &QAction::triggered, this, [&preferences, key = each.key()] {
        QVariantMap others = preferences.ownWindows();
        others.remove(key);
        preferences.setOwnWindows(others);
      });
    }
    forget->setEnabled(!windows.isEmpty());
  };
  connect(&preferences, &Preferences::ownChanged, this, fill);
  connect(keep, &QAction::triggered, this, [this, &document, &preferences] {
    const QString name = QInputDialog::getText(&targets_.window, tr("Keep this window"), tr("Name")).trimmed();
    if (name.isEmpty()) return;
    QVariantMap windows = preferences.ownWindows();
    windows.insert(name, QVariantList{document.window().width, document.window().level});
    preferences.setOwnWindows(windows);
  });
  fill();
}

}  // namespace fenestra::viewer
