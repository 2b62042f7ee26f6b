#pragma once
// Colours of labels whose file gives them none: those of anatomical atlases, by the words of the label's name.

#include <cstdint>
#include <string_view>

#include <glm/glm.hpp>

namespace fenestra::io {

/// Display RGB, 0..1. Names are understood as TotalSegmentator, AAL, FreeSurfer and 3D Slicer write them ("kidney_left",
/// "Frontal_Sup_L", "Left-Lateral-Ventricle", "left lung"). Sides make no difference. Parts of one structure (vertebrae,
/// ribs, gyri) differ in brightness. A name that no entry of resources/labels/colours.tsv fits gets
/// defaultLabelColour(value).
glm::dvec3 labelColour(std::uint16_t value, std::string_view name);

}  // namespace fenestra::io
