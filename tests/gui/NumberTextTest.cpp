// Numbers and units as people write them.

#include <gtest/gtest.h>

#include "viewer/model/NumberText.h"

namespace fenestra::viewer::numberTextTest {
namespace {

TEST(NumberText, VolumesHaveThreeDigitsAndNoExponents) {
  const auto text = [](double ml) {
    return volumeText(ml).replace(QChar(QChar::Nbsp), QLatin1Char(' ')).toStdString();
  };
  EXPECT_EQ(text(0.0), "0 ml");
  EXPECT_EQ(text(0.01234), "0.0123 ml");
  EXPECT_EQ(text(1.234), "1.23 ml");
  EXPECT_EQ(text(12.34), "12.3 ml");
  EXPECT_EQ(text(153.3), "153 ml");
  EXPECT_EQ(text(1533.4), "1 533 ml");
  EXPECT_EQ(text(14120.0), "14.1 l");
  EXPECT_EQ(text(1412000.0), "1 412 l");
}

TEST(NumberText, UnitsFitTheirFields) {
  EXPECT_EQ(unitText("HU"), "HU");
  EXPECT_EQ(unitText("Houndsfield Unit"), "HU");
  EXPECT_EQ(unitText("hounsfield units"), "HU");
  EXPECT_EQ(unitText("Bq/ml"), "Bq/ml");
  EXPECT_EQ(unitText("arbitrary units of the scanner"), QStringLiteral("arbitrary…"));
  EXPECT_EQ(unitSuffix(""), "");
  EXPECT_EQ(unitSuffix("Bq/ml"), " Bq/ml");
}

}  // namespace
}  // namespace fenestra::viewer::numberTextTest
