#pragma once
// The page that the window shows before anything is open: the built-in phantoms, the guided tour, the user's own data,
// recent studies, and which device draws the 3-D views.

#include <QFrame>

#include "viewer/views/GlSupport.h"

class QAction;
class QBoxLayout;
class QLabel;
class QVBoxLayout;

namespace fenestra::viewer {

class FileOpener;
class Tour;
struct Workspace;

class WelcomePage : public QFrame {
  Q_OBJECT
 public:
  /// All outlive this.
  WelcomePage(FileOpener& files, Workspace& workspace, Tour& tour, const GlSupport& gl, QWidget* parent = nullptr);

  /// A button for data that comes with the program.
  void addSample(QAction& opens);
  /// While something is being read, the page is empty: it would only flash.
  void setReading(bool reading) { body_->setVisible(!reading); }

 Q_SIGNALS:
  void guideRequested();

 protected:
  /// Puts the cards one above the other where there is no room beside each other.
  void resizeEvent(QResizeEvent* event) override;

 private:
  QFrame* makeCard(const char* icon, const QString& title, const QString& text, QVBoxLayout*& buttons);
  QWidget* makeCards(FileOpener& files, Tour& tour);
  /// The sessions and studies opened last. Their names are hidden while the patient is.
  void showRecent();

  FileOpener& files_;
  Workspace& workspace_;
  QBoxLayout* cards_;
  QVBoxLayout *samples_, *recent_;
  QLabel* recentTitle_;
  QWidget* body_;
};

}  // namespace fenestra::viewer
