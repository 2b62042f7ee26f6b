#pragma once
// Codes of what is measured, and of units. Include in .cpp files alone.

#include <string>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmsr/dsrcodvl.h>

#include "rendering/volume/Volume.h"

namespace fenestra::io::report {

/// The unit of a volume's values by UCUM; one that has no code there is an annotation of the unit one, and where there
/// is none it is arbitrary.
DSRCodedEntryValue unitCode(const std::string& unit);
/// What a volume's values are.
DSRCodedEntryValue valueCode(Modality modality, const std::string& unit);

}  // namespace fenestra::io::report
