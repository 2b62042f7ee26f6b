#pragma once
// The guided tour: moves the mouse through the first minute on a built-in phantom, and explains each step.
// The user guide's page on the first minute has the same steps.

#include <functional>
#include <optional>

#include <QFrame>
#include <QPointer>
#include <QTimer>

class QLabel;
class QPushButton;

namespace fenestra::viewer {

class ViewArea;
struct Workspace;

class Tour : public QFrame {
  Q_OBJECT
 public:
  /// Name of the phantom that the steps fit.
  static constexpr const char* phantom = "torso";

  /// `workspace` and `views` outlive this.
  Tour(Workspace& workspace, ViewArea& views, QWidget* parent = nullptr);

  /// `open` begins to read the torso phantom, and is false where the user wants to keep what is open. Without it there
  /// is no tour.
  void setPhantom(std::function<bool()> open);
  bool canStart() const { return phantom_ != nullptr; }

  /// Opens the phantom, and begins once the window shows it. Another study ends the tour.
  void start();
  /// To be called when the window shows a study, and when reading has ended without one.
  void studyOpened();
  void openingEnded();
  /// Does the next step; after the last one ends the tour.
  void next();
  void end();

  /// The present step, from 0; empty while there is no tour.
  std::optional<int> step() const { return step_; }
  int steps() const;
  /// The mouse is doing something.
  bool isActing() const { return !moves_.isEmpty(); }
  /// On by default. Off: the mouse jumps to where it acts.
  void setAnimated(bool on) { animated_ = on; }
  /// Performs a step without showing the bar. Needs the phantom.
  void perform(int step);

 Q_SIGNALS:
  void canStartChanged(bool can);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  struct Step {
    QString title, text;
    void (Tour::*act)();  ///< may be null
  };
  /// One action of the mouse: it goes to a place in a widget, and then `act` is called.
  struct Move {
    QPointer<QWidget> widget;
    QPointF at;
    std::function<void()> act;
    int milliseconds;
  };
  QList<Step> allSteps() const;
  void show(int step);
  void chooseKidney();
  void turn();
  void widen();
  void paint();
  void add(QWidget* widget, QPointF at, std::function<void()> act, int milliseconds);
  /// Presses the left button at the first place, moves along the others and releases it at the last.
  void addDrag(QWidget* widget, const QList<QPointF>& path);
  void send(QWidget* widget, int type, QPointF at, bool pressed);
  void doNext();

  Workspace& workspace_;
  ViewArea& views_;
  std::function<bool()> phantom_;
  QLabel *title_, *text_;
  QPushButton *next_, *end_;
  QWidget* pointer_;  ///< shows where the mouse is; a child of the window while there is a tour
  QTimer timer_;
  QList<Move> moves_;
  std::optional<int> step_;
  bool opens_ = false;  ///< the phantom is being read for the tour
  bool animated_ = true;
};

}  // namespace fenestra::viewer
