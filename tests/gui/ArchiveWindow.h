#pragma once
// A window with its Archive dock, settings and cache in folders of the test's own, and servers on the loopback
// interface.

#include <filesystem>

#include "tests/archive/MadeStudies.h"
#include "tests/archive/Servers.h"
#include "tests/gui/WindowFixture.h"
#include "viewer/archive/ArchiveDock.h"
#include "viewer/archive/ArchiveModel.h"
#include "viewer/archive/ArchivePanel.h"
#include "viewer/archive/Retrievals.h"
#include "viewer/archive/SearchForm.h"

class QModelIndex;

namespace fenestra::viewer {

class ArchiveWindow : public Window {
 protected:
  void SetUp() override;

  ArchiveDock& dock() { return window_->archive(); }
  ArchivePanel& archive() { return dock().panel(); }
  Retrievals& retrievals() { return dock().retrievals(); }
  Archives& archives() { return dock().archives(); }
  template <class Widget>
  Widget* in(QWidget& parent, const char* name) {
    return parent.findChild<Widget*>(QLatin1String(name));
  }
  template <class Done>
  void waitFor(const Done& done) {
    ASSERT_TRUE(QTest::qWaitFor(done, patience)) << archive().status().toStdString();
  }

  /// Enters a server and opens the dock.
  void enter(const ServerEntry& entry);
  /// Types a name into the search, starts it and waits for its end.
  void search(const QString& name);
  /// The texts of the results' first column, of all that is unfolded.
  QStringList results();
  QModelIndex find(const QString& text);
  void waitFor(int retrieval, Retrievals::State state);
  /// All texts that the dock shows.
  QString shown();

  std::filesystem::path root_;
};

ServerEntry entryOf(const tests::RunningServer& running);
ServerEntry webEntryOf(const tests::RunningServer& running);

}  // namespace fenestra::viewer
