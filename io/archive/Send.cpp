#include "io/archive/Send.h"

#include <algorithm>
#include <map>
#include <set>
#include <system_error>

#include <dcmtk/dcmdata/dcuid.h>

#include "io/archive/Association.h"
#include "io/archive/Classes.h"
#include "io/dicom/Dataset.h"
#include "io/dicom/DicomValues.h"

namespace fenestra::io::archive {
namespace {

namespace fs = std::filesystem;

/// A file and what it needs of an association.
struct Outgoing {
  fs::path file;
  std::string objectClass, object, syntax;
};

Outgoing outgoingOf(const fs::path& file) {
  DcmFileFormat header;
  loadHeader(file, header);
  DcmDataset& dataset = *header.getDataset();
  return {file, textOf(dataset, DCM_SOPClassUID), textOf(dataset, DCM_SOPInstanceUID),
          DcmXfer(dataset.getOriginalXfer()).getXferID()};
}

/// What the objects need; 128 contexts at most, which is more than a study has kinds of objects.
std::vector<Context> contextsFor(const std::vector<Outgoing>& objects) {
  std::set<std::pair<std::string, std::string>> kinds;
  std::set<std::string> classes;
  for (const Outgoing& each : objects) {
    classes.insert(each.objectClass);
    kinds.insert({each.objectClass, each.syntax});
  }
  std::vector<Context> contexts;
  for (const std::string& each : classes) contexts.push_back({each, plainSyntaxes()});
  for (const auto& [objectClass, syntax] : kinds)
    if (syntax != UID_LittleEndianExplicitTransferSyntax && syntax != UID_LittleEndianImplicitTransferSyntax)
      contexts.push_back({objectClass, {syntax}});
  constexpr std::size_t most = 128;
  if (contexts.size() > most) contexts.resize(most);
  return contexts;
}

Sent sendOne(Association& association, const Outgoing& outgoing) {
  Sent sent;
  sent.file = outgoing.file;
  sent.object = outgoing.object;
  sent.objectClass = outgoing.objectClass;
  const auto context = association.contextOf(outgoing.objectClass, outgoing.syntax);
  if (context == 0) {
    sent.text = "the server does not take this class of objects";
    return sent;
  }
  DcmFileFormat file;
  if (file.loadFile(outgoing.file.c_str()).bad()) throw Error(outgoing.file, "cannot be read", "");
  DcmDataset& dataset = *file.getDataset();
  const bool isPacked = DcmXfer(dataset.getOriginalXfer()).isEncapsulated();
  const bool asItIs = association.syntaxOf(context) == outgoing.syntax;
  if (isPacked && !asItIs && dataset.chooseRepresentation(EXS_LittleEndianExplicit, nullptr).bad()) {
    sent.text = "the server does not take its compression, which cannot be undone";
    return sent;
  }
  T_DIMSE_C_StoreRQ request{};
  request.MessageID = association.nextMessage();
  OFStandard::strlcpy(request.AffectedSOPClassUID, outgoing.objectClass.c_str(), sizeof request.AffectedSOPClassUID);
  OFStandard::strlcpy(request.AffectedSOPInstanceUID, outgoing.object.c_str(), sizeof request.AffectedSOPInstanceUID);
  request.DataSetType = DIMSE_DATASET_PRESENT;
  request.Priority = DIMSE_PRIORITY_MEDIUM;
  T_DIMSE_C_StoreRSP response{};
  DcmDataset* detail = nullptr;
  association.watch().beginMessage(1u << 20);
  const OFCondition result = DIMSE_storeUser(association.get(), context, &request, nullptr, &dataset, nullptr, nullptr,
                                             DIMSE_BLOCKING, 0, &response, &detail);
  const std::unique_ptr<DcmDataset> owned(detail);
  association.check(result, "sending");
  sent.status = response.DimseStatus;
  const bool warns = response.DimseStatus >> 12 == 0xb;  // kept, but changed (PS3.4 B.2.3)
  sent.accepted = response.DimseStatus == STATUS_Success || warns;
  if (warns) sent.text = "the server keeps it with a change";
  if (!sent.accepted) {
    sent.text = owned ? textOf(*owned, DCM_ErrorComment) : "";
    if (sent.text.empty()) sent.text = meaningOf(response.DimseStatus);
  }
  return sent;
}

}  // namespace

std::vector<fs::path> filesToSend(const std::vector<fs::path>& paths) {
  std::vector<fs::path> files;
  const auto add = [&](const fs::path& file) {
    DcmFileFormat header;
    try {
      prepareDcmtk();
      loadHeader(file, header);
    } catch (const Error&) {
      return false;
    }
    if (textOf(*header.getDataset(), DCM_SOPInstanceUID).empty()) return false;  // such as a DICOMDIR
    files.push_back(file);
    return true;
  };
  for (const fs::path& path : paths) {
    std::error_code failure;
    if (!fs::is_directory(path, failure)) {
      if (!fs::exists(path, failure)) throw Error(path, "does not exist", "check the path");
      if (!add(path)) throw Error(path, "is no DICOM object", "name DICOM files, or folders that hold some");
      continue;
    }
    std::vector<fs::path> inside;
    for (const auto& entry :
         fs::recursive_directory_iterator(path, fs::directory_options::skip_permission_denied, failure))
      if (entry.is_regular_file(failure)) inside.push_back(entry.path());
    std::sort(inside.begin(), inside.end());
    for (const fs::path& each : inside) add(each);
  }
  return files;
}

std::string objectOf(const fs::path& file) { return outgoingOf(file).object; }

std::vector<Sent> send(const Server& server, const std::vector<fs::path>& files, const Progress& progress) {
  Task task(server.limits, progress, "sending to the archive");
  prepareDcmtk();
  std::vector<Outgoing> objects;
  for (const fs::path& file : files) {
    task.checkCancelled();
    objects.push_back(outgoingOf(file));
  }
  std::vector<Sent> sent;
  if (objects.empty()) return sent;
  Association association(server, contextsFor(objects), task);
  for (const Outgoing& each : objects) {
    task.setFraction(static_cast<double>(sent.size()) / static_cast<double>(objects.size()));
    sent.push_back(sendOne(association, each));
  }
  association.release();
  return sent;
}

}  // namespace fenestra::io::archive
