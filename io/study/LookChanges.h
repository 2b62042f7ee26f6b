#pragma once
// Applies what a request changes of a look once the data are known: labels are found by name, ends of a box along the
// volume's axes.

namespace fenestra {
struct SetScene;
}

namespace fenestra::io {

struct StudyRequest;

/// How single labels are shown. The scene's focus is set before. Throws Error where a label does not exist, or cannot
/// have a role because it is in focus, or levels of importance have no labels in focus.
void setLabelSettings(const StudyRequest& request, SetScene& scene);

/// Optical properties of the focus by value. The scene's focus is set before. Throws Error where a label does not
/// exist, there is no focus, or a file holds no transfer function.
void setFocusFunctions(const StudyRequest& request, SetScene& scene);

/// Throws Error where a label does not exist or the box holds nothing of the volume.
void setClipping(const StudyRequest& request, SetScene& scene);

}  // namespace fenestra::io
