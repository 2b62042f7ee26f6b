#include "io/archive/Records.h"

#include <algorithm>

#include "io/dicom/Dcmtk.h"

namespace fenestra::io::archive {

std::string problemOf(const std::string& keyword, const std::string& value) {
  DcmTag tag;
  if (DcmTag::findTagFromName(keyword.c_str(), tag).bad())
    return "\"" + keyword + "\" is no attribute of DICOM; name it as PatientName or AccessionNumber";
  const DcmEVR vr = tag.getEVR();
  const bool isNumber = vr == EVR_US || vr == EVR_SS || vr == EVR_UL || vr == EVR_SL;
  if (!(isNumber || DcmVR(vr).isaString()) || keyword == "SpecificCharacterSet")
    return "\"" + keyword + "\" cannot be searched for";
  if (std::any_of(value.begin(), value.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20; }))
    return "the value of " + keyword + " holds a control character";
  return {};
}

std::string valueOf(const Attributes& record, const std::string& keyword) {
  const auto at = record.find(keyword);
  return at == record.end() ? std::string() : at->second;
}

}  // namespace fenestra::io::archive
