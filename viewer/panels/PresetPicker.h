#pragma once
// Chooses how the volume is looked at: built-in transfer functions, the user's presets of whole looks, or a file. The
// open list shows small pictures of the volume. A menu beside it keeps the present look as a preset, and imports,
// exports, renames and deletes presets.

#include <filesystem>
#include <functional>
#include <optional>

#include <QComboBox>
#include <QMenu>
#include <QToolButton>

#include "viewer/model/LookLibrary.h"

namespace fenestra::viewer {

class Document;
class PreviewBackend;

/// Tells when its list opens. Keys and the wheel on the closed box choose among all entries but the last, which asks
/// for a file.
class PresetBox : public QComboBox {
  Q_OBJECT
 public:
  using QComboBox::QComboBox;
  void showPopup() override;

 Q_SIGNALS:
  void opening();

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;

 private:
  void enableLast(bool enable);
};

/// The questions to the user: dialogs, unless a test replaces them.
struct PresetQuestions {
  /// A name, or an empty text.
  std::function<QString(const QString& suggested)> name;
  /// A file to read or to write, or none.
  std::function<std::optional<std::filesystem::path>()> importWhich;
  std::function<std::optional<std::filesystem::path>(const QString& suggested)> exportWhere;
  /// Whether the preset of that name may be replaced, or deleted.
  std::function<bool(const QString&name)> mayReplace, mayDelete;
  /// A transfer function's file, or none.
  std::function<std::optional<std::filesystem::path>()> functionWhich;
};
PresetQuestions presetDialogs(QWidget* parent);

class PresetPicker : public QWidget {
  Q_OBJECT
 public:
  PresetPicker(Document& document, LookLibrary& library, QWidget* parent = nullptr);

  QComboBox* box() const { return box_; }
  /// The list shows a picture of each preset.
  bool hasAllPictures() const;
  QMenu* menu() const { return menu_; }
  PresetQuestions& questions() { return questions_; }
  /// Draws the pictures of the list; null: the list has none. It outlives this, or is set to null first.
  void setBackend(PreviewBackend* backend) { backend_ = backend; }

  /// The commands of the menu. Each asks the user for what it needs.
  void keepLook();
  void importPreset();
  void exportPreset();
  void renamePreset();
  void deletePreset();

 Q_SIGNALS:
  /// The user has chosen one of the presets of whole looks, or (null) a transfer function alone.
  void lookChosen(const io::LookPreset* preset);
  void failed(const QString& message);
  /// The chosen preset or file has a problem that does not keep it from being used.
  void warned(const QString& message);

 private:
  void list();
  void show();
  void choose(int row);
  void apply(const LookLibrary::Entry& entry);
  void makePictures();
  void clearPictures();
  void fillMenu();
  /// The name of the user's preset that is shown, or an empty text.
  QString shownPreset() const;
  /// Runs `work`, and reports an exception.
  void attempt(const std::function<void()>& work);

  Document& document_;
  LookLibrary& library_;
  PresetBox* box_;
  QToolButton* button_;
  QMenu* menu_;
  PresetQuestions questions_;
  PreviewBackend* backend_ = nullptr;
};

}  // namespace fenestra::viewer
