// The program from outside: what it writes, prints and returns.

#include <sys/resource.h>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include <QImage>
#include <QProcess>

#include "tests/gui/WindowFixture.h"
#include "tests/io/DicomWriter.h"
#include "tests/support/LargeVolume.h"
#include "tests/support/TestData.h"

namespace fenestra::viewer::programTest {
namespace {

struct Ended {
  int code = -1;
  QString errors;
};

Ended run(const QStringList& arguments,
          const QProcessEnvironment& environment = QProcessEnvironment::systemEnvironment()) {
  QProcess program;
  program.setProcessEnvironment(environment);
  program.start(QStringLiteral(FENESTRA_PROGRAM), arguments);
  if (!program.waitForFinished(patience) || program.exitStatus() != QProcess::NormalExit) return {};
  return {program.exitCode(), QString::fromUtf8(program.readAllStandardError()).trimmed()};
}

QString qt(const std::filesystem::path& path) { return QString::fromStdString(path.string()); }

TEST(Program, Thorough_SavesTheWholeWindowAndExits) {
  const std::filesystem::path picture = tests::scratchFolder() / "window.png";
  const Ended ended =
      run({"--phantom", "torso", "--phantom-voxels", "64", "--size", "1200x760", "--screenshot", qt(picture)});
  EXPECT_EQ(ended.code, 0) << ended.errors.toStdString();
  const QImage image(qt(picture));
  const int scale = std::max(1, qEnvironmentVariableIntValue("QT_SCALE_FACTOR"));
  EXPECT_EQ(image.size(), QSize(1200, 760) * scale);
}

TEST(Program, Thorough_AScreenshotShowsCoarseDataAsTheWindowDoes) {
  const std::filesystem::path scratch = tests::scratchFolder();
  const auto picture = [&](const char* name, const QStringList& more) {
    const QString file = qt(scratch / name);
    run(QStringList{"--phantom", "torso", "--phantom-voxels", "32", "--size", "900x700", "--screenshot", file} + more);
    const QImage window(file);
    return window.copy(0, window.height() / 6, window.width() / 4, window.height() / 4);  // a part of a 3-D view
  };
  const QImage first = picture("first.png", {});
  ASSERT_FALSE(first.isNull());
  EXPECT_EQ(first, picture("auto.png", {"--reconstruction", "auto"}));
  EXPECT_NE(first, picture("linear.png", {"--reconstruction", "linear"}));
}

TEST(Program, Thorough_AScreenshotNamesThePatientOnlyWhenAsked) {
  const std::filesystem::path scratch = tests::scratchFolder();  // empties the folder
  const auto series = [&](const char* name, const char* patient) {
    const std::filesystem::path folder = scratch / name;
    std::filesystem::create_directories(folder);
    for (int i = 0; i < 3; ++i) {
      tests::DicomSpec slice;
      slice.columns = slice.rows = 16;
      slice.instance = "1.2.3.4." + std::to_string(i);
      slice.position = glm::dvec3(0, 0, i);
      slice.patientName = patient;
      slice.patientId = std::string(patient).empty() ? "" : "4711";
      tests::writeDicom(folder / std::to_string(i), slice);
    }
    return folder;
  };
  const auto shot = [](const std::filesystem::path& folder, const QStringList& more) {
    const std::filesystem::path picture = folder.parent_path() / "shot.png";
    const Ended ended = run(QStringList{qt(folder), "--size", "1000x700", "--screenshot", qt(picture)} + more);
    EXPECT_EQ(ended.code, 0) << ended.errors.toStdString();
    EXPECT_FALSE(ended.errors.contains(QStringLiteral("Vermeer")));
    const QImage image(qt(picture));
    constexpr int statusBar = 40;  // tells how long the picture took
    return image.copy(0, 0, image.width(), image.height() - statusBar * image.width() / 1000);
  };
  // Qt rounds a letter's rim up or down from run to run; a name that is shown changes whole letters.
  const auto alike = [](const QImage& a, const QImage& b) {
    if (a.size() != b.size()) return false;
    for (int y = 0; y < a.height(); ++y)
      for (int x = 0; x < a.width(); ++x) {
        const QColor one = a.pixelColor(x, y), other = b.pixelColor(x, y);
        if (std::abs(one.red() - other.red()) > 1 || std::abs(one.green() - other.green()) > 1 ||
            std::abs(one.blue() - other.blue()) > 1)
          return false;
      }
    return true;
  };
  const std::filesystem::path named = series("named", "Vermeer^Johanna"), nobody = series("nobody", "");
  const QImage without = shot(named, {}), asked = shot(named, {"--with-patient"});
  EXPECT_TRUE(alike(without, shot(nobody, {})));
  EXPECT_FALSE(alike(without, asked));
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

TEST(Program, OpensALargeVolumeInBoundedMemory) {
  if (!qEnvironmentVariableIsSet("FENESTRA_LARGE_TESTS"))
    GTEST_SKIP() << "takes a minute; runs where FENESTRA_LARGE_TESTS is set";
  const std::filesystem::path folder = tests::scratchFolder(), file = folder / "large.raw", picture = folder / "a.png";
  tests::large::writeRaw(file);
  const Ended ended =
      run({qt(file), "--raw", "512x512x2000:int16", "--spacing", "0.8,0.8,0.5", "--screenshot", qt(picture)});
  std::filesystem::remove(file);
  EXPECT_EQ(ended.code, 0) << ended.errors.toStdString();
  rusage usage{};
  ASSERT_EQ(::getrusage(RUSAGE_CHILDREN, &usage), 0);
  // Software OpenGL keeps textures in main memory: the voxels once more, and gradients of up to twice their size.
  EXPECT_LE(static_cast<double>(usage.ru_maxrss) * 1024.0,
            4.0 * tests::large::volumeBytes + tests::large::programBytes);
}

TEST(Program, RefusesWrongUsage) {
  EXPECT_EQ(run({"--camera", "sideways"}).code, 2);
  EXPECT_EQ(run({"--no-such-option"}).code, 2);
}

TEST(Program, Thorough_EndsWithOneLineWhenThePictureCannotBeWritten) {
  const Ended ended =
      run({"--phantom", "torso", "--phantom-voxels", "32", "--screenshot", "/no/such/folder/window.png"});
  EXPECT_EQ(ended.code, 1);
  EXPECT_EQ(ended.errors.count(QLatin1Char('\n')), 0);
}

TEST(Program, SaysThatThereIsNoDisplay) {
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  environment.remove(QStringLiteral("DISPLAY"));
  const Ended ended = run({}, environment);
  EXPECT_EQ(ended.code, 1);
  EXPECT_EQ(ended.errors.count(QLatin1Char('\n')), 0) << ended.errors.toStdString();
  EXPECT_TRUE(ended.errors.contains(QStringLiteral("no display"))) << ended.errors.toStdString();
  EXPECT_EQ(run({QStringLiteral("--help")}, environment).code, 0);
}

}  // namespace
}  // namespace fenestra::viewer::programTest
