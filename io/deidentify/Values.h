#pragma once
// Values of DCMTK's elements: their text, and dummies in their place. Include in .cpp files alone.

#include <string>

#include "io/dicom/Dcmtk.h"

namespace fenestra::io::deidentify {

inline constexpr const char* dummyText = "REMOVED";

/// Group · 65536 + element.
std::uint32_t numberOf(const DcmTagKey& key);
/// Whether a VR holds words that people type or that programs make of them.
bool isText(DcmEVR vr);
bool isTemporal(DcmEVR vr);  ///< DA, TM, DT
/// The value of an element of any VR of text, its parts between backslashes; empty for others.
std::string textIn(DcmElement& element);
/// Replaces all values by one dummy of the VR, which has a length (PS3.15 table E.1-1a, D); an empty element stays.
void makeDummy(DcmElement& element);
/// Replaces the value; an element that takes no text becomes empty.
void setText(DcmElement& element, const std::string& text);

/// UIDs that name a kind of object, coding or scheme, and no instance; they say nothing about a person.
bool namesKind(const DcmTagKey& key);

}  // namespace fenestra::io::deidentify
