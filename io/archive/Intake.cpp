#include "io/archive/Intake.h"

#include <unistd.h>
#include <memory>
#include <system_error>

#include <dcmtk/dcmdata/dcostrmf.h>
#include <dcmtk/dcmnet/cond.h>
#include <dcmtk/dcmnet/dul.h>

#include "io/archive/WholeObject.h"
#include "io/base/Error.h"
#include "io/dicom/Dataset.h"
#include "io/dicom/DicomValues.h"

namespace fenestra::io::archive {

namespace fs = std::filesystem;

namespace {

/// Calls `take` with each fragment of the data set that follows a command, to its end whatever becomes of them. DCMTK's
/// own DIMSE_receiveDataSetInFile waits for more than there is once a disk is full.
template <class Take>
OFCondition eachFragment(T_ASC_Association* association, T_ASC_PresentationContextID context, const Take& take) {
  for (;;) {
    DUL_PDV fragment{};
    if (DUL_NextPDV(&association->DULassociation, &fragment).bad()) {
      const OFCondition read = DUL_ReadPDVs(&association->DULassociation, nullptr, DUL_BLOCK, 0);
      if (read != DUL_PDATAPDUARRIVED) return read.bad() ? read : DIMSE_READPDVFAILED;
      if (const OFCondition next = DUL_NextPDV(&association->DULassociation, &fragment); next.bad()) return next;
    }
    if (fragment.presentationContextID != context || fragment.pdvType != DUL_DATASETPDV) return DIMSE_UNEXPECTEDPDVTYPE;
    take(fragment);
    if (fragment.lastPDV) return EC_Normal;
  }
}

}  // namespace

void Intake::expect(const Wanted& wanted, Wanted missing, std::optional<std::size_t> total) {
  const std::lock_guard lock(mutex_);
  part_ = cache_.partOf(wanted.study, wanted.series);
  wanted_ = std::move(missing);
  total_ = total.value_or(wanted.objects.size());
  received_ = 0;
  if (!arrived_) return;
  for (const auto& [object, objectClass] : wanted.objects) {
    if (wanted_.objects.contains(object)) continue;
    const fs::path name = cacheName(object) + ".dcm", here = part_ / name;
    tell(object, fs::exists(here) ? here : cache_.folderOf(wanted.study, wanted.series) / name);
  }
}

void Intake::tell(const std::string& object, const fs::path& file) {
  if (!arrived_ || !told_.insert(object).second) return;
  const auto number = wanted_.numbers.find(object);
  arrived_({wanted_.series, file, number == wanted_.numbers.end() ? 0 : number->second, total_});
}

std::string Intake::failure() const {
  const std::lock_guard lock(mutex_);
  return failure_;
}

DIC_US Intake::verdictOn(const T_DIMSE_C_StoreRQ& request) {
  const std::lock_guard lock(mutex_);
  const auto at = wanted_.objects.find(request.AffectedSOPInstanceUID);
  if (at == wanted_.objects.end()) return STATUS_STORE_Refused_NotAuthorized;
  if (!at->second.empty() && at->second != request.AffectedSOPClassUID)
    return STATUS_STORE_Error_DataSetDoesNotMatchSOPClass;
  return isFull() ? STATUS_STORE_Refused_OutOfResources : STATUS_Success;
}

bool Intake::isFull() {
  std::error_code unknown;
  const fs::space_info space = fs::space(part_, unknown);
  if (unknown || space.available >= limits_.freeDiskBytes) return false;
  failure_ = "the disk of " + cache_.root().string() + " is full";
  return true;
}

fs::path Intake::newFile() {
  const std::lock_guard lock(mutex_);
  if (isFull()) throw Error(cache_.root(), "the disk is full", "make room, and try again; what came is kept");
  // Unique among programs, too: where a file system knows no locks, two may retrieve the same series.
  return part_ / ("incoming-" + std::to_string(getpid()) + "-" + std::to_string(files_++));
}

void Intake::dropLast() {
  const std::lock_guard lock(mutex_);
  std::error_code ignored;
  if (!last_.empty() && fs::remove(last_, ignored)) --received_;
  last_.clear();
}

void Intake::take(const fs::path& file) {
  if (keep(file, "") == STATUS_Success)
    ++received_;
  else
    ++refused_;
  std::error_code ignored;
  fs::remove(file, ignored);
}

OFCondition Intake::readInto(const fs::path& file, T_ASC_Association* association, T_ASC_PresentationContextID context,
                             const T_DIMSE_C_StoreRQ& request, bool& isWritten) {
  DcmOutputFileStream* made = nullptr;
  const OFCondition opened = DIMSE_createFilestream(file.c_str(), &request, association, context, 1, &made);
  std::unique_ptr<DcmOutputFileStream> stream(made);
  isWritten = opened.good();
  if (opened.bad()) return opened;
  bool isTaken = true;  // a full disk takes a part, which the stream does not call a failure
  const OFCondition result = eachFragment(association, context, [&](const DUL_PDV& fragment) {
    activity_.note();
    const auto length = static_cast<offile_off_t>(fragment.fragmentLength);
    isTaken = isTaken && stream->good() && stream->write(fragment.data, length) == length;
  });
  const bool isGood = isTaken && stream->good();
  const auto bytes = static_cast<std::uintmax_t>(stream->tell());
  stream.reset();  // which writes what the stream has held back, and says nothing where it cannot
  std::error_code unknown;
  isWritten = isGood && fs::file_size(file, unknown) == bytes;
  return result;
}

void Intake::noteUnwritten() {
  std::error_code unknown;
  constexpr std::uintmax_t nothing = 1u << 20;  // of a disk that another writer has left some room meanwhile
  const bool isOut = fs::space(part_, unknown).available < nothing && !unknown;
  const std::lock_guard lock(mutex_);
  failure_ = isOut ? "the disk of " + cache_.root().string() + " is full"
                   : "objects cannot be written to " + cache_.root().string();
}

DIC_US Intake::keep(const fs::path& file, const std::string& object) {
  DcmFileFormat read;
  try {
    loadHeader(file, read);
  } catch (const Error&) {
    return STATUS_STORE_Error_CannotUnderstand;
  }
  DcmDataset& dataset = *read.getDataset();
  if (!isWholeObject(dataset, file)) return STATUS_STORE_Error_CannotUnderstand;
  const std::lock_guard lock(mutex_);
  const std::string uid = textOf(dataset, DCM_SOPInstanceUID);
  if (textOf(dataset, DCM_StudyInstanceUID) != wanted_.study ||
      textOf(dataset, DCM_SeriesInstanceUID) != wanted_.series || !wanted_.objects.contains(uid) ||
      (!object.empty() && object != uid))
    return STATUS_STORE_Error_DataSetDoesNotMatchSOPClass;
  std::error_code failed;
  fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write, failed);
  const fs::path kept = part_ / (cacheName(uid) + ".dcm");
  fs::rename(file, kept, failed);
  if (!failed) {
    last_ = kept;
    tell(uid, kept);
    return STATUS_Success;
  }
  failure_ = "objects cannot be written to " + cache_.root().string();
  return STATUS_STORE_Refused_OutOfResources;
}

