#include "viewer/panels/KeyImagesPanel.h"

#include <algorithm>
#include <utility>

#include <QHBoxLayout>
#include <QListWidget>
#include <QPainter>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include "viewer/model/Document.h"
#include "viewer/model/KeyImages.h"

namespace fenestra::viewer {
namespace {

constexpr QSize keyIconSize(96, 64);  // device-independent pixels

}  // namespace

KeyImagesPanel::KeyImagesPanel(const Document& document, KeyImages& images, QWidget* parent)
    : QWidget(parent),
      document_(document),
      images_(images),
      list_(new QListWidget),
      keep_(new QPushButton(tr("&Keep"))),
      delete_(new QPushButton(tr("&Delete"))),
      up_(new QToolButton),
      down_(new QToolButton) {
  list_->setAccessibleName(tr("Key images"));
  list_->setIconSize(keyIconSize);
  list_->setEditTriggers(QAbstractItemView::EditKeyPressed);
  list_->setTextElideMode(Qt::ElideRight);
  keep_->setToolTip(tr("Keeps the cameras, slices, crosshair, focus and look as they are now"));
  up_->setArrowType(Qt::UpArrow);
  up_->setToolTip(tr("Moves the key image up"));
  down_->setArrowType(Qt::DownArrow);
  down_->setToolTip(tr("Moves the key image down"));
  for (QToolButton* each : {up_, down_}) {
    each->setAccessibleName(each->toolTip());
    each->setFocusPolicy(Qt::TabFocus);
  }
  auto* buttons = new QHBoxLayout;
  for (QWidget* each : std::initializer_list<QWidget*>{keep_, delete_, up_, down_}) buttons->addWidget(each);
  buttons->addStretch();
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(4, 4, 4, 4);
  column->addWidget(list_, 1);
  column->addLayout(buttons);
  const auto goTo = [this](const QListWidgetItem* item) { images_.show(static_cast<std::size_t>(list_->row(item))); };
  connect(list_, &QListWidget::itemClicked, this, goTo);
  connect(list_, &QListWidget::itemActivated, this, goTo);
  connect(list_, &QListWidget::currentRowChanged, this, &KeyImagesPanel::enable);
  // From the event loop: the list is filled anew, and the editor of the name is still being closed.
  connect(list_, &QListWidget::itemChanged, this, [this](QListWidgetItem* item) {
    if (fills_) return;
    QMetaObject::invokeMethod(
        this,
        [this, row = list_->row(item), name = item->text()] {
          if (row >= 0 && row < static_cast<int>(document_.keyImages().size()))
            images_.rename(static_cast<std::size_t>(row), name);
          fill();  // a name that was refused or cut is as it was
        },
        Qt::QueuedConnection);
  });
  connect(keep_, &QPushButton::clicked, this, &KeyImagesPanel::keepRequested);
  connect(delete_, &QPushButton::clicked, this,
          [this] { images_.remove(static_cast<std::size_t>(list_->currentRow())); });
  connect(up_, &QToolButton::clicked, this, [this] { moveBy(-1); });
  connect(down_, &QToolButton::clicked, this, [this] { moveBy(1); });
  connect(&document, &Document::keyImagesChanged, this, &KeyImagesPanel::fill);
  connect(&document, &Document::volumeChanged, this, &KeyImagesPanel::enable);
  enable();
}

void KeyImagesPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  fill();
}

void KeyImagesPanel::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  fills_ = true;
  list_->clear();
  fills_ = false;
}

void KeyImagesPanel::fill() {
  if (!isVisible()) return;
  const int before = list_->count(), chosen = list_->currentRow();
  fills_ = true;
  list_->clear();
  for (const io::KeyImage& image : document_.keyImages()) {
    auto* item = new QListWidgetItem(QString::fromStdString(image.name), list_);
    item->setFlags(item->flags() | Qt::ItemIsEditable);
    item->setToolTip(item->text());
    const QImage picture = KeyImages::pictureOf(image);
    // All icons have one size, so that names stand in a column.
    QPixmap icon(keyIconSize * devicePixelRatio());
    icon.setDevicePixelRatio(devicePixelRatio());
    icon.fill(Qt::transparent);
    if (!picture.isNull()) {
      QPainter painter(&icon);
      const QSizeF size = QSizeF(picture.size()).scaled(keyIconSize, Qt::KeepAspectRatio);
      painter.setRenderHint(QPainter::SmoothPixmapTransform);
      painter.drawImage(
          QRectF(QPointF(0.5 * (keyIconSize.width() - size.width()), 0.5 * (keyIconSize.height() - size.height())),
                 size),
          picture);
    }
    QIcon picked(icon);
    picked.addPixmap(icon, QIcon::Selected);  // or the chosen picture would be tinted
    item->setIcon(picked);
  }
  // One that was added is at the end; otherwise the same place stays chosen.
  const int row = list_->count() > before ? list_->count() - 1 : std::min(chosen, list_->count() - 1);
  list_->setCurrentRow(before == 0 && chosen < 0 && list_->count() > 1 ? -1 : row);
  fills_ = false;
  enable();
}

void KeyImagesPanel::enable() {
  const int row = list_->currentRow();
  keep_->setEnabled(document_.hasVolume());
  delete_->setEnabled(row >= 0);
  up_->setEnabled(row > 0);
  down_->setEnabled(row >= 0 && row + 1 < list_->count());
}

void KeyImagesPanel::moveBy(int rows) {
  const int from = list_->currentRow(), to = from + rows;
  if (from < 0 || to < 0 || to >= list_->count()) return;
  images_.move(static_cast<std::size_t>(from), static_cast<std::size_t>(to));
  list_->setCurrentRow(to);
}

}  // namespace fenestra::viewer
