// The window proves how exact its picture is.

#include <algorithm>

#include <QJsonDocument>
#include <QJsonObject>
#include <QMessageBox>
#include <QTest>

#include "io/ImageWriter.h"
#include "tests/gui/WindowFixture.h"
#include "tests/support/TestData.h"
#include "viewer/bars/NoticeBar.h"
#include "viewer/exports/Verification.h"

namespace fenestra::viewer::verificationWindowTest {
namespace {

class VerificationWindow : public Window {
 protected:
  void SetUp() override {
    Window::SetUp();
    if (IsSkipped()) return;
    window_->resize(900, 700);  // few pixels
    open(markedBall());
    waitUntilDrawn();
    QObject::connect(&verification(), &Verification::verified, &context_,
                     [this](const Verification::Result& result) { results_.push_back(result); });
  }

  Verification& verification() { return window_->verification(); }
  QMessageBox* box() { return window_->findChild<QMessageBox*>(); }
  void verify() { window_->findChild<QAction*>(QStringLiteral("verify"))->trigger(); }

  QObject context_;
  std::vector<Verification::Result> results_;
};

TEST_F(VerificationWindow, StatesTheErrorOfTheActiveViewsPicture) {
  volume(1)->setFocus();
  ASSERT_TRUE(QTest::qWaitFor([&] { return views().activeView() == volume(1); }, patience));
  ASSERT_EQ(views().activeView(), volume(1));
  views().setAtRest(Quality::Normal, 1.0);
  verify();  // before the picture is at full quality: waits for that
  ASSERT_TRUE(QTest::qWaitFor([&] { return !results_.empty(); }, patience));
  const Verification::Result& result = results_.front();
  EXPECT_EQ(result.certificate.within, 1.0);
  EXPECT_EQ(result.certificate.share, reference::wantedShare);
  EXPECT_EQ(result.certificate.pixels,
            std::min(reference::CertificateOptions{}.pixels, result.picture.width() * result.picture.height()));
  ASSERT_TRUE(box());
  EXPECT_EQ(box()->text(), statement(result.certificate));
  EXPECT_TRUE(box()->text().contains(QLocale().toString(99.9))) << box()->text().toStdString();
  EXPECT_TRUE(window_->isEnabled()) << "the dialog must not keep the user from the window";

  const std::filesystem::path png = tests::scratchFolder() / "verified.png";
  verification().write(png, result);
  ASSERT_TRUE(QTest::qWaitFor([&] { return std::filesystem::exists(png); }, patience));
  EXPECT_EQ(io::readPicture(png).size, glm::ivec2(result.picture.width(), result.picture.height()));
  EXPECT_EQ(
      QJsonDocument::fromJson(QByteArray::fromStdString(result.proof.text)).object()[QStringLiteral("pixels")].toInt(),
      result.certificate.pixels);
}

TEST_F(VerificationWindow, Thorough_TellsAWrongPictureFromARightOne) {
  // A draft of a volume with fine structure is further off than a picture with a bound.
  views().setAtRest(Quality::Draft, {});
  waitUntilDrawn();
  verify();
  ASSERT_TRUE(QTest::qWaitFor([&] { return results_.size() == 1; }, patience));
  views().setAtRest(Quality::Normal, 0.5);
  waitUntilDrawn();
  verify();
  ASSERT_TRUE(QTest::qWaitFor([&] { return results_.size() == 2; }, patience));
  EXPECT_GT(results_.front().certificate.within, 2.0 * results_.back().certificate.greatest);
}

TEST_F(VerificationWindow, CanBeCancelledAndLeavesTheWindowAsItWas) {
  waitUntilDrawn();
  verify();
  EXPECT_TRUE(verification().isBusy());
  verification().cancel();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !verification().isBusy(); }, patience));
  EXPECT_FALSE(box());
  EXPECT_TRUE(results_.empty());
  verify();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !results_.empty(); }, patience));
}

TEST_F(VerificationWindow, AProofThatCannotBeWrittenIsSaid) {
  waitUntilDrawn();
  verify();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !results_.empty(); }, patience));
  verification().write(tests::scratchFolder() / "absent" / "proof.png", results_.front());
  EXPECT_TRUE(QTest::qWaitFor([&] { return !window_->notices().texts().isEmpty(); }, patience));
  EXPECT_TRUE(window_->notices().texts().join(QLatin1Char(' ')).contains(QStringLiteral("proof.png")));
}

TEST_F(VerificationWindow, WithoutA3DViewOnScreenItSaysSo) {
  QTest::mouseDClick(slice(SlicePlane::Axial), Qt::LeftButton);
  ASSERT_TRUE(views().isMaximised());
  verify();
  EXPECT_FALSE(verification().isBusy());
  EXPECT_TRUE(window_->notices().texts().join(QLatin1Char(' ')).contains(QStringLiteral("3-D view")));
}

}  // namespace
}  // namespace fenestra::viewer::verificationWindowTest
