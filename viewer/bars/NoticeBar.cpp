#include "viewer/bars/NoticeBar.h"

#include <QFrame>
#include <QHBoxLayout>
#include <QIcon>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include "viewer/bars/StudyDialogs.h"
#include "viewer/model/Paths.h"
#include "viewer/model/WayOutText.h"
#include "viewer/style/Style.h"

namespace fenestra::viewer {
namespace {

/// A notice's texts, as properties of its label; what it is, as properties of its row.
constexpr const char *withNamesKey = "withNames", *withoutNamesKey = "withoutNames";
constexpr const char *kindKey = "kind", *subjectKey = "subject";

NoticeBar::Kind kindOf(const QWidget& row) { return static_cast<NoticeBar::Kind>(row.property(kindKey).toInt()); }
NoticeBar::Subject subjectOf(const QWidget& row) {
  return static_cast<NoticeBar::Subject>(row.property(subjectKey).toInt());
}

/// A clause as a sentence.
QString sentence(QString text) {
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
  markAsStudyDialog(box);
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

QWidget* NoticeBar::rowAt(int index) const { return rows_->itemAt(index)->widget(); }

void NoticeBar::fold() {
  constexpr int few = 3;
  const int count = rows_->count();
  int hidden = 0;
  for (int row = 0; row < count; ++row) {
    const bool shows = unfolded_ || row < few || kindOf(*rowAt(row)) == Kind::Error;
    rowAt(row)->setVisible(shows);
    hidden += shows ? 0 : 1;
  }
  unfold_->setVisible(hidden > 0);
  unfold_->setText(tr("%n more", nullptr, hidden));
  setVisible(count > 0);
}

void NoticeBar::remove(const std::function<bool(const QWidget& row)>& goes) {
  for (int row = rows_->count() - 1; row >= 0; --row) {
    QWidget* widget = rowAt(row);
    if (!goes(*widget)) continue;
    rows_->removeWidget(widget);
    widget->hide();
    widget->deleteLater();  // one of its buttons may have been pressed
  }
  if (rows_->count() == 0) unfolded_ = false;
  fold();
}

void NoticeBar::add(Kind kind, Subject subject, const QString& text, const std::vector<Action>& actions,
                    const QString& withoutNames) {
  remove([&](const QWidget& row) {
    return row.findChild<QLabel*>()->property(withNamesKey).toString() == text && kindOf(row) == kind;
  });
  auto* frame = new QFrame;
  frame->setObjectName(QStringLiteral("notice"));
  frame->setProperty("error", kind == Kind::Error);
  frame->setProperty(kindKey, static_cast<int>(kind));
  frame->setProperty(subjectKey, static_cast<int>(subject));
  auto* label = new QLabel(hidesNames_ && !withoutNames.isEmpty() ? withoutNames : text);
  label->setProperty(withNamesKey, text);
  label->setProperty(withoutNamesKey, withoutNames);
  label->setWordWrap(true);
  label->setTextFormat(Qt::PlainText);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  auto* close = new QToolButton;
  close->setAutoRaise(true);
  close->setIcon(icon("close"));
  close->setToolTip(tr("Dismiss"));
  auto* row = new QHBoxLayout(frame);
  row->setContentsMargins(8, 5, 6, 5);
  row->addWidget(label, 1);
  for (const Action& action : actions) {
    auto* button = new QPushButton(action.name);
    connect(button, &QPushButton::clicked, this, action.run);
    if (action.takes)
      connect(button, &QPushButton::clicked, this,
              [this, frame] { remove([frame](const QWidget& each) { return &each == frame; }); });
    row->addWidget(button);
  }
  row->addWidget(close);
  connect(close, &QToolButton::clicked, this,
          [this, frame] { remove([frame](const QWidget& each) { return &each == frame; }); });
  int place = 0;
  while (place < rows_->count() && kindOf(*rowAt(place)) > kind) ++place;
  rows_->insertWidget(place, frame);
  fold();
}

void NoticeBar::end(Subject subject) {
  remove([&](const QWidget& row) { return subjectOf(row) == subject && kindOf(row) != Kind::Warning; });
}

void NoticeBar::forgetStudy() {
  remove([](const QWidget& row) { return subjectOf(row) < Subject::Looks; });
}

void NoticeBar::hideNames(bool hide) {
  hidesNames_ = hide;
  for (int row = 0; row < rows_->count(); ++row) {
    auto* label = rowAt(row)->findChild<QLabel*>();
    const QString without = label->property(withoutNamesKey).toString();
    label->setText(hide && !without.isEmpty() ? without : label->property(withNamesKey).toString());
  }
}

void NoticeBar::addWarnings(const std::vector<io::Warning>& warnings) {
  for (auto each = warnings.rbegin(); each != warnings.rend(); ++each) {
    const io::Warning& warning = *each;
    const QString text = sentence(windowText(warning));
    if (warning.files.empty()) {
      add(Kind::Warning, Subject::Study, text);
      continue;
    }
    add(Kind::Warning, Subject::Study, text, {{tr("Files…"), [this, text, files = namesOf(warning.files)] {
                                                 showDetails(window(), tr("Files concerned"), text, files);
                                               }}});
  }
}

void NoticeBar::addGeometry(const io::GeometryReport& report, const std::function<void(io::Regularise)>& choose) {
  QStringList texts, details;
  for (const io::Warning& finding : report.findings) {
    texts << sentence(windowText(finding));
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
  add(Kind::Warning, Subject::Study, all, actions);
}

QStringList NoticeBar::texts() const {
  QStringList texts;
  for (int row = 0; row < rows_->count(); ++row) texts << rowAt(row)->findChild<QLabel*>()->text();
  return texts;
}

}  // namespace fenestra::viewer
