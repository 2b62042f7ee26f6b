// What files of the window share.
#pragma once

#include "packaging/cmake/precompiled/QtModel.h"

#include <QtWidgets>

#include <QOpenGLWidget>
