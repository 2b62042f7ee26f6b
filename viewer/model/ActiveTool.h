#pragma once
// Which stroke mode has the left button in the views. It makes them exclusive: activating one deactivates the others.

#include <vector>

#include <QObject>

namespace fenestra::viewer {

class StrokeMode;

class ActiveTool : public QObject {
  Q_OBJECT
 public:
  /// All modes of a window; they outlive this.
  explicit ActiveTool(std::vector<StrokeMode*> modes, QObject* parent = nullptr);

  /// Null while the left button does what it usually does.
  StrokeMode* mode() const;
  /// Deactivates the active mode. False when none was active.
  bool putDown();

 Q_SIGNALS:
  /// A mode has changed, see StrokeMode::changed().
  void changed();

 private:
  std::vector<StrokeMode*> modes_;
};

}  // namespace fenestra::viewer
