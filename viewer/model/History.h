#pragma once
// Undo and redo: a QUndoStack whose memory is bounded by bytes instead of steps.

#include <cstddef>
#include <memory>

#include <QObject>
#include <QString>
#include <QUndoStack>

namespace fenestra::viewer {

/// One change, which is made after it has been applied.
class Change {
 public:
  virtual ~Change() = default;
  virtual void undo() = 0;
  virtual void redo() = 0;
  /// Merges the next change of the same gesture into this one. False when the two cannot be merged.
  virtual bool absorb(const Change& next) = 0;
  /// Whether undo() and redo() would change nothing.
  virtual bool isNothing() const = 0;
  /// Memory that the change holds, including what it points to.
  virtual std::size_t bytes() const = 0;
};

class History : public QObject {
  Q_OBJECT
 public:
  /// Bytes that all steps may hold together. The oldest are dropped first; the latest stays whatever its size. A
  /// slider's step takes about 2 kB, a brush stroke 24 bytes more for each point: room for 30 000 slider steps or 10
  /// 000 strokes of 200 points.
  static constexpr std::size_t defaultLimit = std::size_t{64} << 20;

  explicit History(std::size_t limit = defaultLimit, QObject* parent = nullptr);

  /// For menus, and to know whether anything has changed since a save (setClean, cleanChanged).
  QUndoStack& stack() { return stack_; }
  const QUndoStack& stack() const { return stack_; }

  /// Adds a change that has just been applied. Steps of one name between beginGesture() and endGesture() are merged; a
  /// step that changes nothing is dropped.
  void push(const QString& name, std::shared_ptr<Change> change);
  void beginGesture();
  void endGesture() { inGesture_ = false; }
  /// While one lives, all changes that are pushed become one step of its name; none without any. Not to be nested, and
  /// nothing is undone meanwhile.
  class Group {
   public:
    Group(History& history, QString name);
    ~Group();
    Group(const Group&) = delete;
    Group& operator=(const Group&) = delete;

   private:
    History& history_;
    QString name_;
  };
  /// Undoes the latest step and drops it, so that it cannot be redone.
  void takeBack();
  void clear();

  std::size_t bytes() const;
  std::size_t limit() const { return limit_; }

 private:
  class Step;
  class Changes;
  const Step& step(int index) const;
  void makeRoom(std::size_t wanted);

  QUndoStack stack_;
  std::size_t limit_;
  int gesture_ = 0;
  bool inGesture_ = false;
  std::shared_ptr<Changes> group_;  ///< of the Group that lives
};

}  // namespace fenestra::viewer
