#include "viewer/model/WayOutText.h"

#include <QCoreApplication>

#include "viewer/model/Paths.h"
#include "viewer/model/ReaderText.h"

namespace fenestra::viewer {
namespace {

struct WayOutWords {
  Q_DECLARE_TR_FUNCTIONS(WayOut)
};

QString joined(const QString& text, io::WayOut way) {
  return way == io::WayOut::None ? text : text + QStringLiteral("; ") + windowWords(way);
}

}  // namespace

QString windowWords(io::WayOut way) {
  using io::WayOut;
  switch (way) {
    case WayOut::None:
      return {};
    case WayOut::ChooseTime:
      return WayOutWords::tr("File → Choose series has the others");
    case WayOut::OnlyTime:
      return WayOutWords::tr("it holds one volume: open it without a time point");
    case WayOut::ChooseSeries:
      return WayOutWords::tr("open it without naming a series; File → Choose series then lists those that are there");
    case WayOut::SayVoxelSize:
      return WayOutWords::tr("open it as a volume: a dialog asks for the size");
    case WayOut::CorrectVoxelSize:
      return WayOutWords::tr("File → Size of the voxels says otherwise");
    case WayOut::OmitVoxelSize:
      return WayOutWords::tr("open it without a size of voxels, which TIFF and raw files need");
    case WayOut::SayModality:
      return WayOutWords::tr("File → Kind of values says otherwise");
    case WayOut::AllowOutside:
      return WayOutWords::tr("put the file into the folder of its header");
    case WayOut::KeepSlices:
      return WayOutWords::tr("open it as it is stored: Load as is, in the notice about its slices");
    case WayOut::DescribeRaw:
      return WayOutWords::tr("DICOM, NIfTI, NRRD, MetaImage, MGH, Analyze and TIFF are recognised by content");
    case WayOut::ShowTable:
      return WayOutWords::tr("\"Hide the table\" in the panel Context brings it back");
    case WayOut::NameLabels:
      return WayOutWords::tr("open a label map with File → Open labels");
    case WayOut::NameFocus:
      return WayOutWords::tr("choose one in the panel Focus");
    case WayOut::NameFocusLabels:
      return WayOutWords::tr("choose the labels of the focus in the panel Focus");
    case WayOut::FindVolume:
      return WayOutWords::tr(
          "open the session again with File → Open session, which asks where they are, or put them beside it");
    case WayOut::FindLabels:
      return WayOutWords::tr("open the session again with File → Open session, which asks where they are");
    case WayOut::OmitReading:
      return WayOutWords::tr("open it without saying how its volume is read");
    case WayOut::OmitData:
      return WayOutWords::tr("open it without files");
    case WayOut::RaiseTolerance:
      return WayOutWords::tr("raise the tolerance in the panel Focus");
    case WayOut::ChooseSeed:
      return WayOutWords::tr("click at another place, or take a point outside away");
    case WayOut::ChangeSelection:
      return WayOutWords::tr("select more, or take less away");
  }
  return {};
}

QString windowText(const io::Warning& warning) {
  return joined(readerText(QString::fromStdString(warning.text)), warning.way);
}

QString windowText(const std::exception& error) {
  const auto* known = dynamic_cast<const io::Error*>(&error);
  if (!known || known->way() == io::WayOut::None) return QString::fromUtf8(error.what());
  return joined(toQString(known->file()) + QStringLiteral(": ") + QString::fromStdString(known->cause()), known->way());
}

}  // namespace fenestra::viewer
