#include "io/deidentify/Values.h"

#include <algorithm>
#include <array>

namespace fenestra::io::deidentify {
namespace {

/// Where a value cannot be replaced, because the file gives it a form that its VR does not have, it goes.
void replaceOrClear(DcmElement& element, const OFCondition& replaced) {
  if (replaced.bad()) element.clear();
}

/// A value of zeros.
void zero(DcmElement& element, std::size_t bytes) {
  const std::array<Uint8, 8> zeros{};
  replaceOrClear(element, element.putUint8Array(zeros.data(), static_cast<unsigned long>(bytes)));
}

}  // namespace

std::uint32_t numberOf(const DcmTagKey& key) { return std::uint32_t{key.getGroup()} << 16 | key.getElement(); }

bool isText(DcmEVR vr) {
  constexpr std::array text{EVR_SH, EVR_LO, EVR_ST, EVR_LT, EVR_UC, EVR_UT, EVR_PN, EVR_AE, EVR_UR, EVR_CS};
  return std::find(text.begin(), text.end(), vr) != text.end();
}

bool isTemporal(DcmEVR vr) { return vr == EVR_DA || vr == EVR_TM || vr == EVR_DT; }

std::string textIn(DcmElement& element) {
  OFString text;
  if (element.isLeaf() && element.getOFStringArray(text).good()) return {text.c_str(), text.size()};
  return {};
}

void setText(DcmElement& element, const std::string& text) {
  replaceOrClear(element, element.putString(text.c_str(), static_cast<Uint32>(text.size())));
}

void makeDummy(DcmElement& element) {
  if (element.getLength() == 0) return;
  switch (element.ident()) {
    case EVR_DA:
      return setText(element, "19000101");
    case EVR_TM:
      return setText(element, "000000");
    case EVR_DT:
      return setText(element, "19000101000000");
    case EVR_AS:
      return setText(element, "000Y");
    case EVR_UR:
      return setText(element, "about:blank");
    case EVR_IS:
    case EVR_DS:
    case EVR_US:
    case EVR_SS:
    case EVR_UL:
    case EVR_SL:
    case EVR_UV:
    case EVR_SV:
    case EVR_FL:
    case EVR_FD:
      return setText(element, "0");
    case EVR_OL:
      return replaceOrClear(element, element.putUint32Array(std::array<Uint32, 1>{}.data(), 1));
    case EVR_OF:
      return replaceOrClear(element, element.putFloat32Array(std::array<Float32, 1>{}.data(), 1));
    case EVR_OD:
      return replaceOrClear(element, element.putFloat64Array(std::array<Float64, 1>{}.data(), 1));
    case EVR_OW:
      return replaceOrClear(element, element.putUint16Array(std::array<Uint16, 1>{}.data(), 1));
    default:
      if (isText(element.ident()))
        setText(element, dummyText);
      else
        zero(element, element.ident() == EVR_OV ? 8 : 2);
  }
}

bool namesKind(const DcmTagKey& key) {
  static const std::array kinds{DCM_SOPClassUID,
                                DCM_ReferencedSOPClassUID,
                                DCM_MediaStorageSOPClassUID,
                                DCM_RelatedGeneralSOPClassUID,
                                DCM_OriginalSpecializedSOPClassUID,
                                DCM_SOPClassesInStudy,
                                DCM_SOPClassesSupported,
                                DCM_ReferencedSOPClassUIDInFile,
                                DCM_ReferencedTransferSyntaxUIDInFile,
                                DCM_EncryptedContentTransferSyntaxUID,
                                DCM_MACCalculationTransferSyntaxUID,
                                DCM_CodingSchemeUID,
                                DCM_ContextUID,
                                DCM_MappingResourceUID,
                                DCM_ContextGroupExtensionCreatorUID,
                                DCM_TransferSyntaxUID,
                                DCM_AvailableTransferSyntaxUID};
  return std::find(kinds.begin(), kinds.end(), key) != kinds.end();
}

}  // namespace fenestra::io::deidentify
