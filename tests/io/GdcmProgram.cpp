// Writes to standard output what GDCM reads from the files named: a GdcmRecord each, the stored words, the modality
// table.

#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

#include <gdcmByteValue.h>
#include <gdcmImageHelper.h>
#include <gdcmImageReader.h>
#include <gdcmSequenceOfItems.h>
#include <gdcmTrace.h>

#include "tests/io/GdcmPeer.h"

namespace {

std::vector<std::uint16_t> words(const gdcm::DataSet& dataset, std::uint16_t element) {
  const gdcm::ByteValue* bytes = dataset.GetDataElement(gdcm::Tag(0x0028, element)).GetByteValue();
  if (!bytes) return {};
  std::vector<std::uint16_t> result(bytes->GetLength() / 2);
  std::memcpy(result.data(), bytes->GetPointer(), result.size() * 2);
  return result;
}

void write(const void* bytes, std::size_t size) { std::fwrite(bytes, 1, size, stdout); }

void writeFile(const std::string& path) {
  fenestra::tests::GdcmRecord record;
  gdcm::ImageReader reader;
  reader.SetFileName(path.c_str());
  if (!reader.Read()) return write(&record, sizeof record);
  const gdcm::Image& image = reader.GetImage();
  std::vector<char> bytes(image.GetBufferLength());
  if (!image.GetBuffer(bytes.data())) return write(&record, sizeof record);
  record.isImage = 1;
  record.isSigned = image.GetPixelFormat().GetPixelRepresentation() == 1;
  record.bitsAllocated = image.GetPixelFormat().GetBitsAllocated();
  for (unsigned axis = 0; axis < image.GetNumberOfDimensions(); ++axis)
    record.dims[static_cast<int>(axis)] = static_cast<int>(image.GetDimension(axis));
  for (unsigned i = 0; i < 3; ++i) {
    const auto axis = static_cast<int>(i);
    record.origin[axis] = image.GetOrigin(i);
    record.spacing[axis] = image.GetSpacing(i);
    record.row[axis] = image.GetDirectionCosines(i);
    record.column[axis] = image.GetDirectionCosines(i + 3);
  }
  record.slope = image.GetSlope();
  record.intercept = image.GetIntercept();
  std::vector<std::uint16_t> table;
  const gdcm::DataSet& dataset = reader.GetFile().GetDataSet();
  if (const gdcm::Tag sequence(0x0028, 0x3000); dataset.FindDataElement(sequence)) {
    const gdcm::DataSet& item = dataset.GetDataElement(sequence).GetValueAsSQ()->GetItem(1).GetNestedDataSet();
    const std::vector<std::uint16_t> descriptor = words(item, 0x3002);
    if (descriptor.size() == 3)
      record.lutFirst = record.isSigned ? static_cast<std::int16_t>(descriptor[1]) : descriptor[1];
    table = words(item, 0x3006);
  }
  record.lutEntries = table.size();
  record.wordBytes = bytes.size();
  write(&record, sizeof record);
  write(bytes.data(), bytes.size());
  write(table.data(), table.size() * 2);
}

}  // namespace

int main(int count, char** arguments) {
  gdcm::Trace::WarningOff();
  gdcm::Trace::ErrorOff();
  // MR images' rescales are ignored unless forced; a dose's own scaling is ignored when they are.
  gdcm::ImageHelper::SetForceRescaleInterceptSlope(std::string(arguments[1]) != "dose");
  gdcm::ImageHelper::SetForcePixelSpacing(true);
  for (int i = 2; i < count; ++i) writeFile(arguments[i]);
}
