// Pictures of series in the results of the Archive dock: of a server that draws them, for rows in sight.

#include <QBuffer>
#include <QPainter>
#include <QScrollBar>
#include <QTest>
#include <QTreeView>

#include <mutex>

#include "io/archive/Send.h"
#include "tests/gui/ArchiveWindow.h"
#include "viewer/archive/ArchivePictures.h"

namespace fenestra::viewer::archivePicturesTest {
namespace {

constexpr int seriesCount = 60;

std::string pngOf(const QImage& image) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  image.save(&buffer, "PNG");
  return bytes.toStdString();
}

std::string element(const char* tag, const char* vr, const std::string& value) {
  return "\"" + std::string(tag) + "\": {\"vr\": \"" + vr + "\", \"Value\": [" + value + "]}";
}

/// A DICOMweb server with one study of many series, the third of ultrasound and the others of CT, which draws red.
class DrawingServer {
 public:
  tests::RunningServer running() const {
    tests::RunningServer running;
    running.web = answering_.server().url;
    return running;
  }
  /// The series whose pictures were asked for, in their order.
  std::vector<std::string> drawn() const {
    const std::lock_guard lock(mutex_);
    return drawn_;
  }
  void setStalls(bool stalls) { stalls_ = stalls; }

 private:
  std::string answer(const std::string& request) {
    const std::string json = "application/dicom+json";
    const auto list = [&](const std::string& sets) { return tests::answerOf("200 OK", json, "[" + sets + "]"); };
    if (request.find("/rendered?") != std::string::npos) {
      const std::size_t at = request.find("/series/") + 8;
      {
        const std::lock_guard lock(mutex_);
        drawn_.push_back(request.substr(at, request.find('/', at) - at));
      }
      tests::eventually([this] { return !stalls_; });
      QImage image(64, 32, QImage::Format_RGB32);
      image.fill(Qt::red);
      return tests::answerOf("200 OK", "image/png", pngOf(image));
    }
    if (request.find("/instances?") != std::string::npos) {
      const bool isUltrasound = request.find("/series/1.2.3.3/") != std::string::npos;
      return list("{" +
                  element("00080016", "UI",
                          isUltrasound ? "\"1.2.840.10008.5.1.4.1.1.6.1\"" : "\"1.2.840.10008.5.1.4.1.1.2\"") +
                  "," + element("00080018", "UI", "\"1.2.3.4\"") + "," +
                  element("00080008", "CS", "\"ORIGINAL\", \"PRIMARY\"") + "}");
    }
    if (request.find("/series?") != std::string::npos) {
      std::string sets;
      for (int i = 1; i <= seriesCount; ++i)
        sets += (i > 1 ? ",{" : "{") + element("0020000E", "UI", "\"1.2.3." + std::to_string(i) + "\"") + "," +
                element("00080060", "CS",
                        i == 2   ? "\"SR\""
                        : i == 3 ? "\"US\""
                                 : "\"CT\"") +
                "," + element("00200011", "IS", std::to_string(i)) + "," +
                element("0008103E", "LO", "\"T2 FLAIR sagittal, fat saturated\"") + "," +
                element("00201209", "IS", "9") + "}";
      return list(sets);
    }
    return list("{" + element("0020000D", "UI", "\"1.2.3\"") + "," +
                element("00100010", "PN", R"({"Alphabetic": "Made^Up"})") + "}");
  }

