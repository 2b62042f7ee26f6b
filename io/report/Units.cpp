#include "io/report/Units.h"

#include <algorithm>
#include <array>

namespace fenestra::io::report {
namespace {

struct KnownUnit {
  const char *name, *code, *meaning;
};
/// Units of CID 7181; "name" is what Volume::unit says.
constexpr std::array<KnownUnit, 8> knownUnits{{{"HU", "[hnsf'U]", "Hounsfield Unit"},
                                               {"Gy", "Gy", "Gy"},
                                               {"Bq/ml", "Bq/ml", "Becquerels/milliliter"},
                                               {"BQML", "Bq/ml", "Becquerels/milliliter"},
                                               {"%", "%", "Percent"},
                                               {"mm2/s", "mm2/s", "mm2/s"},
                                               {"ms", "ms", "millisecond"},
                                               {"s", "s", "second"}}};

}  // namespace

DSRCodedEntryValue unitCode(const std::string& unit) {
  for (const KnownUnit& known : knownUnits)
    if (unit == known.name) return {known.code, "UCUM", known.meaning};
  const bool isAnnotation = !unit.empty() && unit.size() <= 14 &&  // of a code value's 16 characters
                            std::all_of(unit.begin(), unit.end(), [](char c) {
                              return c > 0x20 && c < 0x7f && c != '{' && c != '}' && c != '\\';
                            });
  if (isAnnotation) return {("{" + unit + "}").c_str(), "UCUM", unit.c_str()};
  return {"[arb'U]", "UCUM", "arbitrary unit"};
}

DSRCodedEntryValue valueCode(Modality modality, const std::string& unit) {
  if (modality == Modality::CT && unit == "HU") return {"112031", "DCM", "Attenuation Coefficient"};
  if (modality == Modality::MR) return {"110852", "DCM", "MR signal intensity"};
  if (modality == Modality::PT && (unit == "Bq/ml" || unit == "BQML"))
    return {"110821", "DCM", "Nuclear Medicine Tomographic Activity"};
  // No code of the standard says "whatever the voxels hold"; schemes that begin with 99 are private (PS3.16 8).
  return {"VALUE", "99FENESTRA", "Voxel value"};
}

}  // namespace fenestra::io::report
