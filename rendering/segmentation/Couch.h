#pragma once
// The scanner's table, head rest and cushions in a CT: what lies around the patient.

#include <memory>

#include "rendering/volume/CoarseMask.h"
#include "rendering/volume/Volume.h"

namespace fenestra::segmentation {

/// Finds what is not the patient in a volume in Hounsfield units; nothing in other volumes. Works on cells of about
/// 2 mm, at most 2²⁴ of them, in some 30 bytes a cell and on all cores. Deterministic.
///
/// The body is a morphological opening, with a ball of 6 mm, of all values above -200 HU (a table is a shell or foam,
/// and narrower), grown back by the ball and 4 mm more. Among the opened parts, those count that hold 1 cm³ and are
/// neither metal nor slabs (no thicker than 30 mm, longer than 200 mm): arms and legs apart from the trunk belong to
/// the body. Connected parts above -500 HU outside the body are hidden where the air around the body reaches them in an
/// axial plane (it does not reach the lung's vessels), but for parts that hang on the body and reach no more than 40 mm
/// from it (ears, nose, folds), and for cells beside the body, which hold some of its skin. Two more cells around what
/// is hidden are hidden with it, where they are not of the body: a boundary's voxels hold some of the table, and they
/// are brighter than air.
CoarseMask findTable(const Volume& volume);

/// findTable() as a scene holds it. An empty set where there is too little memory for the search.
std::shared_ptr<const CoarseMask> tableOf(const Volume& volume);

}  // namespace fenestra::segmentation
