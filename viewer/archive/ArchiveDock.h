#pragma once
// The dock for archive servers (PACS). It is hidden until the user opens it, and makes its contents then: a window in
// which nobody opens it reads no list of servers, starts no thread and uses no network.

#include <filesystem>
#include <functional>
#include <memory>

#include <QDockWidget>
#include <QPointer>

#include "viewer/archive/Archives.h"

class QMainWindow;

namespace fenestra::viewer {

class ArchivePanel;
class ArrivalView;
class LoadJob;
class Retrievals;
class SendDialog;
struct Workspace;

class ArchiveDock : public QDockWidget {
  Q_OBJECT
 public:
  /// Opens a folder as if the user had chosen it; may ask before.
  using Open = std::function<void(const std::filesystem::path& folder)>;

  /// `window` gets the dock and owns this; `workspace` and `opening`, the job that `open` starts, outlive it.
  ArchiveDock(QMainWindow& window, Workspace& workspace, LoadJob& opening, Open open);
  ~ArchiveDock() override;

  /// Made when they are first asked for.
  Archives& archives();
  Retrievals& retrievals();
  ArchivePanel& panel();
  /// Null before the dock was opened.
  ArchivePanel* panelIfMade() { return panel_; }
  /// Null before something was retrieved.
  ArrivalView* arrivals() const;

  /// Opens the dialog that sends what is open; without a server it opens the dock, which says how to enter one.
  void showSendDialog();

 protected:
  /// A study or series that is dragged from the dock onto the views.
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void openRetrieved(int retrieval);

  QMainWindow& window_;
  Workspace& workspace_;
  LoadJob& opening_;
  Open open_;
  std::unique_ptr<Archives> archives_;
  std::unique_ptr<Retrievals> retrievals_;
  ArchivePanel* panel_ = nullptr;
  QPointer<ArrivalView> arrivals_;
  QPointer<SendDialog> send_;
};

}  // namespace fenestra::viewer
