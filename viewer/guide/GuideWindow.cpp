#include "viewer/guide/GuideWindow.h"

#include <utility>

#include <QFile>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QRegularExpression>
#include <QScrollBar>
#include <QShortcut>
#include <QSplitter>
#include <QTextBlock>
#include <QTextTable>
#include <QToolButton>
#include <QVBoxLayout>

/// Registers the pages, which live in a static library. Q_INIT_RESOURCE works outside namespaces only.
static void registerGuide() { Q_INIT_RESOURCE(guide); }

namespace fenestra::viewer {
namespace {

const QString keysPage = QStringLiteral("keys.md");

}  // namespace

QList<GuidePage> guidePages() {
  registerGuide();
  QFile index(QStringLiteral(":/guide/index.md"));
  if (!index.open(QIODevice::ReadOnly)) return {};
  static const QRegularExpression link(QStringLiteral("\\[([^\\]]+)\\]\\(([a-z-]+\\.md)\\)"));
  QList<GuidePage> pages;
  for (auto found = link.globalMatch(QString::fromUtf8(index.readAll())); found.hasNext();) {
    const QRegularExpressionMatch each = found.next();
    pages << GuidePage{each.captured(2), each.captured(1)};
  }
  return pages;
}

QString anchorOf(const QString& heading) {
  QString anchor;
  for (const QChar each : heading.toLower())
    if (each.isLetterOrNumber() || each == QLatin1Char('-'))
      anchor += each;
    else if (each == QLatin1Char(' '))
      anchor += QLatin1Char('-');
  return anchor;
}

GuideBrowser::GuideBrowser(std::function<QString()> keys, QWidget* parent)
    : QTextBrowser(parent), keys_(std::move(keys)) {
  registerGuide();
  document()->setDocumentMargin(20.0);
  setLineWrapMode(QTextEdit::FixedPixelWidth);
  setLineWrapColumnOrWidth(textWidth + 40);
  setFrameShape(QFrame::NoFrame);
  connect(this, &QTextBrowser::sourceChanged, this, &GuideBrowser::setApart);
}

QVariant GuideBrowser::loadResource(int type, const QUrl& name) {
  if (type == QTextDocument::HtmlResource && name.fileName() == keysPage) return keys_();
  if (type != QTextDocument::ImageResource) return QTextBrowser::loadResource(type, name);
  QImage picture(QLatin1Char(':') + source().resolved(name).path());
  const double ratio = devicePixelRatioF();
  if (picture.width() > textWidth * ratio)
    picture = picture.scaledToWidth(static_cast<int>(textWidth * ratio), Qt::SmoothTransformation);
  // A picture that is narrower than the text keeps its pixels' size on a screen of usual density.
  picture.setDevicePixelRatio(picture.width() > textWidth ? picture.width() / static_cast<double>(textWidth) : 1.0);
  return picture;
}

void GuideBrowser::doSetSource(const QUrl& name, QTextDocument::ResourceType type) {
  const QUrl place = source().isEmpty() ? name : source().resolved(name);
  const bool isKeys = place.fileName() == keysPage;
  QTextBrowser::doSetSource(place, isKeys ? QTextDocument::HtmlResource : type);
  if (place.hasFragment()) scrollToHeading(place.fragment());
}

void GuideBrowser::setApart() {
  constexpr double above = 18.0;
  for (QTextBlock block = document()->begin().next(); block.isValid(); block = block.next())
    if (QTextBlockFormat format = block.blockFormat(); format.headingLevel() > 0 && format.topMargin() < above) {
      format.setTopMargin(above);
      QTextCursor(block).setBlockFormat(format);
    }
  for (QTextFrame* frame : document()->rootFrame()->childFrames())
    if (auto* table = qobject_cast<QTextTable*>(frame); table && table->format().border() > 0.0) {
      QTextTableFormat format = table->format();
      format.setCellPadding(5.0);
      format.setCellSpacing(0.0);
      format.setBorderCollapse(true);
      format.setBorderBrush(palette().light());
      format.setTopMargin(6.0);
      format.setBottomMargin(6.0);
      table->setFormat(format);
    }
}

void GuideBrowser::scrollToHeading(const QString& anchor) {
  for (QTextBlock block = document()->begin(); block.isValid(); block = block.next())
    if (block.blockFormat().headingLevel() > 0 && anchorOf(block.text()) == anchor) {
      setTextCursor(QTextCursor(block));
      verticalScrollBar()->setValue(verticalScrollBar()->value() + cursorRect().top() - 8);
      return;
    }
}

GuideWindow::GuideWindow(std::function<QString()> keys, QWidget* parent)
    : QWidget(parent, Qt::Window),
      text_(new GuideBrowser(std::move(keys))),
      contents_(new QListWidget),
      search_(new QLineEdit),
      notFound_(new QLabel(tr("Not on this page"))) {
  setWindowTitle(tr("User guide of Fenestra"));
  for (const GuidePage& page : guidePages()) {
    auto* entry = new QListWidgetItem(page.title, contents_);
    entry->setData(Qt::UserRole, page.file);
    entry->setSizeHint(QSize(0, fontMetrics().height() + 10));
  }
  contents_->setObjectName(QStringLiteral("contents"));
  contents_->setFrameShape(QFrame::NoFrame);
  auto* halves = new QSplitter;
  halves->addWidget(contents_);
  halves->addWidget(text_);
  halves->setSizes({210, GuideBrowser::textWidth + 70});
  halves->setStretchFactor(1, 1);
  halves->setChildrenCollapsible(false);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(makeBar());
  column->addWidget(halves, 1);

  connect(contents_, &QListWidget::itemClicked, this, [this](const QListWidgetItem* entry) {
    open(entry->data(Qt::UserRole).toString().chopped(3));  // ".md"
  });
  connect(contents_, &QListWidget::itemActivated, contents_, &QListWidget::itemClicked);
  connect(text_, &QTextBrowser::sourceChanged, this, &GuideWindow::showPlace);
  resize(1020, 760);
}

QWidget* GuideWindow::makeBar() {
  auto* bar = new QWidget;
  auto* row = new QHBoxLayout(bar);
  const auto button = [this, row](const QString& text, const QKeySequence& keys, auto does) {
    auto* made = new QToolButton;
    made->setText(text);
    made->setObjectName(QStringLiteral("choice"));
    made->setToolTip(QStringLiteral("%1 (%2)").arg(text, keys.toString(QKeySequence::NativeText)));
    row->addWidget(made);
    connect(made, &QToolButton::clicked, this, does);
    connect(new QShortcut(keys, this), &QShortcut::activated, made, &QToolButton::click);
    return made;
  };
  QToolButton* back = button(tr("Back"), QKeySequence(tr("Alt+Left")), [this] { text_->backward(); });
  QToolButton* forward = button(tr("Forward"), QKeySequence(tr("Alt+Right")), [this] { text_->forward(); });
  row->addStretch();
  row->addWidget(notFound_);
  row->addWidget(search_);
  button(tr("Previous"), QKeySequence(tr("Shift+F3")), [this] { find(QTextDocument::FindBackward); });
  button(tr("Next"), QKeySequence(tr("F3")), [this] { find({}); });

  back->setEnabled(false);
  forward->setEnabled(false);
  connect(text_, &QTextBrowser::backwardAvailable, back, &QWidget::setEnabled);
  connect(text_, &QTextBrowser::forwardAvailable, forward, &QWidget::setEnabled);
  notFound_->hide();
  search_->setPlaceholderText(tr("Find on this page"));
  search_->setToolTip(tr("Return goes to the next place (Ctrl+F)"));
  search_->setClearButtonEnabled(true);
  search_->setFixedWidth(240);
  connect(search_, &QLineEdit::textEdited, this, &GuideWindow::findTyped);
  connect(search_, &QLineEdit::returnPressed, this, [this] { find({}); });
  connect(new QShortcut(QKeySequence::Find, this), &QShortcut::activated, search_, [this] {
    search_->setFocus();
    search_->selectAll();
  });
  connect(new QShortcut(QKeySequence(Qt::Key_Escape), this), &QShortcut::activated, this, &QWidget::close);
  return bar;
}

void GuideWindow::open(const QString& place) {
  QUrl url(QStringLiteral("qrc:/guide/%1.md").arg(place.section(QLatin1Char('#'), 0, 0)));
  if (const QString anchor = place.section(QLatin1Char('#'), 1); !anchor.isEmpty()) url.setFragment(anchor);
  text_->setSource(url);
}

void GuideWindow::find(QTextDocument::FindFlags flags) {
  const QString wanted = search_->text();
  bool found = wanted.isEmpty() || text_->find(wanted, flags);
  if (!found) {
    const QTextCursor before = text_->textCursor();
    text_->moveCursor(flags & QTextDocument::FindBackward ? QTextCursor::End : QTextCursor::Start);
    found = text_->find(wanted, flags);
    if (!found) text_->setTextCursor(before);
  }
  notFound_->setVisible(!found);
}

void GuideWindow::findTyped() {
  QTextCursor from = text_->textCursor();
  from.setPosition(from.selectionStart());
  text_->setTextCursor(from);
  find({});
}

void GuideWindow::showPlace(const QUrl& place) {
  const QString file = place.fileName();
  notFound_->hide();
  for (int row = 0; row < contents_->count(); ++row)
    if (contents_->item(row)->data(Qt::UserRole) == file) contents_->setCurrentRow(row);
}

}  // namespace fenestra::viewer
