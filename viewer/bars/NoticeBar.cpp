#include "viewer/bars/NoticeBar.h"

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

/// A notice's texts, as properties of its label.
constexpr const char *withNamesKey = "withNames", *withoutNamesKey = "withoutNames";

/// A clause as a sentence.
QString sentence(const std::string& clause) {
  QString text = QString::fromStdString(clause);
  if (text.isEmpty()) return text;
  text[0] = text[0].toUpper();
  return text.endsWith(QLatin1Char('.')) ? text : text + QLatin1Char('.');
}

QString namesOf(const std::vector<std::filesystem::path>& files) {
  QStringList names;
  for (const std::filesystem::path& file : files) names << toQString(file);
  return names.join(QLatin1Char('\n'));
}

void showDetails(QWidget* window, const QString& title, const QString& text, const QString& details) {
  QMessageBox box(QMessageBox::Information, title, text, QMessageBox::Close, window);
  box.setDetailedText(details);
  box.exec();
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
  unfold_->setText(tr("%n more", nullptr, count - few));
  setVisible(count > 0);
}

void NoticeBar::add(Kind kind, const QString& text, const std::vector<Action>& actions, const QString& withoutNames) {
  if (texts().contains(text)) return;
  auto* frame = new QFrame;
  frame->setObjectName(QStringLiteral("notice"));
  frame->setProperty("error", kind == Kind::Error);
  auto* label = new QLabel(hidesNames_ && !withoutNames.isEmpty() ? withoutNames : text);
  label->setProperty(withNamesKey, text);
  label->setProperty(withoutNamesKey, withoutNames);
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
  for (const Action& action : actions) {
    auto* button = new QPushButton(action.name);
    connect(button, &QPushButton::clicked, this, action.run);
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

void NoticeBar::hideNames(bool hide) {
  hidesNames_ = hide;
  for (int row = 0; row < rows_->count(); ++row) {
    auto* label = rows_->itemAt(row)->widget()->findChild<QLabel*>();
    const QString without = label->property(withoutNamesKey).toString();
    label->setText(hide && !without.isEmpty() ? without : label->property(withNamesKey).toString());
  }
}

void NoticeBar::addWarnings(const std::vector<io::Warning>& warnings) {
  for (const io::Warning& warning : warnings) {
    const QString text = sentence(warning.text);
    if (warning.files.empty()) {
      add(Kind::Warning, text);
      continue;
    }
    add(Kind::Warning, text, {{tr("Files…"), [this, text, files = namesOf(warning.files)] {
                                 showDetails(window(), tr("Files concerned"), text, files);
                               }}});
  }
}

void NoticeBar::addGeometry(const io::GeometryReport& report, const std::function<void(io::Regularise)>& choose) {
  QStringList texts, details;
  for (const io::Warning& finding : report.findings) {
    texts << sentence(finding.text);
    if (!finding.files.empty()) details << texts.back() + QLatin1Char('\n') + namesOf(finding.files);
  }
  const QString all = texts.join(QLatin1Char(' '));
  const QString figures = tr("Slices scanned: %1, %2 mm apart for the most part\nPlanes shown: %3, %4 mm apart\n"
                             "Farthest from its place as shown: %5 mm; with the slices spread evenly: %6 mm\n"
                             "Planes in wide gaps: %7\nVoxels outside of what was scanned: %8")
                              .arg(report.slices)
                              .arg(report.scannedStep, 0, 'f', 3)
                              .arg(report.planes)
                              .arg(report.step, 0, 'f', 3)
                              .arg(report.displacement, 0, 'f', 3)
                              .arg(report.displacementAsIs, 0, 'f', 3)
                              .arg(report.interpolatedPlanes.size())
                              .arg(report.emptyVoxels);
  std::vector<Action> actions{
      {tr("Report…"), [this, all, text = (QStringList(figures) + details).join(QStringLiteral("\n\n"))] {
         showDetails(window(), tr("Geometry report"), all, text);
       }}};
  const auto offer = [&](const QString& name, io::Regularise choice) {
    actions.push_back({name, [choose, choice] { choose(choice); }});
  };
  if (report.applied != io::Regularise::Off)
    offer(tr("Load as is"), io::Regularise::Off);
  else if (report.displacement > io::GeometryReport::tolerance)
    offer(tr("Regularise"), io::Regularise::Automatic);
  if (report.sheared) offer(tr("Make straight"), io::Regularise::Linear);
  add(Kind::Warning, all, actions);
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
