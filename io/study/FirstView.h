#pragma once
// The first picture to make of a study.

namespace fenestra::io {

struct Study;
struct StudyRequest;

/// Sets study.view and what belongs to it: from the request, else from the session's view, else what suits the data,
/// which are drawn by then. Throws Error where a camera's file cannot be read.
void setFirstView(const StudyRequest& request, Study& study);

}  // namespace fenestra::io
