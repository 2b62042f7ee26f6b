#include "viewer/guide/WelcomePage.h"

#include <QAction>
#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include "io/base/SessionName.h"
#include "viewer/files/FileOpener.h"
#include "viewer/guide/Tour.h"
#include "viewer/model/Paths.h"
#include "viewer/model/Workspace.h"
#include "viewer/style/Style.h"

namespace fenestra::viewer {
namespace {

/// Device-independent pixels of the page, and of a path on it.
constexpr int widest = 980, longestRecent = 440;
/// Narrower pages have no room for three cards beside each other in a language of long words.
constexpr int leastForCards = 720;

/// A text of several lines, which may be as narrow as a few words; QLabel asks for more.
class Paragraph : public QLabel {
 public:
  explicit Paragraph(const QString& text) : QLabel(text) { setWordWrap(true); }
  QSize minimumSizeHint() const override { return {fontMetrics().averageCharWidth() * 20, fontMetrics().height()}; }
};

QLabel* wrapped(const QString& text) { return new Paragraph(text); }

QLabel* larger(const QString& text, double factor) {
  auto* label = new Paragraph(text);
  QFont font = label->font();
  font.setPointSizeF(font.pointSizeF() * factor);
  font.setBold(factor < 2.0);
  label->setFont(font);
  return label;
}

/// The device that draws the 3-D views.
QString hardwareText(const GlSupport& gl) {
  if (!gl.available) return WelcomePage::tr("3-D views are not available here; slices work. %1").arg(gl.problem);
  if (gl.software)
    return WelcomePage::tr(
               "No graphics card was found: the processor draws the 3-D views, in smaller pictures while "
               "something moves. (%1)")
        .arg(gl.renderer);
  return WelcomePage::tr("The graphics card draws the 3-D views. (%1)").arg(gl.renderer);
}

}  // namespace

WelcomePage::WelcomePage(FileOpener& files, Workspace& workspace, Tour& tour, const GlSupport& gl, QWidget* parent)
    : QFrame(parent),
      files_(files),
      workspace_(workspace),
      cards_(nullptr),
      samples_(nullptr),
      recent_(new QVBoxLayout),
      recentTitle_(nullptr),
      body_(nullptr) {
  setObjectName(QStringLiteral("welcome"));
  auto* page = new QWidget;
  page->setObjectName(QStringLiteral("welcomeBody"));
  page->setMaximumWidth(widest);
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(24, 20, 24, 20);
  column->setSpacing(14);
  column->addStretch(1);
  column->addWidget(larger(QStringLiteral("Fenestra"), 2.2));
  column->addWidget(
      wrapped(tr("Choose a structure in a CT or MR, and the tissue in front of it opens. "
                 "<b>Not for diagnostic use.</b>")));
  column->addWidget(makeCards(files, tour));
  recentTitle_ = larger(tr("Opened last"), 1.1);
  column->addWidget(recentTitle_);
  recent_->setSpacing(2);
  column->addLayout(recent_);
  QLabel* hardware = wrapped(hardwareText(gl));
  hardware->setObjectName(QStringLiteral("hardware"));
  hardware->setTextFormat(Qt::PlainText);
  column->addSpacing(4);
  column->addWidget(hardware);
  auto* guide = new QLabel(QStringLiteral("<a href=\"guide\">%1</a>").arg(tr("User guide (F1)")));
  guide->setObjectName(QStringLiteral("guide"));
  connect(guide, &QLabel::linkActivated, this, &WelcomePage::guideRequested);
  column->addWidget(guide);
  column->addStretch(2);

  auto* centred = new QWidget;
  centred->setObjectName(QStringLiteral("welcomeBody"));
  auto* row = new QHBoxLayout(centred);
  row->setContentsMargins(0, 0, 0, 0);
  row->addStretch(1);
  row->addWidget(page, 1000);
  row->addStretch(1);
  auto* scroller = new QScrollArea;
  scroller->setFrameShape(QFrame::NoFrame);
  scroller->setFocusPolicy(Qt::NoFocus);
  scroller->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroller->setWidgetResizable(true);
  scroller->setWidget(centred);
  auto* whole = new QVBoxLayout(this);
  whole->setContentsMargins(0, 0, 0, 0);
  whole->addWidget(scroller);
  body_ = scroller;

  showRecent();
  connect(&workspace.options, &ViewOptions::changed, this, &WelcomePage::showRecent);
  connect(&workspace.preferences, &Preferences::changed, this, &WelcomePage::showRecent);
}

QFrame* WelcomePage::makeCard(const char* iconName, const QString& title, const QString& text, QVBoxLayout*& buttons) {
  auto* card = new QFrame;
  card->setObjectName(QStringLiteral("card"));
  auto* column = new QVBoxLayout(card);
  column->setContentsMargins(16, 14, 16, 14);
  column->setSpacing(8);
  auto* top = new QHBoxLayout;
  auto* picture = new QLabel;
  picture->setPixmap(icon(iconName).pixmap(QSize(22, 22), devicePixelRatioF()));
  top->addWidget(picture);
  top->addWidget(larger(title, 1.2), 1);
  column->addLayout(top);
  column->addWidget(wrapped(text));
  column->addStretch();
  buttons = new QVBoxLayout;
  buttons->setSpacing(6);
  column->addLayout(buttons);
  return card;
}

QWidget* WelcomePage::makeCards(FileOpener& files, Tour& tour) {
  QVBoxLayout *touring = nullptr, *own = nullptr;
  auto* cards = new QWidget;
  cards_ = new QBoxLayout(QBoxLayout::LeftToRight, cards);
  cards_->setContentsMargins(0, 0, 0, 0);
  cards_->setSpacing(12);
  cards_->addWidget(makeCard("labels", tr("Built-in phantoms"),
                             tr("Bodies made of simple shapes, with every structure labelled. Nobody's data: try "
                                "everything on them."),
                             samples_),
                    1);
  cards_->addWidget(
      makeCard("place", tr("Guided tour"),
               tr("Clicks through the first minute on the torso phantom, and says at each step what it does."),
               touring),
      1);
  cards_->addWidget(
      makeCard("folder", tr("Your own data"),
               tr("Drop a folder of DICOM files, or a NIfTI, NRRD or MetaImage file, anywhere in this window."), own),
      1);
  auto* start = new QPushButton(tr("Start the tour"));
  start->setObjectName(QStringLiteral("startTour"));
  start->setEnabled(tour.canStart());
  connect(&tour, &Tour::canStartChanged, start, &QWidget::setEnabled);
  connect(start, &QPushButton::clicked, &tour, &Tour::start);
  touring->addWidget(start);
  auto* folder = new QPushButton(icon("folder"), tr("Open a folder…"));
  auto* file = new QPushButton(icon("file"), tr("Open a file…"));
  connect(folder, &QPushButton::clicked, &files, &FileOpener::chooseFolder);
  connect(file, &QPushButton::clicked, &files, &FileOpener::chooseFile);
  own->addWidget(folder);
  own->addWidget(file);
  return cards;
}

void WelcomePage::resizeEvent(QResizeEvent* event) {
  QFrame::resizeEvent(event);
  cards_->setDirection(width() < leastForCards ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
}

void WelcomePage::addSample(QAction& opens) {
  auto* button = new QPushButton(opens.text());
  connect(button, &QPushButton::clicked, &opens, &QAction::trigger);
  samples_->addWidget(button);
}

void WelcomePage::showRecent() {
  while (QLayoutItem* row = recent_->takeAt(0)) {
    delete row->widget();
    delete row;
  }
  const std::vector<std::filesystem::path> paths = workspace_.preferences.recent();
  recentTitle_->setVisible(!paths.empty());
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const QString path = toQString(paths[i]);
    const QFileInfo file(path);
    const QString kind = io::isSession(paths[i]) ? tr("session") : tr("study");
    // A folder or file is often named after its patient.
    const QString text =
        workspace_.options.hidesPatient()
            ? tr("%1 %2, name hidden").arg(kind).arg(i + 1)
            : QStringLiteral("%1  ·  %2  ·  %3").arg(file.fileName(), kind, QDir::toNativeSeparators(file.path()));
    auto* button = new QPushButton;
    button->setText(button->fontMetrics().elidedText(text, Qt::ElideMiddle, longestRecent));
    button->setObjectName(QStringLiteral("recent"));
    button->setFlat(true);
    button->setCursor(Qt::PointingHandCursor);
    connect(
        button, &QPushButton::clicked, &files_, [this, path = paths[i]] { files_.open({path}); },
        Qt::QueuedConnection);  // opening changes the list, which deletes the button
    recent_->addWidget(button, 0, Qt::AlignLeft);
  }
}

}  // namespace fenestra::viewer
