#include "viewer/panels/FileDialog.h"

#include <algorithm>

#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QSettings>
#include <QTemporaryDir>

#include "viewer/model/Paths.h"

namespace fenestra::viewer {
namespace {

bool isPrivate = false;
QUrl lastPrivate;  ///< the folder that a private dialog ended in

QString qtSettingsFile() { return QSettings(QSettings::UserScope, QStringLiteral("QtProject")).fileName(); }

/// While this lives and dialogs are private, Qt keeps the history of its file dialogs in a folder that this deletes at
/// its end. Qt also remembers the last folder for the next dialog; this sets it back.
class NoTraces {
 public:
  NoTraces() {
    if (!isPrivate) return;
    active_ = true;
    const QFileInfo file(qtSettingsFile());
    before_ = file.absolutePath();
    QFile::copy(file.filePath(), scratch_.filePath(file.fileName()));  // the user's own places, and how the list looks
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, scratch_.path());
    folder_ = QFileDialog().directoryUrl();
  }
  ~NoTraces() {
    if (!active_) return;
    QFileDialog().setDirectoryUrl(folder_);
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, before_);
  }
  NoTraces(const NoTraces&) = delete;
  NoTraces& operator=(const NoTraces&) = delete;

 private:
  bool active_ = false;  ///< dialogs are private
  QTemporaryDir scratch_;
  QString before_;
  QUrl folder_;
};

/// Runs a dialog. The chosen file or folder, or an empty text.
QString run(QFileDialog& dialog, const QString& folder) {
  if (isPrivate) {
    dialog.setOption(QFileDialog::DontUseNativeDialog);
    if (folder.isEmpty() && !lastPrivate.isEmpty()) dialog.setDirectoryUrl(lastPrivate);
  }
  if (dialog.exec() != QDialog::Accepted) return {};
  if (isPrivate) lastPrivate = dialog.directoryUrl();
  return dialog.selectedFiles().value(0);
}

std::optional<std::filesystem::path> askForExisting(QWidget* parent, const FileQuestion& question,
                                                    QFileDialog::FileMode mode) {
  const NoTraces traces;
  QFileDialog dialog(parent, question.title, question.folder, question.kinds);
  dialog.setFileMode(mode);
  if (mode == QFileDialog::Directory) dialog.setOption(QFileDialog::ShowDirsOnly);
  const QString chosen = run(dialog, question.folder);
  return chosen.isEmpty() ? std::nullopt : std::optional(toPath(chosen));
}

}  // namespace

std::optional<std::filesystem::path> askForFile(QWidget* parent, const FileQuestion& question) {
  return askForExisting(parent, question, QFileDialog::ExistingFile);
}

std::optional<std::filesystem::path> askForFolder(QWidget* parent, const FileQuestion& question) {
  return askForExisting(parent, question, QFileDialog::Directory);
}

std::optional<NewFile> askForNewFile(QWidget* parent, const QString& title, const QList<FileKind>& kinds,
                                     const QString& suggested) {
  QStringList filters;
  for (const FileKind& kind : kinds) filters << QStringLiteral("%1 (*%2)").arg(kind.name, kind.ending);
  const QFileInfo name(suggested);
  const QString folder = name.path() == QLatin1String(".") ? QString() : name.path();
  const NoTraces traces;
  QFileDialog dialog(parent, title, folder, filters.join(QStringLiteral(";;")));
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setFileMode(QFileDialog::AnyFile);
  const auto kindOf = [&filters](const QString& filter) { return std::max<qsizetype>(0, filters.indexOf(filter)); };
  const auto giveEnding = [&](const QString& filter) { dialog.setDefaultSuffix(kinds[kindOf(filter)].ending.mid(1)); };
  QObject::connect(&dialog, &QFileDialog::filterSelected, &dialog, giveEnding);
  giveEnding(dialog.selectedNameFilter());
  if (!suggested.isEmpty()) dialog.selectFile(name.fileName());
  const QString chosen = run(dialog, folder);
  if (chosen.isEmpty()) return std::nullopt;
  return NewFile{toPath(chosen), kindOf(dialog.selectedNameFilter())};
}

void setFileDialogsPrivate(bool hide) { isPrivate = hide; }

}  // namespace fenestra::viewer
