#include "viewer/bars/StudyLinkBar.h"

#include <QAccessible>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QToolButton>

#include "viewer/model/NumberText.h"
#include "viewer/model/StudyLink.h"

namespace fenestra::viewer {

StudyLinkBar::StudyLinkBar(StudyLink& link, int side, QWidget* parent)
    : QWidget(parent), link_(link), side_(side), name_(new QLabel), state_(new QLabel) {
  setObjectName(QStringLiteral("studyLinkBar"));
  const auto button = [](const QString& name, const QString& toolTip) {
    auto* made = new QToolButton;
    made->setText(name);
    made->setToolTip(toolTip);
    made->setFocusPolicy(Qt::TabFocus);
    return made;
  };
  QToolButton* linked = button(tr("Link"), tr("The crosshair, scrolling, zoom and turning of one study go along with "
                                              "those of the other, by patient position"));
  linked->setObjectName(QStringLiteral("linkStudies"));
  linked->setCheckable(true);
  QToolButton* match =
      button(tr("Match points"), tr("The crosshairs of both studies mark the same point: link the studies by it"));
  match->setObjectName(QStringLiteral("matchPoints"));
  QToolButton* forget = button(tr("Reset"), tr("Forget the pair of points: the same coordinates are the same point"));
  forget->setObjectName(QStringLiteral("forgetPair"));
  forget->setAccessibleName(forget->toolTip());
  // A long text must not make the window wider.
  state_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(6, 2, 6, 4);
  row->addWidget(name_);
  row->addWidget(linked);
  row->addWidget(match);
  row->addWidget(forget);
  row->addWidget(state_, 1);
  connect(linked, &QToolButton::clicked, this, [this](bool on) { link_.setLinked(on, side_); });
  connect(match, &QToolButton::clicked, &link, &StudyLink::match);
  connect(forget, &QToolButton::clicked, this, [this] { link_.forgetPair(side_); });
  connect(&link, &StudyLink::changed, this, [this, linked, match, forget] {
    linked->setChecked(link_.isLinked());
    match->setEnabled(!link_.isLinked());
    forget->setVisible(link_.isMatched());
    showState();
  });
  hide();
}

QString StudyLinkBar::stateText() const {
  if (!link_.isLinked()) return tr("not linked");
  if (link_.beyond() > 0.0) return tr("%1 mm apart, where a study ends").arg(numberText(link_.beyond(), 1));
  if (!link_.isMatched()) return tr("linked by patient position");
  const glm::dvec3 offset = side_ == 0 ? link_.offset() : -link_.offset();
  return tr("linked, offset %1, %2, %3 mm")
      .arg(numberText(offset.x, 1), numberText(offset.y, 1), numberText(offset.z, 1));
}

void StudyLinkBar::showState() {
  state_->setText(stateText());
  state_->setToolTip(link_.isLinked() ? tr("Offset of the other study to the patient's left, posterior and superior")
                                      : QString());
  showSide();
  setVisible(link_.isCompared());
}

void StudyLinkBar::showSide() {
  const bool active = isActiveWindow();
  QFont font = name_->font();
  font.setBold(active);
  name_->setFont(font);
  const QString side = side_ == 0 ? tr("Left study") : tr("Right study");
  name_->setText(active ? tr("%1, active").arg(side) : side);
  setAccessibleName(QStringLiteral("%1, %2").arg(name_->text(), state_->text()));
  if (link_.isCompared()) {
    QAccessibleEvent named(this, QAccessible::NameChanged);
    QAccessible::updateAccessibility(&named);
  }
  update();
}

bool StudyLinkBar::event(QEvent* event) {
  if (event->type() == QEvent::ActivationChange) showSide();
  return QWidget::event(event);
}

void StudyLinkBar::paintEvent(QPaintEvent*) {
  constexpr int thickness = 3;  // device-independent pixels
  QPainter painter(this);
  if (isActiveWindow()) painter.fillRect(0, height() - thickness, width(), thickness, palette().highlight());
}

}  // namespace fenestra::viewer
