#include "viewer/NoticeBar.h"

#include <QFrame>
#include <QHBoxLayout>
#include <QIcon>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include "viewer/model/Paths.h"

namespace fenestra::viewer {
namespace {

/// A clause as a sentence.
QString sentence(const std::string& clause) {
  QString text = QString::fromStdString(clause);
  if (text.isEmpty()) return text;
  text[0] = text[0].toUpper();
  return text.endsWith(QLatin1Char('.')) ? text : text + QLatin1Char('.');
}

}  // namespace

NoticeBar::NoticeBar(QWidget* parent) : QWidget(parent), rows_(new QVBoxLayout), unfold_(new QPushButton) {
  unfold_->setFlat(true);
  rows_->setSpacing(1);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(1);
  column->addLayout(rows_);
  column->addWidget(unfold_);
  connect(unfold_, &QPushButton::clicked, this, [this] {
    unfolded_ = true;
    fold();
  });
  fold();
}

void NoticeBar::fold() {
  constexpr int few = 3;
  const int count = rows_->count();
  for (int row = 0; row < count; ++row) rows_->itemAt(row)->widget()->setVisible(unfolded_ || row < few);
  unfold_->setVisible(!unfolded_ && count > few);
  unfold_->setText(tr("%1 more").arg(count - few));
  setVisible(count > 0);
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
    fold();
  });
  rows_->addWidget(frame);
  fold();
}

void NoticeBar::addWarnings(const std::vector<io::Warning>& warnings) {
  for (const io::Warning& warning : warnings) {
    const QString text = sentence(warning.text);
    if (warning.files.empty()) {
      add(Kind::Warning, text);
      continue;
    }
    QStringList files;
    for (const std::filesystem::path& file : warning.files) files << toQString(file);
    add(Kind::Warning, text, tr("Files…"), [this, text, files] {
      QMessageBox box(QMessageBox::Information, tr("Files concerned"), text, QMessageBox::Close, window());
      box.setDetailedText(files.join(QLatin1Char('\n')));
      box.exec();
    });
  }
}

void NoticeBar::clear() {
  while (QLayoutItem* item = rows_->takeAt(0)) {
    item->widget()->deleteLater();
    delete item;
  }
  unfolded_ = false;
  fold();
}

QStringList NoticeBar::texts() const {
  QStringList texts;
  for (int row = 0; row < rows_->count(); ++row) texts << rows_->itemAt(row)->widget()->findChild<QLabel*>()->text();
  return texts;
}

}  // namespace fenestra::viewer
