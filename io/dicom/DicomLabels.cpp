#include "io/dicom/DicomLabels.h"

#include "io/dicom/Dataset.h"
#include "io/dicom/DicomValues.h"
#include "io/dicom/LabelObject.h"
#include "io/dicom/RtStruct.h"
#include "io/dicom/Segmentation.h"

namespace fenestra::io {
LabelsOnGrid readDicomLabels(const std::filesystem::path& path, const Grid& target, const Progress& progress) {
  if (std::filesystem::is_directory(path))
    throw Error(path, "is a folder, not a label map", "name the file with the labels");
  DcmFileFormat file;
  loadHeader(path, file);
  DcmDataset& dataset = *file.getDataset();
  const std::string sopClass = textOf(dataset, DCM_SOPClassUID);
  if (!isLabelClass(sopClass))
    throw Error(path, "is DICOM, but neither a segmentation nor a structure set", "open it as a volume");
  if (sopClass == UID_RTStructureSetStorage) return readStructureSet(dataset, path, target, progress);
  return readSegmentation(dataset, path, target, progress);
}

}  // namespace fenestra::io
