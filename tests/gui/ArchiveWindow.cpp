#include "tests/gui/ArchiveWindow.h"

#include <QAbstractButton>
#include <QLabel>
#include <QLineEdit>
#include <QTest>
#include <QToolButton>
#include <QTreeView>

#include "tests/support/TestData.h"
#include "viewer/files/Sessions.h"

namespace fenestra::viewer {

void ArchiveWindow::SetUp() {
  useScratchSettings();
  // The tests' user has no key ring, and that of who runs them is left alone.
  if (!qEnvironmentVariableIsSet("FENESTRA_KEY_RING")) qputenv("DBUS_SESSION_BUS_ADDRESS", "unix:path=/nowhere");
  root_ = tests::scratchFolder();
  window_ = std::make_unique<MainWindow>(MainWindow::Setup{.gl = gl_, .atRest = Effort{.quality = Quality::Draft}});
  window_->resize(1280, 800);
  window_->show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(window_.get(), patience));
  QApplication::setActiveWindow(window_.get());
  setAutomatic(false);
  window_->sessions().questions().saveChanges = [](const QStringList&) { return SessionQuestions::Answer::Discard; };
  window_->workspace().preferences.setArchiveFolder(root_ / "cache");
}

void ArchiveWindow::enter(const ServerEntry& entry) {
  archives().put(entry);
  dock().show();
  ASSERT_TRUE(QTest::qWaitFor([&] { return archive().server() != nullptr; }, patience));
}

void ArchiveWindow::search(const QString& name) {
  auto* field = in<QLineEdit>(archive(), "patientName");
  field->setText(name);
  QTest::keyClick(field, Qt::Key_Return);
  waitFor([&] { return !archive().isBusy(); });
}

QStringList ArchiveWindow::results() {
  QStringList texts;
  const std::function<void(const QModelIndex&)> add = [&](const QModelIndex& parent) {
    for (int row = 0; row < archive().model().rowCount(parent); ++row) {
      const QModelIndex index = archive().model().index(row, 0, parent);
      texts << index.data().toString();
      add(index);
    }
  };
  add({});
  return texts;
}

QModelIndex ArchiveWindow::find(const QString& text) {
  const QModelIndexList found = archive().model().match(archive().model().index(0, 0), Qt::DisplayRole, text, 1,
                                                        Qt::MatchContains | Qt::MatchRecursive);
  return found.value(0);
}

void ArchiveWindow::waitFor(int retrieval, Retrievals::State state) {
  ASSERT_NE(retrieval, 0);
  // The list follows once the worker has ended.
  const auto reached = [&] {
    const Retrievals::Item& item = *retrievals().find(retrieval);
    return item.state == state && (state == Retrievals::State::Running || !item.job);
  };
  ASSERT_TRUE(QTest::qWaitFor(reached, patience)) << retrievals().find(retrieval)->message.toStdString();
}

QString ArchiveWindow::shown() {
  QStringList texts;
  for (const QWidget* each : dock().findChildren<QWidget*>()) {
    if (!each->isVisibleTo(&dock())) continue;  // such as a row that is about to be deleted
    texts << each->toolTip() << each->accessibleName();
    if (const auto* label = qobject_cast<const QLabel*>(each)) texts << label->text();
    if (const auto* button = qobject_cast<const QAbstractButton*>(each)) texts << button->text();
    if (const auto* line = qobject_cast<const QLineEdit*>(each)) texts << line->displayText();
  }
  const std::function<void(const QModelIndex&)> add = [&](const QModelIndex& parent) {
    for (int row = 0; row < archive().model().rowCount(parent); ++row)
      for (int column = 0; column < ArchiveModel::ColumnCount; ++column) {
        const QModelIndex index = archive().model().index(row, column, parent);
        texts << index.data().toString() << index.data(Qt::ToolTipRole).toString();
        if (column == 0) add(index);
      }
  };
  add({});
  return texts.join(QLatin1Char('\n'));
}

ServerEntry entryOf(const tests::RunningServer& running) {
  ServerEntry entry = newServerEntry();
  entry.name = QStringLiteral("Test archive");
  entry.host = QString::fromStdString(running.server.host);
  entry.port = running.server.port;
  entry.title = QString::fromStdString(running.server.title);
  if (running.server.ownPort != 0) entry.ownPort = running.server.ownPort;
  return entry;
}

ServerEntry webEntryOf(const tests::RunningServer& running) {
  ServerEntry entry = newServerEntry();
  entry.name = QStringLiteral("Web archive");
  entry.kind = ServerEntry::Kind::Web;
  entry.url = QString::fromStdString(running.web);
  entry.login = ServerEntry::Login::Password;
  entry.user = QStringLiteral("reader");
  return entry;
}

}  // namespace fenestra::viewer
