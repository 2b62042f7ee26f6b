// What tests of the window's models and jobs share.
#pragma once

#include "packaging/cmake/precompiled/QtModel.h"
#include "packaging/cmake/precompiled/Tests.h"

#include <QSignalSpy>
#include <QTest>
