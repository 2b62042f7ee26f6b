#pragma once
// The window before anything is open: how to open something.

#include <QFrame>

namespace fenestra::viewer {

class FileOpener;

class WelcomePage : public QFrame {
  Q_OBJECT
 public:
  explicit WelcomePage(FileOpener& files, QWidget* parent = nullptr);
};

}  // namespace fenestra::viewer
