#pragma once
// File names between Qt and the standard library, any script, any encoding of the file system.

#include <filesystem>

#include <QFile>
#include <QString>

namespace fenestra::viewer {

inline std::filesystem::path toPath(const QString& name) { return QFile::encodeName(name).toStdString(); }
inline QString toQString(const std::filesystem::path& path) {
  return QFile::decodeName(QByteArray::fromStdString(path.string()));
}

}  // namespace fenestra::viewer
