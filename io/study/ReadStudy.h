#pragma once
// The one way from files to a study, for the command line and the window. Both calls report progress, which cancels
// them, and throw DataMissing, Error and Cancelled.

#include "io/study/Study.h"
#include "io/study/StudyRequest.h"

namespace fenestra::io {

/// Opens the data alone: the volume with its label map, or those of a session, or a phantom.
Study openData(const DataRequest& request, const Progress& progress = {});

/// Opens the data, finds the focus, grows its region, and applies what the request asks for. A phantom without a
/// choice of focus gets the one that shows the cutaway best.
Study readStudy(const StudyRequest& request, const Progress& progress = {});

/// Tells a user whose scan has a table that it is hidden.
Warning tableWarning();

}  // namespace fenestra::io
