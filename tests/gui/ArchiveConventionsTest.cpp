// What the list of keys says of the results in the Archive dock.

#include <QDragEnterEvent>
#include <QDropEvent>
#include <QMimeData>
#include <QTreeView>

#include "tests/archive/Servers.h"
#include "tests/gui/Conventions.h"
#include "viewer/archive/ArchiveDock.h"
#include "viewer/archive/ArchiveModel.h"
#include "viewer/archive/ArchivePanel.h"
#include "viewer/archive/Retrievals.h"

namespace fenestra::viewer {

void Conventions::addArchiveGestures(Cases& cases) {
  // A server at which nothing listens: what the gestures start fails, and is in the list all the same.
  const auto prepare = [this] {
    ArchiveDock& dock = window_->archive();
    ServerEntry entry = newServerEntry();
    entry.name = entry.title = QStringLiteral("NOBODY");
    entry.host = QStringLiteral("127.0.0.1");
    entry.port = tests::freePort();
    for (const ServerEntry& old : std::vector(dock.archives().servers())) dock.archives().remove(old.id);
    dock.archives().put(entry);
    dock.show();
    dock.panel().model().setTree(treeOfStudies({{{"PatientName", "Doe^Jane"}, {"StudyInstanceUID", "1.2.3"}}}));
    QTreeView& results = dock.panel().results();
    results.expandAll();
    const QModelIndex study = dock.panel().model().index(0, 0, dock.panel().model().index(0, 0));
    results.setCurrentIndex(study);
    // Their server is that of the last search.
    dock.panel().setFoundAt(entry.id);
    return std::pair(&dock, study);
  };
  const auto expectOrder = [](ArchiveDock& dock) {
    ASSERT_EQ(dock.retrievals().items().size(), 1u);
    EXPECT_TRUE(dock.retrievals().items().front()->order.opens);
    EXPECT_EQ(dock.retrievals().items().front()->order.study, "1.2.3");
    dock.retrievals().remove(dock.retrievals().items().front()->id);
    EXPECT_TRUE(QTest::qWaitFor([&] { return dock.retrievals().items().empty(); }, patience));
  };
  cases["What an archive holds: Double-click, Return"] = [prepare, expectOrder] {
    const auto [dock, study] = prepare();
    QTreeView& results = dock->panel().results();
    QTest::mouseClick(results.viewport(), Qt::LeftButton, {}, results.visualRect(study).center());
    QTest::mouseDClick(results.viewport(), Qt::LeftButton, {}, results.visualRect(study).center());
    expectOrder(*dock);
    results.setFocus();
    QTest::keyClick(&results, Qt::Key_Return);
    expectOrder(*dock);
    dock->hide();
  };
  cases["What an archive holds: Drag onto a view"] = [this, prepare, expectOrder] {
    const auto [dock, study] = prepare();
    const std::unique_ptr<QMimeData> data(dock->panel().model().mimeData({study}));
    const QPoint place = axial()->mapTo(window_.get(), axial()->rect().center());
    QDragEnterEvent enter(place, Qt::CopyAction, data.get(), Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(window_.get(), &enter);
    EXPECT_TRUE(enter.isAccepted());
    QDropEvent drop(place, Qt::CopyAction, data.get(), Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(window_.get(), &drop);
    EXPECT_TRUE(QTest::qWaitFor([&, shown = dock] { return !shown->retrievals().items().empty(); }, patience));
    expectOrder(*dock);
    dock->hide();
  };
}

}  // namespace fenestra::viewer
