#include "viewer/style/Style.h"

#include <utility>

#include <QApplication>
#include <QIconEngine>
#include <QPainter>
#include <QPalette>
#include <QStyleFactory>

#include "viewer/style/AccessibleNames.h"

/// Registers the icons, which live in a static library. Q_INIT_RESOURCE works outside namespaces only.
static void registerIcons() { Q_INIT_RESOURCE(icons); }

namespace fenestra::viewer {
namespace {

struct Colours {
  const char *window, *base, *alternate, *raised, *text, *hint, *dim, *link;  ///< `dim` is for what is switched off
  const char *light, *midlight, *mid, *dark;                                  ///< edges of buttons and frames
  const char *line, *title;                                                   ///< between panels; behind their titles
  const char *hover, *pressed, *chosen, *accent, *accentEdge;
  const char *control, *controlEdge, *controlHover, *controlDisabled;  ///< check boxes
  const char *notice, *error, *well;                                   ///< `well` surrounds pictures
  const char* closeIcon;
};

constexpr Colours darkColours{.window = "#26292e",
                              .base = "#1b1d21",
                              .alternate = "#202227",
                              .raised = "#34383f",
                              .text = "#dee1e5",
                              .hint = "#9aa1a9",
                              .dim = "#80858c",
                              .link = "#78b4eb",
                              .light = "#484d55",
                              .midlight = "#3c4047",
                              .mid = "#222429",
                              .dark = "#16181b",
                              .line = "#17191c",
                              .title = "#2d3136",
                              .hover = "#3c4047",
                              .pressed = "#24435e",
                              .chosen = "#2d4d6a",
                              .accent = "#427aac",
                              .accentEdge = "#6ea3d2",
                              .control = "#1b1d21",
                              .controlEdge = "#7b828b",
                              .controlHover = "#a9b4c0",
                              .controlDisabled = "#565c64",
                              .notice = "#33373d",
                              .error = "#43302f",
                              .well = "#101215",
                              .closeIcon = "close"};
constexpr Colours lightColours{.window = "#eceef0",
                               .base = "#ffffff",
                               .alternate = "#f5f6f7",
                               .raised = "#e1e4e7",
                               .text = "#1d2125",
                               .hint = "#646a71",
                               .dim = "#7d838a",
                               .link = "#1a5c94",
                               .light = "#ffffff",
                               .midlight = "#f2f3f4",
                               .mid = "#b9bec4",
                               .dark = "#9aa0a7",
                               .line = "#c3c8cd",
                               .title = "#dfe2e5",
                               .hover = "#d6dade",
                               .pressed = "#a9cbe8",
                               .chosen = "#c3dcf1",
                               .accent = "#427aac",
                               .accentEdge = "#427aac",
                               .control = "#ffffff",
                               .controlEdge = "#6c737b",
                               .controlHover = "#30353a",
                               .controlDisabled = "#b4b9be",
                               .notice = "#fbf4e0",
                               .error = "#fbe5e3",
                               .well = "#f5f6f7",
                               .closeIcon = "close-on-light"};

QPalette paletteOf(const Colours& colours) {
  QPalette palette;
  const auto set = [&](QPalette::ColorRole role, const char* colour) {
    palette.setColor(role, QColor(QLatin1String(colour)));
  };
  set(QPalette::Window, colours.window);
  set(QPalette::WindowText, colours.text);
  set(QPalette::Base, colours.base);
  set(QPalette::AlternateBase, colours.alternate);
  set(QPalette::Text, colours.text);
  set(QPalette::PlaceholderText, colours.hint);
  set(QPalette::Button, colours.raised);
  set(QPalette::ButtonText, colours.text);
  set(QPalette::BrightText, "#ffffff");
  set(QPalette::ToolTipBase, colours.raised);
  set(QPalette::ToolTipText, colours.text);
  set(QPalette::Highlight, colours.accent);
  set(QPalette::HighlightedText, "#ffffff");
  set(QPalette::Link, colours.link);
  set(QPalette::Light, colours.light);
  set(QPalette::Midlight, colours.midlight);
  set(QPalette::Mid, colours.mid);
  set(QPalette::Dark, colours.dark);
  set(QPalette::Shadow, "#000000");
  for (const QPalette::ColorRole role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
    palette.setColor(QPalette::Disabled, role, QColor(QLatin1String(colours.dim)));
  palette.setColor(QPalette::Disabled, QPalette::Highlight, QColor(QLatin1String(colours.raised)));
  return palette;
}

/// Names of colours follow an @.
QString styleSheetOf(const Colours& colours) {
  QString sheet = QStringLiteral(R"(
    QToolBar { border: none; border-bottom: 1px solid @line; spacing: 2px; padding: 3px 6px; }
    QToolBar QToolButton { padding: 3px 6px; border: 1px solid transparent; border-radius: 3px; }
    QToolBar QToolButton:hover { background: @hover; }
    QToolBar QToolButton:checked { background: @chosen; border-color: @accent; }
    QToolBar QToolButton:pressed { background: @pressed; }
    QDockWidget { font-weight: bold; titlebar-close-icon: url(:/icons/@closeIcon.svg); }
    QDockWidget::title { background: @title; padding: 5px 8px; border-top: 1px solid @line; }
    QSplitter::handle { background: @line; }
    QSplitter::handle:horizontal { width: 3px; } QSplitter::handle:vertical { height: 3px; }
    QCheckBox::indicator, QTreeView::indicator, QListView::indicator { width: 13px; height: 13px;
      border: 1px solid @controlEdge; border-radius: 2px; background: @controlFace; }
    QCheckBox::indicator:hover, QTreeView::indicator:hover, QListView::indicator:hover {
      border-color: @controlHover; }
    QCheckBox::indicator:checked, QTreeView::indicator:checked, QListView::indicator:checked { background: @accent;
      border-color: @brightAccent; image: url(:/icons/check.svg); }
    QCheckBox::indicator:disabled { border-color: @controlDisabled; }
    QToolButton#choice, QToolButton#linkStudies { background: @raised; border: 1px solid @edge; border-radius: 3px;
      padding: 3px 4px; }
    QToolButton#choice:hover, QToolButton#linkStudies:hover { background: @hover; }
    QToolButton#choice:checked, QToolButton#linkStudies:checked { background: @chosen; border-color: @accent; }
    QToolButton#choice:disabled { color: @dim; }
    QToolButton#thumbnail { background: @well; border: 1px solid @hover; border-radius: 3px; }
    QToolButton#thumbnail:hover { border-color: @brightAccent; }
    QDialogButtonBox { dialogbuttonbox-buttons-have-icons: 0; }
    QStatusBar::item { border: none; }
    QStatusBar QLabel { padding: 0 6px; }
    QToolTip { border: 1px solid @line; padding: 3px; }
    QFrame#notice { background: @notice; border: none; border-left: 4px solid #d8a53c; }
    QFrame#notice[error="true"] { background: @error; border-left: 4px solid #d9605a; }
    QFrame#welcome, QWidget#welcomeBody, QLabel#noOpenGl { background: @well; }
    QListWidget#contents { padding: 8px; }
    QFrame#card { background: @window; border: 1px solid @line; border-radius: 6px; }
    QFrame#welcome QPushButton#recent { text-align: left; color: @link; padding: 3px 0; }
    QFrame#welcome QPushButton#recent:hover { text-decoration: underline; }
  )");
  for (const auto& [name, colour] : {std::pair{"line", colours.line},
                                     {"link", colours.link},
                                     {"window", colours.window},
                                     {"hover", colours.hover},
                                     {"chosen", colours.chosen},
                                     {"accent", colours.accent},
                                     {"brightAccent", colours.accentEdge},
                                     {"pressed", colours.pressed},
                                     {"closeIcon", colours.closeIcon},
                                     {"title", colours.title},
                                     {"controlEdge", colours.controlEdge},
                                     {"controlFace", colours.control},
                                     {"controlHover", colours.controlHover},
                                     {"controlDisabled", colours.controlDisabled},
                                     {"raised", colours.raised},
                                     {"edge", colours.mid},
                                     {"dim", colours.dim},
                                     {"well", colours.well},
                                     {"notice", colours.notice},
                                     {"error", colours.error}})
    sheet.replace(QLatin1Char('@') + QLatin1String(name), QLatin1String(colour));
  return sheet;
}

/// Draws a picture of one colour in the colour of the program's text, whichever theme it has.
class TextColouredIcon : public QIconEngine {
 public:
  explicit TextColouredIcon(const QString& file) : source_(file) {}