  mutable std::mutex mutex_;
  std::vector<std::string> drawn_;
  std::atomic<bool> stalls_ = false;
  tests::Answering answering_{[this](const std::string& request) { return answer(request); }};
};

class ArchivePicturesWindow : public ArchiveWindow {
 protected:
  void unfold(const ServerEntry& entry) {
    archives().setAskSecret([](const ServerEntry&) { return QStringLiteral("secret word"); });
    enter(entry);
    search(QStringLiteral("*"));
    ASSERT_EQ(archive().model().rowCount(), 1);
    archive().results().expand(study());
    waitFor([&] { return archive().model().rowCount(study()) > 0; });
  }
  QModelIndex study() { return archive().model().index(0, 0, archive().model().index(0, 0)); }
  /// Whether the row of the n-th series, from 1 on, shows the server's picture.
  bool isRed(int series) {
    const auto picture = archive().model().index(series - 1, 0, study()).data(Qt::DecorationRole).value<QPixmap>();
    return !picture.isNull() && picture.toImage().pixelColor(picture.width() / 2, picture.height() / 2) == Qt::red;
  }
  void waitForPictures() {
    waitFor([&] { return !archive().pictures().isBusy(); });
  }
};

TEST_F(ArchivePicturesWindow, ComeForRowsInSightAlone) {
  DrawingServer server;
  unfold(webEntryOf(server.running()));
  waitFor([&] { return isRed(1); });
  waitForPictures();
  const std::size_t first = server.drawn().size();
  EXPECT_EQ(server.drawn()[0], "1.2.3.1") << "from the top on";
  EXPECT_EQ(server.drawn()[1], "1.2.3.3") << "a report has no pixels";
  EXPECT_LT(first, std::size_t{seriesCount} / 2) << "as many as fit";
  EXPECT_FALSE(isRed(seriesCount));
  QTreeView& results = archive().results();
  const int height = results.visualRect(archive().model().index(1, 0, study())).height();
  EXPECT_EQ(height, results.visualRect(archive().model().index(0, 0, study())).height()) << "no row moves";
  results.verticalScrollBar()->setValue(results.verticalScrollBar()->maximum());
  waitFor([&] { return isRed(seriesCount); });
  waitForPictures();
  const std::vector<std::string> drawn = server.drawn();
  EXPECT_LT(drawn.size(), 2 * first + 3) << "those between were never in sight";
  results.verticalScrollBar()->setValue(0);
  QTest::qWait(300);  // longer than rows are looked at after a scroll
  waitForPictures();
  EXPECT_EQ(server.drawn().size(), drawn.size()) << "what has come is kept";
  EXPECT_LE(archive().pictures().bytes(), ArchivePictures::mostBytes);
}

TEST_F(ArchivePicturesWindow, ThatCouldShowNamesAreHiddenWithThePatient) {
  DrawingServer server;
  unfold(webEntryOf(server.running()));
  waitFor([&] { return isRed(3); });
  EXPECT_TRUE(isRed(1));
  window_->workspace().options.setHidesPatient(true);
  EXPECT_FALSE(isRed(3)) << "ultrasound has names in its pixels";
  EXPECT_TRUE(isRed(1)) << "a slice of a scanner has none";
  window_->workspace().options.setHidesPatient(false);
  EXPECT_TRUE(isRed(3));
}

TEST_F(ArchivePicturesWindow, AreGivenUpWhenTheirRowsLeave) {
  DrawingServer server;
  server.setStalls(true);
  unfold(webEntryOf(server.running()));
  waitFor([&] { return !server.drawn().empty(); });
  EXPECT_TRUE(archive().pictures().isBusy());
  archive().results().collapse(study());
  waitForPictures();
  server.setStalls(false);
  EXPECT_EQ(server.drawn().size(), 1u);
  EXPECT_FALSE(isRed(1));
  archive().results().expand(study());
  waitFor([&] { return isRed(1); });
}

TEST_F(ArchivePicturesWindow, LeaveRoomForTheNamesInANarrowDock) {
  DrawingServer server;
  unfold(webEntryOf(server.running()));
  waitFor([&] { return isRed(1); });
  QTreeView& results = archive().results();
  const auto roomForName = [&] {
    return results.visualRect(archive().model().index(0, 0, study())).width() - results.iconSize().width();
  };
  const int name = results.fontMetrics().horizontalAdvance(QStringLiteral("1: T2 FLAIR"));
  window_->resizeDocks({&dock()}, {200}, Qt::Horizontal);
  waitFor([&] { return results.viewport()->width() < 200; });
  EXPECT_GE(roomForName(), name);
  window_->resizeDocks({&dock()}, {900}, Qt::Horizontal);
  waitFor([&] { return results.viewport()->width() > 400; });
  EXPECT_GE(roomForName(), 2 * name);
  waitFor([&] { return results.horizontalScrollBar()->maximum() == 0; });
}

TEST_F(ArchivePicturesWindow, AServerWithoutDicomwebIsAskedForNone) {
  FENESTRA_PROGRAM_OR_SKIP("dcmqrscp", "dcmtk");
  const auto running = tests::startDcmqrscp(root_ / "s");
  ASSERT_TRUE(running);
  const tests::MadeStudy made = tests::makeStudy(root_ / "made", "1.2.3.82", 2);
  io::archive::send(running->server, io::archive::filesToSend({made.folder}));
  unfold(entryOf(*running));
  EXPECT_FALSE(archive().pictures().isBusy());
  EXPECT_FALSE(archive().model().index(0, 0, study()).data(Qt::DecorationRole).isValid()) << "and has no room for one";
}

TEST(ArchivePicture, HostileBytesAreNone) {
  QImage image(300, 100, QImage::Format_RGB32);
  image.fill(Qt::red);
  const std::string png = pngOf(image);
  EXPECT_EQ(ArchivePictures::pictureIn(png, 30).size(), QSize(30, 10));
  std::string large = png;
  large.replace(16, 8, std::string("\x00\x01\x00\x00\x00\x01\x00\x00", 8));  // width and height of IHDR: 65536
  for (const std::string& bytes :
       {std::string(), std::string("<svg xmlns='http://www.w3.org/2000/svg' width='9' height='9'/>"),
        std::string("GIF89a\x01\x00\x01\x00", 10), std::string("\xff\xd8\xff\xe0 nothing"), large})
    EXPECT_TRUE(ArchivePictures::pictureIn(bytes, 30).isNull()) << bytes.substr(0, 10);
  EXPECT_LE(ArchivePictures::pictureIn(png.substr(0, png.size() / 2), 30).width(), 30) << "half of one";
}

}  // namespace
}  // namespace fenestra::viewer::archivePicturesTest
