#include "app/DataOptions.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "app/options/Numbers.h"
#include "app/options/WordOptions.h"
#include "io/PhantomFile.h"
#include "io/VolumeReader.h"
#include "io/base/SessionName.h"
#include "io/base/Words.h"

namespace fenestra::app {
namespace {

/// PATH and --phantom, one of which names the data.
Option addSource(Command command, io::DataRequest& request, std::function<void()> onSession) {
  const Option path =
      command.add("PATH", "PATH", "DICOM folder or file, NIfTI, NRRD, MetaImage, raw with --raw, or a session",
                  [&request, onSession = std::move(onSession)](const std::string& text) {
                    request.path = text;
                    if (io::isSession(request.path)) onSession();
                    return !text.empty();
                  });
  std::string names;
  for (const std::string& name : io::phantomNames()) names += (names.empty() ? "" : "|") + name;
  const Option phantom =
      command.add("--phantom", names, "a built-in phantom instead of PATH", [&request](const std::string& text) {
        const std::vector<std::string> known = io::phantomNames();
        request.phantom = text;
        return std::find(known.begin(), known.end(), text) != known.end();
      });
  path.as("").excludes(phantom);
  command
      .add("--phantom-voxels", "1..1024", "voxels along the phantom's longest side, default 256",
           [&request](const std::string& text) {
             request.phantomVoxels = parseNumber<int>(text).value_or(0);
             return request.phantomVoxels >= 1 && request.phantomVoxels <= 1024;
           })
      .needs(phantom);
  return phantom;
}

/// Which of the volumes in PATH.
void addSeries(Command command, io::DataRequest& request, Option phantom) {
  command.addValue("--series", request.series, "the series' UID; the thinnest acquired volume otherwise")
      .as("UID")
      .excludes(phantom);
  command
      .add("--time", "N", "time point, from 1, where PATH holds several volumes of one place",
           [&request](const std::string& text) {
             request.time = parseNumber<int>(text);
             return request.time && *request.time >= 1;
           })
      .excludes(phantom);
  command
      .addFlag("--allow-outside", request.allowOutside,
               "let a header name voxel files outside its folder; only for headers that you trust")
      .excludes(phantom);
}

void addRaw(Command command, io::DataRequest& request, Option phantom) {
  command
      .add("--raw", "WxHxD:TYPE[:le|be][:skip=BYTES]", "how to read PATH's bytes, e.g. 256x256x128:uint16:be:skip=512",
           [&request](const std::string& text) {
             try {
               request.raw = io::parseRawDescription(text);
               return true;
             } catch (const io::Error& error) {
               throw WrongValue{error.cause() + "; " + error.hint()};
             }
           })
      .excludes(phantom);
}

/// How the volume is understood, and where a session's volume is.
void addReading(Command command, io::DataRequest& request, Option phantom) {
  addWords<io::Regularise>(command, "--regularise",
                           "resample slices that lie unevenly or askew onto even planes, default auto: linearly where "
                           "slices would be misplaced otherwise",
                           request.regularise)
      .excludes(phantom);
  addWords<Modality>(command, "--modality",
                     "what a volume is whose file does not say, default CT where its values are Hounsfield units",
                     request.modality)
      .excludes(phantom);
  command
      .add("--data", "PATH", "where the volume of a session is now, when it has moved or changed",
           [&request](const std::string& text) {
             if (!io::isSession(request.path)) throw WrongValue{"needs a session as PATH"};
             request.data = text;
             return true;
           })
      .excludes(phantom);
}

}  // namespace

void addVolumeOptions(Command command, io::DataRequest& request, std::function<void()> onSession,
                      std::optional<double>* pixel) {
  command.group("Volume");
  const Option phantom = addSource(command, request, std::move(onSession));
  addSeries(command, request, phantom);
  addRaw(command, request, phantom);
  addReading(command, request, phantom);
  // --raw has been read by now.
  const auto takeVoxels = [&request](const std::string& text) {
    const std::optional<glm::dvec3> spacing = parseVector(text);
    if (!spacing || !glm::all(glm::greaterThan(*spacing, glm::dvec3(0.0)))) return false;
    // Which format a file has is known when it is read.
    std::error_code unknown;
    if (!request.raw && !std::filesystem::exists(request.path, unknown))
      throw WrongValue{"needs --raw, or a stack of TIFF as PATH"};
    if (request.raw)
      request.raw->spacing = *spacing;
    else
      request.spacing = *spacing;
    return true;
  };
  const std::string ofVoxels = "mm between the voxels of --raw, or of a TIFF stack";
  if (!pixel) {
    command.add("--spacing", "X,Y,Z", ofVoxels, takeVoxels).excludes(phantom);
  } else {
    const auto take = [=](const std::vector<std::string>& texts) {
      for (const std::string& text : texts) {
        if (const std::optional<double> mm = parseNumber<double>(text)) {
          if (!(*mm > 0.0)) throw WrongValue{"\"" + text + "\" is no size of a pixel: it must be above 0"};
          *pixel = mm;
        } else if (!takeVoxels(text)) {
          throw WrongValue{"\"" + text + "\" is not of the form MM or X,Y,Z, numbers above 0"};
        }
      }
    };
    command.addRepeated("--spacing", "MM|X,Y,Z", "MM: of the picture's square pixels; X,Y,Z: " + ofVoxels, take);
  }
  command.group("Options");
}

Option addLabelChoice(Command command, io::DataRequest& request, std::vector<std::string>& chosen) {
  const Option phantom = command.option("--phantom");
  const Option labels =
      command
          .add("--labels", "PATH",
               "label map, DICOM SEG or RTSTRUCT, or a folder of masks, resampled to the volume where its grid differs",
               [&request](const std::string& text) {
                 request.labels = text;
                 return !text.empty();
               })
          .excludes(phantom);
  const Option table = command
                           .add("--label-table", "FILE",
                                "names and colours of the labels: a table of ITK-SNAP, FreeSurfer, 3D Slicer or BIDS",
                                [&request](const std::string& text) {
                                  request.labelTable = text;
                                  return !text.empty();
                                })
                           .excludes(phantom);
  const Option focusLabels = command.add("--focus-labels", "LABEL,...", "labels to open the view to, by value or name",
                                         [&chosen](const std::string& text) {
                                           chosen = io::split(text, ',');
                                           return std::find(chosen.begin(), chosen.end(), "") == chosen.end();
                                         });
  // Only after the whole line is read is it known whether there are labels for --focus-labels.
  command.whenRead([=, &request] {
    if (focusLabels.isGiven() && !labels.isGiven() && !phantom.isGiven() && !io::isSession(request.path))
      throw MissingOption{"--labels, --phantom or a session", "--focus-labels"};
    if (table.isGiven() && !labels.isGiven() && !io::isSession(request.path))
      throw MissingOption{"--labels or a session", "--label-table"};
  });
  return focusLabels;
}

}  // namespace fenestra::app
