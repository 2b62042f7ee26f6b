#include "viewer/archive/RetrievalList.h"

#include <algorithm>
#include <cmath>

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QToolButton>
#include <QVBoxLayout>

#include "viewer/archive/Retrievals.h"

namespace fenestra::viewer {
namespace {

using State = Retrievals::State;

/// What the button of a retrieval does; empty: nothing now.
QString actOf(State state) {
  switch (state) {
    case State::Waiting:
    case State::Running:
      return RetrievalRow::tr("Pause");
    case State::Paused:
      return RetrievalRow::tr("Go on");
    case State::Failed:
      return RetrievalRow::tr("Retry");
    case State::Done:
      return RetrievalRow::tr("Open");
    case State::Stopping:
      break;
  }
  return {};
}

QString stateText(const Retrievals::Item& item) {
  switch (item.state) {
    case State::Waiting:
      return RetrievalRow::tr("Waits for others");
    case State::Running:
      return item.message;
    case State::Stopping:
      return RetrievalRow::tr("Stops…");
    case State::Paused:
      return RetrievalRow::tr("Paused; what came is kept");
    case State::Failed:
      return item.message;
    case State::Done:
      return RetrievalRow::tr("Whole");
  }
  return {};
}

}  // namespace

RetrievalRow::RetrievalRow(Retrievals& retrievals, int id, QWidget* parent)
    : QWidget(parent), retrievals_(retrievals), id_(id) {
  title_ = new QLabel;
  title_->setTextFormat(Qt::PlainText);
  title_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  state_ = new QLabel;
  state_->setObjectName(QStringLiteral("retrievalState"));
  state_->setTextFormat(Qt::PlainText);
  state_->setWordWrap(true);
  progress_ = new QProgressBar;
  progress_->setRange(0, 1000);
  progress_->setTextVisible(false);
  progress_->setMaximumHeight(6);
  act_ = new QToolButton;
  act_->setObjectName(QStringLiteral("retrievalAct"));
  remove_ = new QToolButton;
  remove_->setObjectName(QStringLiteral("retrievalRemove"));
  remove_->setText(QStringLiteral("✕"));
  remove_->setToolTip(tr("Cancels it, and takes it out of the list. What came stays in the cache"));
  connect(act_, &QToolButton::clicked, this, &RetrievalRow::act);
  // From the event loop: the row goes with its button.
  connect(
      remove_, &QToolButton::clicked, &retrievals_, [this] { retrievals_.remove(id_); }, Qt::QueuedConnection);

  auto* texts = new QVBoxLayout;
  texts->setSpacing(2);
  texts->addWidget(title_);
  texts->addWidget(progress_);
  texts->addWidget(state_);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(4, 4, 4, 4);
  row->addLayout(texts, 1);
  row->addWidget(act_, 0, Qt::AlignTop);
  row->addWidget(remove_, 0, Qt::AlignTop);
}

void RetrievalRow::act() {
  const Retrievals::Item* item = retrievals_.find(id_);
  if (!item) return;
  if (item->state == State::Done)
    Q_EMIT openRequested(id_);
  else if (item->state == State::Paused || item->state == State::Failed)
    retrievals_.resume(id_);
  else
    retrievals_.pause(id_);
}

void RetrievalRow::follow(bool hidesPatient) {
  const Retrievals::Item* item = retrievals_.find(id_);
  if (!item) return;
  const QString title = hidesPatient ? tr("Retrieval %1").arg(id_) : item->order.title;
  title_->setText(title);
  title_->setToolTip(title);
  state_->setText(stateText(*item));
  progress_->setValue(static_cast<int>(std::lround(1000.0 * item->fraction)));
  progress_->setVisible(item->state != State::Done && item->state != State::Failed);
  const QString act = actOf(item->state);
  act_->setText(act.isEmpty() ? tr("Pause") : act);
  act_->setEnabled(!act.isEmpty());
}

RetrievalList::RetrievalList(Retrievals& retrievals, QWidget* parent) : QScrollArea(parent), retrievals_(retrievals) {
  auto* body = new QWidget;
  column_ = new QVBoxLayout(body);
  column_->setContentsMargins(0, 0, 0, 0);
  column_->setSpacing(0);
  column_->addStretch();
  setWidget(body);
  setWidgetResizable(true);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  connect(&retrievals_, &Retrievals::listChanged, this, &RetrievalList::fill);
  connect(&retrievals_, &Retrievals::changed, this, &RetrievalList::follow);
  fill();
}

void RetrievalList::setHidesPatient(bool hides) {
  hidesPatient_ = hides;
  for (RetrievalRow* row : rows_) row->follow(hidesPatient_);
}

QSize RetrievalList::sizeHint() const { return {320, 150}; }
QSize RetrievalList::minimumSizeHint() const { return {120, 60}; }

void RetrievalList::fill() {
  QList<RetrievalRow*> rows;
  for (const auto& item : retrievals_.items()) {
    if (item->removes) continue;
    const auto at = std::find_if(rows_.begin(), rows_.end(), [&](const auto* row) { return row->id() == item->id; });
    if (at != rows_.end()) {
      rows << *at;
      continue;
    }
    auto* row = new RetrievalRow(retrievals_, item->id);
    connect(row, &RetrievalRow::openRequested, this, &RetrievalList::openRequested);
    row->follow(hidesPatient_);
    // The latest first, above what is seen already.
    column_->insertWidget(0, row);
    rows << row;
  }
  for (RetrievalRow* row : rows_)
    if (!rows.contains(row)) {
      row->hide();
      row->deleteLater();
    }
  rows_ = rows;
  setVisible(!rows_.isEmpty());
}

void RetrievalList::follow(int id) {
  for (RetrievalRow* row : rows_)
    if (row->id() == id) row->follow(hidesPatient_);
}

}  // namespace fenestra::viewer
