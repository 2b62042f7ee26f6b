// What tests of the renderer share.
#pragma once

#include "packaging/cmake/precompiled/Tests.h"
#include "tests/gl/GlTest.h"
