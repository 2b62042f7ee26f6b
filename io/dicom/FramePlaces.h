#pragma once
// Where the frames of a file lie: which attributes give position, orientation and the step from frame to frame, by kind
// of object, with the clauses of PS3.3. The first row whose attributes are there counts.
//
// - Enhanced multi-frame (C.7.6.16.2.3, C.7.6.16.2.4): Plane Position and Plane Orientation (Patient) Sequence, a
//   frame's own or shared. Each frame has its own place.
// - Enhanced US Volume (C.8.24.2, C.7.6.16.2.21, C.7.6.16.2.22): Plane Position and Plane Orientation (Volume)
//   Sequence, in the frame of the probe's volume, not the patient's. Each frame has its own place.
// - Single frames (C.7.6.2): Image Position and Image Orientation (Patient).
// - NM (C.8.4.11, C.8.4.15, C.8.4.8): those of the first item of the Detector Information Sequence place the first
//   slice. The others follow at Spacing Between Slices along the normal, against it where that is negative, by Slice
//   Vector.
// - ACR-NEMA: Image Position and Image Orientation, retired.
// - RT Dose (C.8.8.3.2): as single frames for the first frame; the others at Grid Frame Offset Vector along the normal.
// - Multi-frame Secondary Capture (C.8.6.4): as single frames for the first frame; the others at Slice Location Vector.
// - Other multi-frame files without functional groups, as cone-beam CT (C.7.6.2): as single frames for the first frame;
//   the others at Spacing Between Slices along the normal, which is a guess; no place where frames follow in time.
// - No position: the orientation where it is given, and Slice Location (C.7.6.2.1.2) or ACR-NEMA's Location, by which
//   StackFrames.h orders slices.
//
// The pixel spacing is Pixel Spacing, else Imager Pixel Spacing (the detector's), else that of the first ultrasound
// region (C.8.5.5), else 1 mm. Slice Thickness is no step where another attribute gives one.

#include "io/dicom/Dataset.h"
#include "io/dicom/DicomFile.h"

namespace fenestra::io {

/// Position, axes, spacing, thickness and Slice Location of a frame, as far as its groups and the dataset say.
void readGeometry(const Scopes& scopes, DicomFrame& frame);
/// Places the frames of a file whose header gives the place of the first one alone; frames that cannot be placed lose
/// their geometry. Scales doses, too.
void placeFrames(DcmItem& dataset, DicomFile& file);

}  // namespace fenestra::io
