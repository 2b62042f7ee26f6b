// Desktop entry, metainfo, MIME types and thumbnailers, each checked by the desktop's own tools.

#include <filesystem>
#include <fstream>
#include <regex>

#include <gtest/gtest.h>

#include "tests/packaging/Shell.h"
#include "tests/support/TestData.h"

namespace fenestra::tests {
namespace {

const std::string resources = FENESTRA_SOURCE_DIR "/resources/desktop/";

/// The value of `key` in a desktop entry or thumbnailer.
std::string valueIn(const std::string& path, const std::string& key) {
  for (const std::string& line : linesOf(contentsOf(path)))
    if (line.starts_with(key + "=")) return line.substr(key.size() + 1);
  ADD_FAILURE() << path << " has no " << key;
  return "";
}

std::set<std::string> mimeTypesIn(const std::string& path) {
  std::set<std::string> types;
  std::istringstream stream(valueIn(path, "MimeType"));
  for (std::string type; std::getline(stream, type, ';');) types.insert(type);
  return types;
}

#ifdef FENESTRA_DESKTOP
TEST(DesktopEntry, IsValid) {
  if (!isInstalled("desktop-file-validate")) GTEST_SKIP() << "desktop-file-validate is not installed";
  const Outcome checked = shell("desktop-file-validate " FENESTRA_DESKTOP ".desktop");
  EXPECT_EQ(checked.exitCode, 0);
  EXPECT_EQ(checked.output, "");
}

TEST(Metainfo, IsValid) {
  if (!isInstalled("appstreamcli")) GTEST_SKIP() << "appstreamcli is not installed";
  const Outcome checked = shell("appstreamcli validate --no-net --pedantic " FENESTRA_DESKTOP ".metainfo.xml");
  EXPECT_EQ(checked.exitCode, 0) << checked.output;
  // Hints and warnings do not change the exit code; each is a line "W: ID:LINE: TAG".
  EXPECT_FALSE(std::regex_search(checked.output, std::regex("(^|\n)[EWIP]: "))) << checked.output;
}

TEST(Metainfo, NamesThisRelease) {
  const std::string metainfo = contentsOf(FENESTRA_DESKTOP ".metainfo.xml");
  const std::size_t first = metainfo.find("<release ");
  ASSERT_NE(first, std::string::npos);
  EXPECT_EQ(metainfo.find("<release version=\"" FENESTRA_VERSION "\""), first)
      << "the newest release of resources/desktop/fenestra.metainfo.xml.in is not " FENESTRA_VERSION;
}
#endif

TEST(MimeTypes, AreWellFormedAndHoldAllThatAreNamed) {
  if (!isInstalled("xmllint")) GTEST_SKIP() << "xmllint is not installed";
  const std::string file = resources + "fenestra-mime.xml";
  const Outcome checked = shell("xmllint --noout " + file);
  EXPECT_EQ(checked.exitCode, 0) << checked.output;

  const std::string declared = contentsOf(file);
  // Desktops know these themselves.
  const std::set<std::string> known{"application/dicom", "image/tiff", "inode/directory"};
  for (const char* user : {"fenestra.desktop.in", "fenestra-session.thumbnailer", "fenestra-volume.thumbnailer"})
    for (const std::string& type : mimeTypesIn(resources + user))
      EXPECT_TRUE(known.contains(type) || declared.find("<mime-type type=\"" + type + "\">") != std::string::npos)
          << user << " names " << type;
}

TEST(DesktopEntry, OpensEveryFormatOfVolumes) {
  const std::set<std::string> types = mimeTypesIn(resources + "fenestra.desktop.in");
  for (const char* type : {"application/dicom", "application/x-nifti", "application/x-nrrd", "application/x-metaimage",
                           "application/x-mgh", "image/tiff", "inode/directory"})
    EXPECT_TRUE(types.contains(type)) << type;
}

class Thumbnailer : public ::testing::Test {
 protected:
  /// Runs a thumbnailer's command as a file manager does.
  static Outcome draw(const std::string& thumbnailer, const std::string& input, const std::string& output) {
    std::string command = valueIn(resources + thumbnailer, "Exec");
    const auto put = [&](const std::string& field, const std::string& value) {
      for (std::size_t at = 0; (at = command.find(field, at)) != std::string::npos; at += value.size())
        command.replace(at, field.size(), value);
    };
    put("fenestra-cli", FENESTRA_CLI);
    put("%i", input);
    put("%o", output);
    put("%s", "128");
    return shell(command);
  }

  /// Width and height that a PNG's header names.
  static std::pair<int, int> sizeOf(const std::string& png) {
    const auto byte = [&](std::size_t i) { return static_cast<int>(static_cast<unsigned char>(png[i])); };
    return png.size() < 24 ? std::pair{0, 0} : std::pair{byte(18) * 256 + byte(19), byte(22) * 256 + byte(23)};
  }

  static void expectPicture(const std::string& path) {
    const std::string png = contentsOf(path);
    EXPECT_EQ(sizeOf(png), (std::pair{128, 128}));
    EXPECT_EQ(png.find("tEXt"), std::string::npos) << "holds a text";
    EXPECT_EQ(png.find("iTXt"), std::string::npos) << "holds a text";
  }

  const std::filesystem::path folder_ = scratchFolder();
  const std::string volume_ = (folder_ / "volume.nii").string();
  const std::string session_ = (folder_ / "work.fenestra").string();
  const std::string thumbnail_ = (folder_ / "thumbnail").string();  ///< file managers choose the name
};

TEST_F(Thumbnailer, DrawsVolumesAndSessionsAtTheSizeAskedFor) {
  const std::string cli = FENESTRA_CLI;
  ASSERT_EQ(shell(cli + " convert --phantom torso --phantom-voxels 48 -o " + volume_).exitCode, 0);
  EXPECT_EQ(draw("fenestra-volume.thumbnailer", volume_, thumbnail_).exitCode, 0);
  expectPicture(thumbnail_);

  const std::string picture = (folder_ / "picture.png").string();
  const Outcome saved =
      shell(cli + " render " + volume_ + " --size 200x100 --camera L --save-session " + session_ + " -o " + picture);
  ASSERT_EQ(saved.exitCode, 0) << saved.output;
  std::filesystem::remove(thumbnail_);
  EXPECT_EQ(draw("fenestra-session.thumbnailer", session_, thumbnail_).exitCode, 0);
  expectPicture(thumbnail_);
}

TEST_F(Thumbnailer, LeavesNoPictureOfADamagedFile) {
  for (const std::string& path : {volume_, session_}) {
    std::ofstream(path) << "damaged";
    const std::string name = path == volume_ ? "fenestra-volume.thumbnailer" : "fenestra-session.thumbnailer";
    const Outcome drawn = draw(name, path, thumbnail_);
    EXPECT_EQ(drawn.exitCode, 1);
    EXPECT_EQ(linesOf(drawn.output).size(), 1u) << drawn.output;
    EXPECT_TRUE(drawn.output.starts_with("fenestra-cli: " + path + ": ")) << drawn.output;
    EXPECT_FALSE(std::filesystem::exists(thumbnail_));
  }
}

}  // namespace
}  // namespace fenestra::tests
