#pragma once
// Changes the keys of the window's actions: a list, a box that takes a key, and files to keep them in.

#include <QDialog>
#include <QKeySequence>

class QAction;
class QKeySequenceEdit;
class QLabel;
class QLineEdit;
class QPushButton;
class QTreeWidget;

namespace fenestra::viewer {

class KeyBindings;

class KeysDialog : public QDialog {
  Q_OBJECT
 public:
  /// `bindings` outlives this.
  explicit KeysDialog(KeyBindings& bindings, QWidget* parent = nullptr);

 private:
  QWidget* makeEditor();
  QWidget* makeButtons();
  void fill();
  void follow();
  void showOnly(const QString& words);
  /// The key that was typed: given to the chosen action at once where it is free, and otherwise asked about.
  void typed();
  void exportKeys();
  void importKeys();
  QAction* chosen() const;

  KeyBindings& bindings_;
  QTreeWidget* list_;
  QKeySequenceEdit* key_;
  QPushButton *take_, *remove_, *reset_;
  QLabel* says_;
  QKeySequence asked_;  ///< another action has it, and the user is asked
};

}  // namespace fenestra::viewer
