#include "viewer/style/Style.h"

#include <QApplication>
#include <QPalette>
#include <QStyleFactory>

/// Registers the icons, which live in a static library. Q_INIT_RESOURCE works outside namespaces only.
static void registerIcons() { Q_INIT_RESOURCE(icons); }

namespace fenestra::viewer {

void applyStyle(QApplication& application) {
  registerIcons();
  application.setWindowIcon(QIcon(QStringLiteral(":/icons/fenestra.svg")));
  application.setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
  const QColor window(38, 41, 46), base(27, 29, 33), raised(52, 56, 63), text(222, 225, 229), dim(128, 133, 140);
  const QColor accent(66, 122, 172);
  QPalette palette;
  palette.setColor(QPalette::Window, window);
  palette.setColor(QPalette::WindowText, text);
  palette.setColor(QPalette::Base, base);
  palette.setColor(QPalette::AlternateBase, QColor(32, 34, 39));
  palette.setColor(QPalette::Text, text);
  palette.setColor(QPalette::PlaceholderText, dim);
  palette.setColor(QPalette::Button, raised);
  palette.setColor(QPalette::ButtonText, text);
  palette.setColor(QPalette::BrightText, Qt::white);
  palette.setColor(QPalette::ToolTipBase, raised);
  palette.setColor(QPalette::ToolTipText, text);
  palette.setColor(QPalette::Highlight, accent);
  palette.setColor(QPalette::HighlightedText, Qt::white);
  palette.setColor(QPalette::Link, QColor(120, 180, 235));
  palette.setColor(QPalette::Light, QColor(72, 77, 85));
  palette.setColor(QPalette::Midlight, QColor(60, 64, 71));
  palette.setColor(QPalette::Mid, QColor(34, 36, 41));
  palette.setColor(QPalette::Dark, QColor(22, 24, 27));
  palette.setColor(QPalette::Shadow, Qt::black);
  for (QPalette::ColorRole role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
    palette.setColor(QPalette::Disabled, role, dim);
  palette.setColor(QPalette::Disabled, QPalette::Highlight, raised);
  application.setPalette(palette);
  application.setStyleSheet(QStringLiteral(R"(
    QToolBar { border: none; border-bottom: 1px solid #17191c; spacing: 2px; padding: 3px 6px; }
    QToolBar QToolButton { padding: 3px 6px; border: 1px solid transparent; border-radius: 3px; }
    QToolBar QToolButton:hover { background: #3c4047; }
    QToolBar QToolButton:checked { background: #2d4d6a; border-color: #427aac; }
    QToolBar QToolButton:pressed { background: #24435e; }
    QDockWidget { font-weight: bold; }
    QDockWidget::title { background: #2d3136; padding: 5px 8px; border-top: 1px solid #17191c; }
    QSplitter::handle { background: #17191c; }
    QSplitter::handle:horizontal { width: 3px; }
    QSplitter::handle:vertical { height: 3px; }
    QDockWidget { titlebar-close-icon: url(:/icons/close.svg); }
    QCheckBox::indicator, QListView::indicator { width: 13px; height: 13px; border: 1px solid #7b828b;
      border-radius: 2px; background: #1b1d21; }
    QCheckBox::indicator:hover, QListView::indicator:hover { border-color: #a9b4c0; }
    QCheckBox::indicator:checked, QListView::indicator:checked { background: #427aac; border-color: #6ea3d2;
      image: url(:/icons/check.svg); }
    QCheckBox::indicator:disabled { border-color: #565c64; }
    QToolButton#choice { background: #343840; border: 1px solid #4a4f57; border-radius: 3px; padding: 3px 4px; }
    QToolButton#choice:hover { background: #3c4047; }
    QToolButton#choice:checked { background: #2d4d6a; border-color: #427aac; }
    QToolButton#choice:disabled { color: #80858c; }
    QToolButton#thumbnail { background: #101215; border: 1px solid #3c4047; border-radius: 3px; }
    QToolButton#thumbnail:hover { border-color: #6ea3d2; }
    QDialogButtonBox { dialogbuttonbox-buttons-have-icons: 0; }
    QStatusBar::item { border: none; }
    QStatusBar QLabel { padding: 0 6px; }
    QToolTip { border: 1px solid #17191c; padding: 3px; }
    QFrame#notice { background: #33373d; border: none; border-left: 4px solid #d8a53c; }
    QFrame#notice[error="true"] { background: #43302f; border-left: 4px solid #d9605a; }
    QFrame#welcome, QLabel#noOpenGl { background: #101215; }
  )"));
}

QIcon icon(const char* name) { return QIcon(QStringLiteral(":/icons/%1.svg").arg(QLatin1String(name))); }

}  // namespace fenestra::viewer
