#pragma once
// Ways out of an error, or of what a warning says, that each program offers in words of its own: the command line names
// an option, the window a menu or a panel (viewer/model/WayOutText.h).

#include <cstdint>

namespace fenestra::io {

enum class WayOut : std::uint8_t {
  None,
  ChooseTime,        ///< another time point
  OnlyTime,          ///< there is one time point
  ChooseSeries,      ///< one that is there
  SayVoxelSize,      ///< the file does not
  CorrectVoxelSize,  ///< it was taken from the file
  OmitVoxelSize,     ///< the file says it
  SayModality,       ///< it was recognised
  AllowOutside,      ///< voxels lie outside of their header's folder
  KeepSlices,        ///< where they are stored, rather than evenly
  DescribeRaw,       ///< the format is unknown
  ShowTable,         ///< the scanner's table is hidden
  NameLabels,        ///< no label map is open
  NameFocus,         ///< nothing is in focus
  NameFocusLabels,   ///< others are to be in focus
  FindVolume,        ///< a session's volume
  FindLabels,        ///< a session's label map
  OmitReading,       ///< the session says how its volume is read
  OmitData,          ///< the session needs no files
  RaiseTolerance,    ///< the region is empty
  ChooseSeed,        ///< the region is empty
  ChangeSelection,   ///< the selection is empty
};
inline constexpr int wayOutCount = static_cast<int>(WayOut::ChangeSelection) + 1;

/// The way out in the words of the command line: a clause without a period; empty for None.
const char* commandLineWords(WayOut way);

}  // namespace fenestra::io
