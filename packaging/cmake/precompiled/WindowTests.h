// What tests of the window share.
#pragma once

// First: Qt's headers bring an OpenGL header that epoxy's must come before.
#include <epoxy/gl.h>

#include "packaging/cmake/precompiled/QtWidgets.h"
#include "packaging/cmake/precompiled/Tests.h"

#include <QtTest>

#include "tests/gui/WindowFixture.h"
