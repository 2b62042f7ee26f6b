#pragma once
// Above the pictures while two studies are open side by side: which side this is, whether it is the one that keys go
// to, and the link between the two. Hidden otherwise.

#include <QWidget>

class QLabel;

namespace fenestra::viewer {

class StudyLink;

class StudyLinkBar : public QWidget {
  Q_OBJECT
 public:
  /// `side` as in StudyLink, which outlives this.
  StudyLinkBar(StudyLink& link, int side, QWidget* parent = nullptr);

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  void showState();
  void showSide();
  QString stateText() const;

  StudyLink& link_;
  const int side_;
  QLabel *name_, *state_;
};

}  // namespace fenestra::viewer
