// The trial of both schedules where a driver refuses programs. The refusal is made here: linking one throws.

#include "rendering/ScheduleTrial.h"
#include "tests/gl/GlTest.h"
#include "tests/gl/SceneKinds.h"

namespace fenestra::tests::scheduleTrialTest {
namespace {

class ScheduleTrial : public GlTest {
 protected:
  void TearDown() override {
    gl::ShaderProgram::listen({});
    GlTest::TearDown();
  }

  /// From now on programs whose source holds this text do not link.
  static void refuse(std::string text) {
    gl::ShaderProgram::listen(
        [text = std::move(text)](const gl::ShaderProgram&, std::string_view path, const std::string& source) {
          if (path == "FocusLayer.comp" && source.find(text) != std::string::npos) throw gl::ShaderError("refused");
        });
  }

  static ScheduleTimes tried() {
    const Scene scene = bodyWithOrgans<std::int16_t>(gridOf({26, 24, 22}));
    const auto gpu = std::make_shared<GpuScene>();
    const View view{Camera::fromAngles(25.0, 15.0, scene.volume->grid), {64, 60}};
    const ScheduleTimes times = tryBothSchedules(gpu, scene, view);
    EXPECT_EQ(gpu->schedule(), times.faster());
    return times;
  }
};

TEST_F(ScheduleTrial, ARefusedScheduleIsNotChosen) {
  refuse("IN_STEP = true");
  EXPECT_EQ(tried().faster(), Schedule::Plain);
  refuse("IN_STEP = false");
  EXPECT_EQ(tried().faster(), Schedule::Llvmpipe);
}

TEST_F(ScheduleTrial, TwoRefusedSchedulesAreAnError) {
  refuse("IN_STEP");
  EXPECT_THROW(tried(), gl::ShaderError);
}

}  // namespace
}  // namespace fenestra::tests::scheduleTrialTest
