// The program from outside: what it writes, prints and returns.

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include <QImage>
#include <QProcess>

#include "tests/support/TestData.h"

namespace fenestra::viewer {
namespace {

struct Ended {
  int code = -1;
  QString errors;
};

Ended run(const QStringList& arguments) {
  QProcess program;
  program.start(QStringLiteral(FENESTRA_PROGRAM), arguments);
  constexpr int patience = 60000;  // ms; reached only when something hangs
  if (!program.waitForFinished(patience) || program.exitStatus() != QProcess::NormalExit) return {};
  QStringList lines;
  // Qt's own remarks about the session are not the program's.
  for (const QString& line : QString::fromUtf8(program.readAllStandardError()).split(QLatin1Char('\n'), Qt::SkipEmptyParts))
    if (line.startsWith(QStringLiteral("fenestra"))) lines << line;
  return {program.exitCode(), lines.join(QLatin1Char('\n'))};
}

QString qt(const std::filesystem::path& path) { return QString::fromStdString(path.string()); }

TEST(Program, SavesTheWholeWindowAndExits) {
  const std::filesystem::path picture = tests::scratchFolder() / "window.png";
  const Ended ended = run({"--phantom", "torso", "--phantom-voxels", "64", "--size", "1200x760", "--screenshot", qt(picture)});
  EXPECT_EQ(ended.code, 0) << ended.errors.toStdString();
  const QImage image(qt(picture));
  const int scale = std::max(1, qEnvironmentVariableIntValue("QT_SCALE_FACTOR"));
  EXPECT_EQ(image.size(), QSize(1200, 760) * scale);
}

TEST(Program, EndsWithOneLineWhenTheFileIsAtFault) {
  const std::filesystem::path folder = tests::scratchFolder(), picture = folder / "window.png";
  std::ofstream(folder / "broken.nii") << "not a volume";
  const Ended ended = run({qt(folder / "broken.nii"), "--screenshot", qt(picture)});
  EXPECT_EQ(ended.code, 1);
  EXPECT_EQ(ended.errors.count(QLatin1Char('\n')), 0);
  EXPECT_TRUE(ended.errors.contains(QStringLiteral("broken.nii"))) << ended.errors.toStdString();
  EXPECT_FALSE(std::filesystem::exists(picture));
}

TEST(Program, RefusesWrongUsage) {
  EXPECT_EQ(run({"--camera", "sideways"}).code, 2);
  EXPECT_EQ(run({"--no-such-option"}).code, 2);
}

TEST(Program, EndsWithOneLineWhenThePictureCannotBeWritten) {
  const Ended ended = run({"--phantom", "torso", "--phantom-voxels", "32", "--screenshot", "/no/such/folder/window.png"});
  EXPECT_EQ(ended.code, 1);
  EXPECT_EQ(ended.errors.count(QLatin1Char('\n')), 0);
}

}  // namespace
}  // namespace fenestra::viewer
