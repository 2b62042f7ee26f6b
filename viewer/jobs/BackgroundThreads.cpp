#include "viewer/jobs/BackgroundThreads.h"

#include <sys/resource.h>

namespace fenestra::viewer {

QThreadPool& backgroundThreads() {
  static QThreadPool threads;
  return threads;
}

void giveWayToTheWindow() {
  // Qt's own priorities have no effect under Linux's usual scheduler. There the nice value belongs to a thread, and 0
  // means the calling one. At 10 a thread gets a tenth of the time of one at 0 that wants the same core.
  constexpr int niceness = 10;
  setpriority(PRIO_PROCESS, 0, niceness);
}

}  // namespace fenestra::viewer
