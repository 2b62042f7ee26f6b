// Tests of the window run in one application, set up as the program sets up its own.

#include <gtest/gtest.h>

#include "tests/gui/TimedApplication.h"
#include "viewer/style/Style.h"
#include "viewer/views/GlSupport.h"

#ifdef __SANITIZE_ADDRESS__
/// Libraries stay loaded until the end: LeakSanitizer knows the names in them, which leaks.txt lists.
extern "C" int dlclose(void*) noexcept { return 0; }
#endif

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  fenestra::viewer::requestOpenGl();
  fenestra::viewer::TimedApplication application(argc, argv);
  fenestra::viewer::applyStyle(application);
  return RUN_ALL_TESTS();
}
