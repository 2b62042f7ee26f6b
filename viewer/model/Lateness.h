#pragma once
// Whether a view has been behind for longer than a moment: it shows what was asked for before. A shorter wait is no
// news and would only flicker.

#include <QObject>
#include <QTimer>

namespace fenestra::viewer {

class Lateness : public QObject {
  Q_OBJECT
 public:
  static constexpr int milliseconds = 300;

  explicit Lateness(QObject* parent = nullptr);

  /// To be called whenever a view may have fallen behind or caught up.
  void setBehind(bool behind);
  bool isLate() const { return isLate_; }

 Q_SIGNALS:
  void changed();

 private:
  QTimer timer_;
  bool isLate_ = false;
};

}  // namespace fenestra::viewer
