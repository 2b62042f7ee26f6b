#pragma once
// Asks where to save a file, and as what.

#include <filesystem>

#include <QList>
#include <QString>

class QWidget;

namespace fenestra::viewer {

/// What the dialog offers: a name for the kind of file, and its ending.
struct FileKind {
  QString name, ending;
};

/// The file that the user chose, with the ending of the kind unless it has one; empty when cancelled. `chosen` is the
/// kind's index.
std::filesystem::path askForSaveFile(QWidget& window, const QString& title, const QList<FileKind>& kinds,
                                     qsizetype& chosen);

}  // namespace fenestra::viewer
