// The context that pictures are drawn in goes to another thread and comes back.

#include <array>
#include <span>
#include <stdexcept>

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTest>
#include <QThread>

#include "rendering/gl/Texture.h"
#include "tests/gui/WindowFixture.h"
#include "viewer/views/GlContext.h"

namespace fenestra::viewer::glContextTest {
namespace {

TEST(GlContext, MakesObjectsOnAnotherThread) {
  GlContext context;
  gl::Texture texture;
  QThread* worker = nullptr;
  bool done = false;
  QSignalSpy freed(&context, &GlContext::freed);
  context.runBehind(
      [&](const std::atomic<bool>&) {
        worker = QThread::currentThread();
        texture = gl::Texture::make2D(gl::Format::R32F, {2, 1});
        texture.upload(std::span<const float>(std::array{3.0f, 5.0f}));
      },
      [&](std::exception_ptr error) { done = !error; });
  EXPECT_TRUE(context.isBusy());
  ASSERT_TRUE(QTest::qWaitFor([&] { return !context.isBusy(); }, patience));
  EXPECT_EQ(freed.count(), 1);
  EXPECT_TRUE(done);
  if (QOpenGLContext::supportsThreadedOpenGL()) {
    EXPECT_NE(worker, QThread::currentThread());
  }
  std::array<float, 2> read{};
  EXPECT_TRUE(context.run([&] {
    texture.readInto(std::span<float>(read));
    texture = {};
  }));
  EXPECT_EQ(read, (std::array{3.0f, 5.0f}));
  EXPECT_EQ(QOpenGLContext::currentContext(), nullptr);
}

TEST(GlContext, PassesOnWhatWorkBehindThrows) {
  GlContext context;
  std::string said;
  context.runBehind([](const std::atomic<bool>&) { throw std::runtime_error("no voxels"); },
                    [&](std::exception_ptr error) {
                      try {
                        std::rethrow_exception(error);
                      } catch (const std::exception& caught) {
                        said = caught.what();
                      }
                    });
  ASSERT_TRUE(QTest::qWaitFor([&] { return !context.isBusy(); }, patience));
  EXPECT_EQ(said, "no voxels");
}

TEST(GlContext, StopsWorkBehindWhenTheWindowNeedsIt) {
  if (!QOpenGLContext::supportsThreadedOpenGL()) GTEST_SKIP() << "there is no OpenGL on other threads here";
  GlContext context;
  bool done = false;
  context.runBehind(
      [](const std::atomic<bool>& stop) {
        while (!stop) QThread::msleep(1);  // for ever, unless it is told
      },
      [&](std::exception_ptr) { done = true; });
  bool ran = false;
  EXPECT_TRUE(context.run([&] { ran = done; }));
  EXPECT_TRUE(ran) << "only after the other thread's work";
  EXPECT_FALSE(context.isBusy());
}

}  // namespace
}  // namespace fenestra::viewer::glContextTest
