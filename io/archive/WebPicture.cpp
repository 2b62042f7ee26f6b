#include "io/archive/WebPicture.h"

#include <algorithm>
#include <array>
#include <vector>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcuid.h>

#include "io/archive/Http.h"
#include "io/archive/Records.h"
#include "io/archive/Task.h"
#include "io/archive/WebAnswers.h"
#include "io/dicom/Dcmtk.h"

namespace fenestra::io::archive {
namespace {

/// Limit for one picture: a screen's worth of pixels as PNG.
constexpr std::uint64_t mostPictureBytes = 8u << 20;

/// The objects of the series at `path` that match, or none where the server answers with a failure.
std::vector<Attributes> objectsAt(Http& http, const WebServer& server, const std::string& path,
                                  const std::string& key) {
  const std::string fields = "&includefield=SOPClassUID&includefield=ImageType&includefield=BurnedInAnnotation";
  const Http::Answer answer = http.get(path + "/instances?limit=1" + key + fields, "application/dicom+json");
  if (answer.status == 401 || answer.status == 403) refuseStatus(server, answer.status);
  if (answer.status / 100 != 2) return {};
  return attributesInJson(answer.body).value_or(std::vector<Attributes>{});
}

/// The bytes at `path`, where they begin as a JPEG or PNG.
std::optional<std::string> pixelsAt(Http& http, const WebServer& server, const std::string& path) {
  std::string bytes;
  const auto sinkFor = [&](const Http::Answer&) {
    return [&](std::string_view more) {
      bytes += more;
      return bytes.size() <= mostPictureBytes;
    };
  };
  // Which every server draws (PS3.18 8.7.4); Orthanc 1.10 refuses a list of types.
  const Http::Answer answer = http.get(path, "image/jpeg", sinkFor, mostPictureBytes);
  if (answer.status == 401 || answer.status == 403) refuseStatus(server, answer.status);
  constexpr std::string_view jpeg = "\xff\xd8\xff", png = "\x89PNG\r\n\x1a\n";
  if (answer.status / 100 != 2 || !(bytes.starts_with(jpeg) || bytes.starts_with(png))) return std::nullopt;
  return bytes;
}

}  // namespace

bool couldShowNames(const std::string& burnedIn, const std::string& objectClass, const std::string& imageType) {
  if (burnedIn == "NO") return false;
  constexpr std::array scanners{UID_CTImageStorage,
                                UID_EnhancedCTImageStorage,
                                UID_MRImageStorage,
                                UID_EnhancedMRImageStorage,
                                UID_PositronEmissionTomographyImageStorage,
                                UID_EnhancedPETImageStorage};
  // A report that a scanner draws as an image, such as one of doses, is DERIVED or SECONDARY.
  return burnedIn == "YES" || std::find(scanners.begin(), scanners.end(), objectClass) == scanners.end() ||
         !(imageType == "ORIGINAL\\PRIMARY" || imageType.starts_with("ORIGINAL\\PRIMARY\\"));
}

std::optional<WebPicture> pictureOf(const WebServer& server, const std::string& study, const std::string& series,
                                    std::size_t objects, int side, const Progress& progress) {
  prepareDcmtk();
  Task task(server.limits, progress, "fetching a picture of a series");
  Http http(server, task);
  const std::string path = "/studies/" + http.escaped(study) + "/series/" + http.escaped(series);
  const std::string middle = std::to_string(objects / 2 + 1);
  std::vector<Attributes> found = objectsAt(http, server, path, "&InstanceNumber=" + middle);
  // Servers may number them otherwise, or match by no number.
  if (found.empty()) found = objectsAt(http, server, path, "&offset=" + std::to_string(objects / 2));
  if (found.empty()) found = objectsAt(http, server, path, "");
  if (found.empty()) return std::nullopt;
  const Attributes& object = found[found.size() / 2];  // all of them, where the server knows no limit
  const std::string at = path + "/instances/" + http.escaped(valueOf(object, "SOPInstanceUID"));
  const std::string viewport = "?viewport=" + std::to_string(side) + "," + std::to_string(side);
  for (const char* resource : {"/rendered", "/thumbnail"})
    if (std::optional<std::string> bytes = pixelsAt(http, server, at + resource + viewport))
      return WebPicture{std::move(*bytes),
                        couldShowNames(valueOf(object, "BurnedInAnnotation"), valueOf(object, "SOPClassUID"),
                                       valueOf(object, "ImageType"))};
  return std::nullopt;
}

}  // namespace fenestra::io::archive
