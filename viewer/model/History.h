#pragma once
// What was done, step by step, to undo and redo it: a QUndoStack whose memory is bounded by bytes instead of steps.

#include <cstddef>
#include <memory>

#include <QObject>
#include <QString>
#include <QUndoStack>

namespace fenestra::viewer {

/// What one step does; made when it is done already.
class Change {
 public:
  virtual ~Change() = default;
  virtual void undo() = 0;
  virtual void redo() = 0;
  /// Takes in what was done next within the same gesture; false when the two cannot be one.
  virtual bool absorb(const Change& next) = 0;
  /// Nothing is different afterwards.
  virtual bool isNothing() const = 0;
  /// Memory that the change holds, what it points to included.
  virtual std::size_t bytes() const = 0;
};

class History : public QObject {
  Q_OBJECT
 public:
  /// What all steps together may hold; the oldest go first, and the latest stays whatever its size. A slider's step
  /// takes some 2 kB, a brush stroke 24 bytes a point besides: room for 30 000 of the one or 10 000 strokes of 200
  /// points.
  static constexpr std::size_t defaultLimit = std::size_t{64} << 20;

  explicit History(std::size_t limit = defaultLimit, QObject* parent = nullptr);

  /// For menus and for what must know whether anything has changed since a save (setClean, cleanChanged).
  QUndoStack& stack() { return stack_; }
  const QUndoStack& stack() const { return stack_; }

  /// Adds what was just done. Steps of one name between beginGesture() and endGesture() become one; one that changes
  /// nothing is none.
  void push(const QString& name, std::shared_ptr<Change> change);
  void beginGesture();
  void endGesture() { inGesture_ = false; }
  /// Undoes the latest step and forgets it: there is no redo.
  void takeBack();
  void clear();

  std::size_t bytes() const;
  std::size_t limit() const { return limit_; }

 private:
  class Step;
  const Step& step(int index) const;
  void makeRoom(std::size_t wanted);

  QUndoStack stack_;
  std::size_t limit_;
  int gesture_ = 0;
  bool inGesture_ = false;
};

}  // namespace fenestra::viewer
