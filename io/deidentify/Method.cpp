#include "io/deidentify/Method.h"

#include <new>

namespace fenestra::io::deidentify {
namespace {

void require(const OFCondition& condition) {
  if (condition.bad()) throw std::bad_alloc();
}

}  // namespace

std::vector<MethodCode> methodCodes(const Options& options, bool keepsPrivate) {
  std::vector<MethodCode> codes{{"113100", "Basic Application Confidentiality Profile"}};
  if (options.cleanGraphics) codes.push_back({"113103", "Clean Graphics Option"});
  if (options.cleanDescriptors) codes.push_back({"113105", "Clean Descriptors Option"});
  if (options.retainDates) codes.push_back({"113106", "Retain Longitudinal Temporal Information Full Dates Option"});
  if (options.retainUids) codes.push_back({"113110", "Retain UIDs Option"});
  if (keepsPrivate) codes.push_back({"113111", "Retain Safe Private Option"});
  return codes;
}

void writeMethod(DcmItem& object, const Options& options, bool keepsPrivate) {
  require(object.putAndInsertString(DCM_PatientIdentityRemoved, "YES"));
  require(
      object.putAndInsertString(DCM_DeidentificationMethod, "DICOM PS3.15 annex E, table E.1-1 of 2024, by Fenestra"));
  object.findAndDeleteElement(DCM_DeidentificationMethodCodeSequence);
  for (const MethodCode& code : methodCodes(options, keepsPrivate)) {
    DcmItem* item = nullptr;
    require(object.findOrCreateSequenceItem(DCM_DeidentificationMethodCodeSequence, item, -2));
    require(item->putAndInsertString(DCM_CodeValue, code.value));
    require(item->putAndInsertString(DCM_CodingSchemeDesignator, "DCM"));
    require(item->putAndInsertString(DCM_CodeMeaning, code.meaning));
  }
  require(object.putAndInsertString(DCM_LongitudinalTemporalInformationModified,
                                    options.retainDates ? "UNMODIFIED" : "REMOVED"));
}

}  // namespace fenestra::io::deidentify
