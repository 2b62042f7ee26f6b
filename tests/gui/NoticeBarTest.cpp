// Which notices show, in which order, and when they go.

#include <gtest/gtest.h>

#include <algorithm>

#include <QLabel>
#include <QPushButton>
#include <QTest>

#include "viewer/bars/NoticeBar.h"

namespace fenestra::viewer::noticeBarTest {
namespace {

using Kind = NoticeBar::Kind;
using Subject = NoticeBar::Subject;

class Notices : public testing::Test {
 protected:
  Notices() { bar_.show(); }

  void add(Kind kind, Subject subject, const char* text) { bar_.add(kind, subject, QString::fromLatin1(text)); }
  /// The texts that are on screen, from the top.
  QStringList visible() const {
    QStringList shown;
    for (const QLabel* label : bar_.findChildren<QLabel*>())
      if (label->isVisible()) shown << label->text();
    std::sort(shown.begin(), shown.end(),
              [this](const QString& a, const QString& b) { return bar_.texts().indexOf(a) < bar_.texts().indexOf(b); });
    return shown;
  }
  void press(const char* name) {
    for (QPushButton* button : bar_.findChildren<QPushButton*>())
      if (button->isVisible() && button->text() == QLatin1String(name))
        return QTest::mouseClick(button, Qt::LeftButton);
    ADD_FAILURE() << "no button " << name;
  }

  NoticeBar bar_;
};

TEST_F(Notices, TheWorstIsOnTopAndOfOneKindTheNewest) {
  add(Kind::Warning, Subject::Study, "w1");
  add(Kind::Error, Subject::Opening, "e1");
  add(Kind::Offer, Subject::Segmentations, "o1");
  add(Kind::Warning, Subject::Study, "w2");
  add(Kind::Error, Subject::Opening, "e2");
  EXPECT_EQ(bar_.texts(), (QStringList{"e2", "e1", "w2", "w1", "o1"}));
  EXPECT_EQ(visible(), (QStringList{"e2", "e1", "w2"}));
  press("2 more");
  EXPECT_EQ(visible(), bar_.texts());
}

TEST_F(Notices, NoErrorIsFoldedAway) {
  for (const char* text : {"w1", "w2", "w3", "w4"}) add(Kind::Warning, Subject::Study, text);
  for (const char* text : {"e1", "e2", "e3", "e4", "e5"}) add(Kind::Error, Subject::Opening, text);
  EXPECT_EQ(visible(), (QStringList{"e5", "e4", "e3", "e2", "e1"}));
}

TEST_F(Notices, WhatIsToldAgainMovesUp) {
  add(Kind::Error, Subject::Opening, "e1");
  add(Kind::Error, Subject::Opening, "e2");
  add(Kind::Error, Subject::Opening, "e1");
  EXPECT_EQ(bar_.texts(), (QStringList{"e1", "e2"}));
}

TEST_F(Notices, AnErrorGoesWhenWhatFailedSucceeds) {
  add(Kind::Error, Subject::Saving, "not saved");
  add(Kind::Error, Subject::Writing, "not written");
  add(Kind::Warning, Subject::Study, "uneven");
  bar_.end(Subject::Saving);
  EXPECT_EQ(bar_.texts(), (QStringList{"not written", "uneven"}));
  bar_.end(Subject::Writing);
  EXPECT_EQ(bar_.texts(), (QStringList{"uneven"}));
}

TEST_F(Notices, AnOfferGoesWhenItIsTaken) {
  int opened = 0;
  bar_.add(Kind::Offer, Subject::Segmentations, "labels lie beside it", {{"Open", [&] { ++opened; }}});
  press("Open");
  EXPECT_EQ(opened, 1);
  EXPECT_EQ(bar_.texts().size(), 1) << "they may not open";
  bar_.end(Subject::Segmentations);
  EXPECT_TRUE(bar_.texts().isEmpty());
  bar_.add(Kind::Offer, Subject::Offered, "again", {{"Take", [&] { ++opened; }, true}});
  press("Take");
  EXPECT_EQ(opened, 2);
  EXPECT_TRUE(bar_.texts().isEmpty());
  EXPECT_TRUE(bar_.isHidden());
}

TEST_F(Notices, WhatIsAboutTheStudyGoesWithIt) {
  for (int subject = 0; subject <= static_cast<int>(Subject::Offered); ++subject)
    bar_.add(Kind::Error, static_cast<Subject>(subject), QString::number(subject));
  bar_.forgetStudy();
  EXPECT_EQ(bar_.texts(), (QStringList{QString::number(static_cast<int>(Subject::Offered)),
                                       QString::number(static_cast<int>(Subject::Looks))}));
}

TEST_F(Notices, AReadersFirstWarningStandsAboveItsOthers) {
  bar_.addWarnings({{io::Warning::Kind::Other, "first", {}}, {io::Warning::Kind::Other, "second", {}}});
  EXPECT_EQ(bar_.texts(), (QStringList{"First.", "Second."}));
}

}  // namespace
}  // namespace fenestra::viewer::noticeBarTest
