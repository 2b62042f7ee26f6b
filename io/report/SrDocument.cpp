#include "io/report/SrDocument.h"

namespace fenestra::io::report {

void beginDocument(DSRDocument& document, Origin& origin, const std::string& description, const char* seriesNumber,
                   const std::filesystem::path& file) {
  require(document.setSpecificCharacterSetType(DSRTypes::CS_UTF8), file, "its character set");
  require(document.readStudyData(origin.dataset()), file, "patient and study");
  document.createNewSeries();
  require(document.setSeriesDescription(longString(description).c_str(), OFFalse), file, "its series");
  require(document.setSeriesNumber(seriesNumber), file, "its series");
  require(document.setInstanceNumber("1"), file, "its number");
  require(document.setManufacturer("Fenestra"), file, "its maker");
  require(document.setManufacturerModelName("Fenestra"), file, "its maker");
  require(document.setDeviceSerialNumber("0"), file, "its maker");
  require(document.setSoftwareVersions("1"), file, "its maker");
}

void saveDocument(DSRDocument& document, const std::filesystem::path& file) {
  DcmFileFormat whole;
  require(document.write(*whole.getDataset()), file, "the dataset");
  save(whole, file);
}

}  // namespace fenestra::io::report
