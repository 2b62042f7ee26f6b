// Tests of the window run in one application, set up as the program sets up its own.

#include <gtest/gtest.h>

#include "tests/gui/TimedApplication.h"
#include "viewer/style/Style.h"
#include "viewer/views/GlSupport.h"

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  fenestra::viewer::requestOpenGl();
  fenestra::viewer::TimedApplication application(argc, argv);
  fenestra::viewer::applyStyle(application);
  return RUN_ALL_TESTS();
}
