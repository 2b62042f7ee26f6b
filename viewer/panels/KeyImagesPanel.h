#pragma once
// The list of key images, with small pictures: a click goes back to one. Names are edited in place; buttons keep,
// delete and move. While the panel is hidden it holds no picture.

#include <QWidget>

class QListWidget;
class QPushButton;
class QToolButton;

namespace fenestra::viewer {

class Document;
class KeyImages;

class KeyImagesPanel : public QWidget {
  Q_OBJECT
 public:
  /// Both outlive this.
  KeyImagesPanel(const Document& document, KeyImages& images, QWidget* parent = nullptr);

  QListWidget* list() const { return list_; }

 Q_SIGNALS:
  /// The present state is to be kept.
  void keepRequested();

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  void fill();
  void enable();
  void moveBy(int rows);

  const Document& document_;
  KeyImages& images_;
  QListWidget* list_;
  QPushButton *keep_, *delete_;
  QToolButton *up_, *down_;
  bool fills_ = false;
};

}  // namespace fenestra::viewer
