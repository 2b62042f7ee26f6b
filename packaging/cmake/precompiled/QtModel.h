// What files of the window's models and jobs share.
#pragma once

#include "packaging/cmake/precompiled/Standard.h"

#include <QCoreApplication>
#include <QFuture>
#include <QFutureWatcher>
#include <QImage>
#include <QObject>
#include <QPointF>
#include <QSettings>
#include <QString>
#include <QStringList>
#include <QTimer>