OFCondition Intake::receive(T_ASC_Association* association, T_ASC_PresentationContextID context,
                            const T_DIMSE_C_StoreRQ& request, Watch& watch) {
  DIC_US status = verdictOn(request);
  watch.beginMessage(limits_.objectBytes);
  OFCondition result = EC_Normal;
  if (status == STATUS_Success) {
    const fs::path file = newFile();
    bool isWritten = false;
    result = readInto(file, association, context, request, isWritten);
    // A connection that breaks leaves a part of an object, too, but that one is written.
    if (!isWritten) noteUnwritten();
    status = STATUS_STORE_Refused_OutOfResources;
    if (result.good() && isWritten) status = keep(file, request.AffectedSOPInstanceUID);
    std::error_code ignored;
    fs::remove(file, ignored);
  } else {
    DIC_UL bytes = 0, parts = 0;
    result = DIMSE_ignoreDataSet(association, DIMSE_BLOCKING, 0, &bytes, &parts);
  }
  if (status == STATUS_Success && result.good())
    ++received_;
  else
    ++refused_;
  if (result.bad()) return result;
  T_DIMSE_C_StoreRSP response{};
  response.MessageIDBeingRespondedTo = request.MessageID;
  OFStandard::strlcpy(response.AffectedSOPClassUID, request.AffectedSOPClassUID, sizeof response.AffectedSOPClassUID);
  OFStandard::strlcpy(response.AffectedSOPInstanceUID, request.AffectedSOPInstanceUID,
                      sizeof response.AffectedSOPInstanceUID);
  response.DataSetType = DIMSE_DATASET_NULL;
  response.DimseStatus = status;
  response.opts = O_STORE_AFFECTEDSOPCLASSUID | O_STORE_AFFECTEDSOPINSTANCEUID;
  return DIMSE_sendStoreResponse(association, context, &request, &response, nullptr);
}

}  // namespace fenestra::io::archive
