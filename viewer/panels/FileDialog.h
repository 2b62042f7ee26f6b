#pragma once
// Asks for files and folders; all file dialogs are made here. They begin in the folder that was chosen last.
//
// Qt and the desktop keep the folders of such dialogs in files of their own, and a folder is often named after its
// patient. While the dialogs are private, they are Qt's own and leave nothing behind.

#include <filesystem>
#include <optional>

#include <QList>
#include <QString>

class QWidget;

namespace fenestra::viewer {

struct FileQuestion {
  QString title;
  QString kinds{};   ///< such as "Sessions (*.fenestra);;All files (*)"; empty: all files
  QString folder{};  ///< where the dialog begins; empty: in the folder chosen last
};

/// A file that exists, or a folder; empty when cancelled.
std::optional<std::filesystem::path> askForFile(QWidget* parent, const FileQuestion& question);
std::optional<std::filesystem::path> askForFolder(QWidget* parent, const FileQuestion& question);

/// A kind of file that a dialog offers to write: its name, and its ending, such as ".nii.gz".
struct FileKind {
  QString name, ending;
};
struct NewFile {
  std::filesystem::path path;  ///< with the ending of its kind, unless the user gave another
  qsizetype kind = 0;          ///< index into the kinds that were offered
};
/// A file to write, which the user allowed to be replaced where it exists; empty when cancelled. `suggested` is a name
/// or a path.
std::optional<NewFile> askForNewFile(QWidget* parent, const QString& title, const QList<FileKind>& kinds,
                                     const QString& suggested = {});

/// Applies to all dialogs of the process, as Qt's history does.
void setFileDialogsPrivate(bool isPrivate);

}  // namespace fenestra::viewer
