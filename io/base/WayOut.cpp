#include "io/base/WayOut.h"

namespace fenestra::io {

const char* commandLineWords(WayOut way) {
  switch (way) {
    case WayOut::None:
      return "";
    case WayOut::ChooseTime:
      return "--time N chooses another";
    case WayOut::OnlyTime:
      return "it holds one volume; leave out --time";
    case WayOut::ChooseSeries:
      return "fenestra-cli info lists its series";
    case WayOut::SayVoxelSize:
      return "say it in mm, with --spacing X,Y,Z";
    case WayOut::CorrectVoxelSize:
      return "--spacing X,Y,Z says otherwise";
    case WayOut::OmitVoxelSize:
      return "leave out --spacing, which is for TIFF and --raw";
    case WayOut::SayModality:
      return "--modality MR or other says otherwise";
    case WayOut::AllowOutside:
      return "put the file beside the header, or allow it with --allow-outside where you trust the header";
    case WayOut::KeepSlices:
      return "open it as it is stored (--regularise off)";
    case WayOut::DescribeRaw:
      return "DICOM, NIfTI, NRRD, MetaImage, MGH, Analyze and TIFF are recognised by content; raw voxels need a "
             "description (--raw)";
    case WayOut::ShowTable:
      return "--hide-table off brings it back";
    case WayOut::NameLabels:
      return "name a label map with --labels";
    case WayOut::NameFocus:
      return "name one, as with --focus-range";
    case WayOut::NameFocusLabels:
      return "name the labels of the focus with --focus-labels";
    case WayOut::FindVolume:
      return "say where they are (--data PATH), or put them beside the session";
    case WayOut::FindLabels:
      return "say where they are (--labels FILE)";
    case WayOut::OmitReading:
      return "leave out --series, --time, --raw, --spacing and --modality";
    case WayOut::OmitData:
      return "leave out --data, --labels and --label-table";
    case WayOut::RaiseTolerance:
      return "raise --tolerance";
    case WayOut::ChooseSeed:
      return "choose another --seed, or remove an --outside";
    case WayOut::ChangeSelection:
      return "enlarge a ball of --select, or take less away";
  }
  return "";
}

}  // namespace fenestra::io
