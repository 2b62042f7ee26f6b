// What tests of the window share.
#pragma once

#include "packaging/cmake/precompiled/QtWidgets.h"
#include "packaging/cmake/precompiled/Tests.h"

#include <QtTest>

#include "tests/gui/WindowFixture.h"
