#pragma once
// Threads for work that the window does not wait for.

#include <QThreadPool>

namespace fenestra::viewer {

QThreadPool& backgroundThreads();

/// To be called first in such work: from now on the calling thread, and each that it starts, leaves the processor to
/// the window's threads and the OpenGL driver's wherever those have something to do.
void giveWayToTheWindow();

}  // namespace fenestra::viewer
