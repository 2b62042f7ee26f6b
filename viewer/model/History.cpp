#include "viewer/model/History.h"

#include <utility>
#include <vector>

#include <QSignalBlocker>

namespace fenestra::viewer {

/// One step on the stack. QUndoStack::push() calls redo() once, which does nothing: the change is already applied.
class History::Step : public QUndoCommand {
 public:
  Step(const QString& name, std::shared_ptr<Change> change, int gesture)
      : QUndoCommand(name), change_(std::move(change)), gesture_(gesture) {}

  void undo() override {
    change_->undo();
    if (once_) setObsolete(true);
  }
  void redo() override {
    if (done_) change_->redo();
    done_ = true;
  }
  /// -1, which never merges, outside gestures.
  int id() const override { return gesture_; }
  bool mergeWith(const QUndoCommand* other) override {
    const auto& next = static_cast<const Step&>(*other);
    if (next.text() != text() || !change_->absorb(*next.change_)) return false;
    setObsolete(change_->isNothing());
    return true;
  }

  /// A step with the same change, for refilling a stack.
  Step* copy(bool mayMerge) const { return new Step(text(), change_, mayMerge ? gesture_ : -1); }
  void forgetWhenUndone() { once_ = true; }
  std::size_t bytes() const { return sizeof(Step) + change_->bytes(); }

 private:
  std::shared_ptr<Change> change_;
  int gesture_;
  bool done_ = false, once_ = false;
};

/// The changes of a group, in the order in which they were made.
class History::Changes : public Change {
 public:
  void add(std::shared_ptr<Change> change) { all_.push_back(std::move(change)); }

  void undo() override {
    for (auto change = all_.rbegin(); change != all_.rend(); ++change) (*change)->undo();
  }
  void redo() override {
    for (const auto& change : all_) change->redo();
  }
  bool absorb(const Change&) override { return false; }
  bool isNothing() const override { return all_.empty(); }
  std::size_t bytes() const override {
    std::size_t sum = sizeof(*this);
    for (const auto& change : all_) sum += change->bytes();
    return sum;
  }

 private:
  std::vector<std::shared_ptr<Change>> all_;
};

History::Group::Group(History& history, QString name) : history_(history), name_(std::move(name)) {
  history_.group_ = std::make_shared<Changes>();
}

History::Group::~Group() { history_.push(name_, std::exchange(history_.group_, nullptr)); }

History::History(std::size_t limit, QObject* parent) : QObject(parent), limit_(limit) {}

const History::Step& History::step(int index) const { return static_cast<const Step&>(*stack_.command(index)); }

void History::push(const QString& name, std::shared_ptr<Change> change) {
  if (change->isNothing()) return;
  if (group_) return group_->add(std::move(change));
  makeRoom(sizeof(Step) + change->bytes());
  stack_.push(new Step(name, std::move(change), inGesture_ ? gesture_ : -1));
}

void History::beginGesture() {
  ++gesture_;
  inGesture_ = true;
}

void History::takeBack() {
  if (!stack_.canUndo()) return;
  // The stack returns its commands as const, but they were made, non-const, by this class.
  const_cast<Step&>(step(stack_.index() - 1)).forgetWhenUndone();
  stack_.undo();
}

void History::clear() {
  endGesture();
  stack_.clear();
}

std::size_t History::bytes() const {
  std::size_t sum = 0;
  for (int index = 0; index < stack_.count(); ++index) sum += step(index).bytes();
  return sum;
}

void History::makeRoom(std::size_t wanted) {
  // Steps beyond the index are not counted: the push drops them.
  const int count = stack_.index();
  std::size_t kept = wanted;
  for (int index = 0; index < count; ++index) kept += step(index).bytes();
  if (kept <= limit_) return;
  // A QUndoStack can drop steps by number only, so it is refilled. An eighth stays free, so that this happens seldom.
  int first = 0;
  for (; first < count && kept > limit_ - limit_ / 8; ++first) kept -= step(first).bytes();
  const int clean = stack_.cleanIndex();
  std::vector<Step*> latest;
  for (int index = first; index < count; ++index) latest.push_back(step(index).copy(index == count - 1));
  const QSignalBlocker quiet(stack_);  // the push that follows notifies the listeners
  stack_.clear();
  if (clean != first) stack_.resetClean();
  for (Step* each : latest) {
    stack_.push(each);
    if (first + stack_.index() == clean) stack_.setClean();
  }
}

}  // namespace fenestra::viewer
