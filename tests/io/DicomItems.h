#pragma once
// DICOM attributes set in one line each, for the tests' own files.

#include <cstdio>
#include <string>

#include <gtest/gtest.h>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <glm/glm.hpp>

namespace fenestra::tests {

inline std::string numberText(double value) {
  // A decimal string holds 16 characters.
  char text[32];
  for (int digits = 15; digits > 5; --digits) {
    std::snprintf(text, sizeof text, "%.*g", digits, value);
    if (std::string(text).size() <= 16) break;
  }
  return text;
}

inline std::string vectorText(const glm::dvec3& v) {
  return numberText(v.x) + "\\" + numberText(v.y) + "\\" + numberText(v.z);
}

inline void put(DcmItem& item, const DcmTagKey& tag, const std::string& value) {
  ASSERT_TRUE(item.putAndInsertString(tag, value.c_str()).good()) << value;
}
inline void put(DcmItem& item, const DcmTagKey& tag, int value) {
  ASSERT_TRUE(item.putAndInsertUint16(tag, static_cast<Uint16>(value)).good());
}
inline DcmItem& itemOf(DcmItem& parent, const DcmTagKey& sequence, long index = 0) {
  DcmItem* item = nullptr;
  parent.findOrCreateSequenceItem(sequence, item, index);
  return *item;
}

}  // namespace fenestra::tests
