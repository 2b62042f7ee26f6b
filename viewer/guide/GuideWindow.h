#pragma once
// The window of the user guide: a list of pages, the page, a search in it, and the way back. Pages are Markdown files
// of resources/guide; the page of keys is made from the menus and the list of gestures.

#include <functional>

#include <QTextBrowser>
#include <QWidget>

class QLabel;
class QLineEdit;
class QListWidget;

namespace fenestra::viewer {

/// A page of the guide, as its index lists it.
struct GuidePage {
  QString file;   ///< such as "focus.md"
  QString title;  ///< its title in the index
};
/// All pages, in the order in which they are read.
QList<GuidePage> guidePages();

/// The name of a heading in links: in lower case, with hyphens for spaces and without other signs, as GitHub names it.
QString anchorOf(const QString& heading);

/// Shows pages. Pictures are made as wide as the text at most, in the pixels of the screen.
class GuideBrowser : public QTextBrowser {
  Q_OBJECT
 public:
  /// `keys` makes the list of keys, as HTML.
  explicit GuideBrowser(std::function<QString()> keys, QWidget* parent = nullptr);

  QVariant loadResource(int type, const QUrl& name) override;
  /// Device-independent pixels of a line of text.
  static constexpr int textWidth = 720;

 protected:
  void doSetSource(const QUrl& name, QTextDocument::ResourceType type) override;

 private:
  /// Markdown leaves headings as near to the text before as to their own, and cells of tables without a margin.
  void setApart();
  void scrollToHeading(const QString& anchor);

  std::function<QString()> keys_;
};

class GuideWindow : public QWidget {
  Q_OBJECT
 public:
  explicit GuideWindow(std::function<QString()> keys, QWidget* parent = nullptr);

  /// A page without its ending, with a heading in it after a #: "opening#clipping".
  void open(const QString& place);
  GuideBrowser& text() { return *text_; }

 private:
  QWidget* makeBar();
  /// Selects the next place where the text is found; goes on at the other end of the page.
  void find(QTextDocument::FindFlags flags);
  /// As find(), after the text has changed: the selected place stays as long as it fits.
  void findTyped();
  void showPlace(const QUrl& place);

  GuideBrowser* text_;
  QListWidget* contents_;
  QLineEdit* search_;
  QLabel* notFound_;
};

}  // namespace fenestra::viewer
