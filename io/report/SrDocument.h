#pragma once
// What structured reports and key object selections share. Include in .cpp files alone.

#include <filesystem>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmsr/dsrdoc.h>

#include "io/report/Origin.h"

namespace fenestra::io::report {

/// Patient and study of the origin, a new series of this description and number, and the program that makes it.
void beginDocument(DSRDocument& document, Origin& origin, const std::string& description, const char* seriesNumber,
                   const std::filesystem::path& file);
void saveDocument(DSRDocument& document, const std::filesystem::path& file);

}  // namespace fenestra::io::report
