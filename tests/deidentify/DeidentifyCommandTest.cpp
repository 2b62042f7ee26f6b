// fenestra-cli deidentify, as a script calls it.

#include <gtest/gtest.h>

#include "io/session/SessionFile.h"
#include "tests/cli/CommandLine.h"
#include "tests/io/DicomWriter.h"

namespace fenestra::tests::deidentify_command {
namespace {

class DeidentifyCommand : public CommandLine {
 protected:
  void SetUp() override {
    fs::create_directories(source_);
    DicomSpec spec = pictureSpec();
    spec.patientName = "Mustermann^Erika";
    spec.patientId = "4711";
    for (int slice = 0; slice < 3; ++slice) {
      spec.instance = "1.2.3.4.5." + std::to_string(slice);
      spec.position = glm::dvec3(0, 0, 2 * slice);
      writeDicom(source_ / (std::to_string(slice) + ".dcm"), spec);
    }
  }

  /// A program on a file system of a few pages.
  static bool canMountSmall() { return std::system("unshare -m true >/dev/null 2>&1") == 0; }

  const fs::path source_ = folder() / "in";
};

TEST_F(DeidentifyCommand, WritesCopiesThatOtherCommandsOpen) {
  const Result done = run({"deidentify", at("in"), "-o", at("out")});
  ASSERT_EQ(done.exitCode, 0) << done.error;
  const Json json = done.json();
  EXPECT_EQ(json["objects"], 3);
  EXPECT_EQ(json["left_out"], 0);
  EXPECT_EQ(json["folder"], at("out"));
  EXPECT_EQ(done.out.find("Mustermann"), std::string::npos);
  EXPECT_EQ(done.out.find("\"values\""), std::string::npos);
  const std::string series = json["series"][0]["series"];
  EXPECT_TRUE(fs::is_directory(fs::path(at("out")) / series));
  const Result before = run({"info", at("in")}), after = run({"info", at("out")});
  EXPECT_EQ(after.json()["dims"], before.json()["dims"]);
  EXPECT_EQ(after.json()["range"], before.json()["range"]);
}

TEST_F(DeidentifyCommand, PreviewsWithoutValuesUnlessAsked) {
  const Result preview = run({"deidentify", at("in"), "--preview"});
  ASSERT_EQ(preview.exitCode, 0) << preview.error;
  EXPECT_EQ(preview.out.find("Mustermann"), std::string::npos);
  bool found = false;
  const Json json = preview.json();
  for (const Json& change : json["changes"])
    if (change["attribute"] == "PatientName") {
      found = true;
      EXPECT_EQ(change["tag"], "(0010,0010)");
      EXPECT_EQ(change["action"], "empty");
      EXPECT_EQ(change["count"], 3);
    }
  EXPECT_TRUE(found) << preview.out;
  const Result values = run({"deidentify", at("in"), "--preview", "--values"});
  EXPECT_NE(values.out.find("Mustermann^Erika"), std::string::npos);
}

TEST_F(DeidentifyCommand, SaysWhatIsWrong) {
  EXPECT_EQ(run({"deidentify", at("in")}).exitCode, 2);
  EXPECT_EQ(run({"deidentify", at("in"), "--preview", "-o", at("out")}).exitCode, 2);
  expectFailure(run({"deidentify", at("none"), "-o", at("out")}), at("none"));
  expectFailure(run({"deidentify", at("in"), "-o", at("in")}), at("in"));
  EXPECT_FALSE(fs::exists(at("out")));
}

TEST_F(DeidentifyCommand, NamesTheDataOfASession) {
  io::Session session;
  session.volume.path = at("in");
  io::writeSession(at("work.fenestra"), session);
  const Result refused = run({"deidentify", at("work.fenestra"), "-o", at("out")});
  expectFailure(refused, at("work.fenestra"));
  EXPECT_NE(refused.error.find("name the data that it shows: " + at("in")), std::string::npos) << refused.error;
}

TEST_F(DeidentifyCommand, TakesArchives) {
  ASSERT_EQ(std::system(("cd '" + folder().string() + "' && tar cf in.tar in").c_str()), 0);
  const Result done = run({"deidentify", at("in.tar"), "-o", at("out")});
  ASSERT_EQ(done.exitCode, 0) << done.error;
  EXPECT_EQ(done.json()["objects"], 3);
}

TEST_F(DeidentifyCommand, SaysThatTheDiskIsFullAndLeavesNothing) {
  if (!canMountSmall()) GTEST_SKIP() << "needs a mount namespace of its own (unshare -m, as root)";
  fs::create_directories(at("small"));
  const std::string command = "unshare -m sh -c \"mount -t tmpfs -o size=4k none '" + at("small") + "' && '" +
                              FENESTRA_CLI + "' deidentify '" + at("in") + "' -o '" + at("small/out") +
                              "'; echo exit \\$?; ls -A '" + at("small") + "'\" > '" + at("log") + "' 2>&1";
  ASSERT_EQ(std::system(command.c_str()), 0) << contents(at("log"));
  const std::string log = contents(at("log"));
  EXPECT_NE(log.find("No space left on device"), std::string::npos) << log;
  EXPECT_TRUE(log.ends_with("exit 1\n")) << log;
}

}  // namespace
}  // namespace fenestra::tests::deidentify_command
