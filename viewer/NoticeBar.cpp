#include "viewer/NoticeBar.h"

#include <QFrame>
#include <QHBoxLayout>
#include <QIcon>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

namespace fenestra::viewer {

NoticeBar::NoticeBar(QWidget* parent) : QWidget(parent), rows_(new QVBoxLayout(this)) {
  rows_->setContentsMargins(0, 0, 0, 0);
  rows_->setSpacing(1);
  hide();
}

void NoticeBar::add(Kind kind, const QString& text, const QString& actionName, std::function<void()> action) {
  if (texts().contains(text)) return;
  auto* frame = new QFrame;
  frame->setObjectName(QStringLiteral("notice"));
  frame->setProperty("error", kind == Kind::Error);
  auto* label = new QLabel(text);
  label->setWordWrap(true);
  label->setTextFormat(Qt::PlainText);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  auto* close = new QToolButton;
  close->setAutoRaise(true);
  close->setIcon(QIcon(QStringLiteral(":/icons/close.svg")));
  close->setToolTip(tr("Dismiss"));
  auto* row = new QHBoxLayout(frame);
  row->setContentsMargins(8, 5, 6, 5);
  row->addWidget(label, 1);
  if (action) {
    auto* button = new QPushButton(actionName);
    connect(button, &QPushButton::clicked, this, std::move(action));
    row->addWidget(button);
  }
  row->addWidget(close);
  connect(close, &QToolButton::clicked, this, [this, frame] {
    rows_->removeWidget(frame);
    frame->deleteLater();
    setVisible(rows_->count() > 0);
  });
  rows_->addWidget(frame);
  show();
}

void NoticeBar::clear() {
  while (QLayoutItem* item = rows_->takeAt(0)) {
    item->widget()->deleteLater();
    delete item;
  }
  hide();
}

QStringList NoticeBar::texts() const {
  QStringList texts;
  for (int row = 0; row < rows_->count(); ++row)
    texts << rows_->itemAt(row)->widget()->findChild<QLabel*>()->text();
  return texts;
}

}  // namespace fenestra::viewer