  void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override {
    const qreal ratio = painter->device()->devicePixelRatioF();
    painter->drawPixmap(rect, coloured(rect.size() * ratio, mode));
  }
  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State) override { return coloured(size, mode); }
  QIconEngine* clone() const override { return new TextColouredIcon(*this); }

 private:
  /// `size` in device pixels.
  QPixmap coloured(const QSize& size, QIcon::Mode mode) const {
    QPixmap picture = source_.pixmap(size, 1.0);
    const auto group = mode == QIcon::Disabled ? QPalette::Disabled : QPalette::Active;
    QPainter painter(&picture);
    painter.setCompositionMode(QPainter::CompositionMode_SourceIn);
    painter.fillRect(picture.rect(), QApplication::palette().color(group, QPalette::WindowText));
    return picture;
  }

  QIcon source_;
};

}  // namespace

void applyStyle(QApplication& application, Theme theme) {
  registerIcons();
  application.setWindowIcon(QIcon(QStringLiteral(":/icons/fenestra.svg")));
  // Once, before any style sheet: in Qt 6.4, setting a style while a sheet is active can make the next sheet crash.
  if (application.styleSheet().isEmpty()) {
    application.setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
    nameControls();
  }
  const Colours& colours = theme == Theme::Dark ? darkColours : lightColours;
  application.setPalette(paletteOf(colours));
  application.setStyleSheet(styleSheetOf(colours));
}

std::vector<TextColours> textColours(Theme theme) {
  const Colours& of = theme == Theme::Dark ? darkColours : lightColours;
  std::vector<TextColours> pairs;
  const auto add = [&](const char* where, const char* text, const char* ground) {
    pairs.push_back({where, QColor(QLatin1String(text)), QColor(QLatin1String(ground))});
  };
  add("panels", of.text, of.window);
  add("fields and lists", of.text, of.base);
  add("every other row", of.text, of.alternate);
  add("buttons", of.text, of.raised);
  add("titles of panels", of.text, of.title);
  add("under the mouse", of.text, of.hover);
  add("pressed", of.text, of.pressed);
  add("chosen", of.text, of.chosen);
  add("notices", of.text, of.notice);
  add("errors", of.text, of.error);
  add("first page", of.text, of.well);
  add("hints in empty fields", of.hint, of.base);
  add("links", of.link, of.window);
  add("links of the first page", of.link, of.well);
  add("selection", "#ffffff", of.accent);
  return pairs;
}

QIcon icon(const char* name) {
  return QIcon(new TextColouredIcon(QStringLiteral(":/icons/%1.svg").arg(QLatin1String(name))));
}

}  // namespace fenestra::viewer
