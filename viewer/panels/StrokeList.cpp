#include "viewer/panels/StrokeList.h"

#include <algorithm>
#include <iterator>

#include <QHBoxLayout>
#include <QItemSelectionModel>
#include <QShortcut>
#include <QVBoxLayout>

#include "io/session/StrokeFile.h"
#include "viewer/model/Document.h"
#include "viewer/model/Paths.h"
#include "viewer/model/WayOutText.h"
#include "viewer/panels/FileDialog.h"
#include "viewer/panels/StrokeModel.h"

namespace fenestra::viewer {

StrokeList::StrokeList(Document& document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      strokes_(new StrokeModel(document, this)),
      list_(new QListView),
      delete_(new QPushButton(tr("Delete"))),
      clear_(new QPushButton(tr("Clear all"))),
      load_(new QPushButton(tr("Load…"))),
      save_(new QPushButton(tr("Save…"))) {
  list_->setModel(strokes_);
  list_->setUniformItemSizes(true);
  list_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  list_->setMinimumHeight(60);
  list_->setToolTip(tr("Tick the strokes to apply"));
  list_->setAccessibleName(tr("Brush strokes"));
  load_->setToolTip(tr("Adds the strokes of a file"));
  auto* buttons = new QHBoxLayout;
  for (QPushButton* button : {delete_, clear_, load_, save_}) buttons->addWidget(button);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(list_, 1);
  column->addLayout(buttons);
  connectButtons();
  enableButtons();
}

void StrokeList::connectButtons() {
  connect(&document_, &Document::strokesChanged, this, &StrokeList::enableButtons);
  connect(list_->selectionModel(), &QItemSelectionModel::selectionChanged, this, &StrokeList::enableButtons);
  connect(delete_, &QPushButton::clicked, this, &StrokeList::deleteSelected);
  connect(new QShortcut(QKeySequence::Delete, list_, nullptr, nullptr, Qt::WidgetShortcut), &QShortcut::activated, this,
          &StrokeList::deleteSelected);
  connect(clear_, &QPushButton::clicked, this, [this] { document_.setStrokes({}, tr("Clear strokes")); });
  connect(load_, &QPushButton::clicked, this, [this] {
    if (const auto file = askForFile(this, {tr("Load brush strokes"), tr("Brush strokes (*.json)")}))
      load(toQString(*file));
  });
  connect(save_, &QPushButton::clicked, this, [this] {
    const FileKind kind{tr("Brush strokes"), QStringLiteral(".json")};
    if (const auto file = askForNewFile(this, tr("Save brush strokes"), {kind})) save(toQString(file->path));
  });
}

void StrokeList::enableButtons() {
  const bool any = !document_.strokes().empty();
  clear_->setEnabled(any);
  save_->setEnabled(any);
  delete_->setEnabled(list_->selectionModel()->hasSelection());
}

void StrokeList::deleteSelected() {
  const QModelIndexList selected = list_->selectionModel()->selectedRows();
  if (selected.isEmpty()) return;
  BrushStrokes kept;
  for (int row = 0; row < strokes_->rowCount(); ++row)
    if (!selected.contains(strokes_->index(row))) kept.push_back(document_.strokes()[static_cast<std::size_t>(row)]);
  document_.setStrokes(std::move(kept), selected.size() == 1 ? tr("Delete stroke") : tr("Delete strokes"));
}

void StrokeList::load(const QString& file) {
  try {
    BrushStrokes strokes = document_.strokes();
    BrushStrokes more = io::readStrokes(toPath(file));
    std::move(more.begin(), more.end(), std::back_inserter(strokes));
    document_.setStrokes(std::move(strokes), tr("Load strokes"));
  } catch (const std::exception& error) {
    Q_EMIT failed(windowText(error));
  }
}

void StrokeList::save(const QString& file) {
  try {
    io::writeStrokes(toPath(file), document_.strokes());
  } catch (const std::exception& error) {
    Q_EMIT failed(windowText(error));
  }
}

}  // namespace fenestra::viewer
