// Label maps with names and colours in tables of every kind, in NIfTI's extensions, and as folders of masks; whole and
// damaged.

#include <algorithm>
#include <map>

#include "tests/io/Defects.h"
#include "tests/io/IoTesting.h"
#include "tests/io/LabelFiles.h"
#include "tests/io/NiftiBytes.h"

namespace fenestra::tests {
namespace fs = std::filesystem;

namespace {

using Bytes = std::vector<std::uint8_t>;

/// 4 x 1 x 1 voxels of a byte each, on LPS axes; `extension` follows the header, with its four bytes of flag.
std::string niftiOf(const Bytes& voxels, const std::string& extension = {}, bool swapped = false) {
  NiftiSpec spec{
      .swapped = swapped, .dims = {static_cast<std::int64_t>(voxels.size()), 1, 1}, .datatype = 2, .sform = 1};
  spec.srow = {-1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1, 0};
  std::string header = niftiHeader(spec);
  if (!extension.empty()) {
    header[348] = 1;
    const std::string offset = bytesOf(static_cast<float>(header.size() + extension.size()), swapped);
    header.replace(108, offset.size(), offset);
  }
  return header + extension + bytesOf(voxels);
}

std::string extensionOf(std::int32_t code, std::string text, bool swapped = false) {
  text.resize((text.size() + 8 + 15) / 16 * 16 - 8, ' ');
  return bytesOf(static_cast<std::int32_t>(text.size() + 8), swapped) + bytesOf(code, swapped) + text;
}
/// As TotalSegmentator writes it.
const std::string caretTable =
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?> <CaretExtension>  <Date><![CDATA[2013-07-14T05:45:09]]></Date>   "
    "<VolumeInformation Index=\"0\">   <LabelTable>\n"
    "<Label Key=\"1\" Red=\"0.0\" Green=\"1.0\" Blue=\"0.0\" Alpha=\"1\"><![CDATA[spleen]]></Label>\n"
    "<Label Key=\"2\" Red=\"1.0\" Green=\"0.5019607843137255\" Blue=\"0.0\" "
    "Alpha=\"1\"><![CDATA[kidney_right]]></Label>\n"
    "<Label Key=\"3\"><![CDATA[no colour]]></Label>\n<Label Key=\"0\" Red=\"0\"><![CDATA[background]]></Label>\n"
    "  </LabelTable>  <StudyMetaDataLinkSet>  </StudyMetaDataLinkSet>  <VolumeType><![CDATA[Label]]></VolumeType>   "
    "</VolumeInformation></CaretExtension>\n              ";

/// A row whose folder holds these files, and a volume of 4 voxels; `opened` is the label map's.
Defect row(std::string name, const std::map<std::string, std::string>& files, const std::string& opened,
           std::vector<std::string> names, Expected expected = opens) {
  Defect defect{"labels " + std::move(name),
                [=](const fs::path& folder) {
                  writeFile(folder / "volume.nii", niftiOf({9, 8, 7, 6}));
                  for (const auto& [file, bytes] : files) {
                    fs::create_directories((folder / file).parent_path());
                    writeFile(folder / file, bytes);
                  }
                  return folder / opened;
                },
                std::move(expected)};
  defect.labelsOf = "volume.nii";
  defect.labelNames = std::move(names);
  return defect;
}

/// A row with a label map of 0 to 3 and this table.
Defect table(const std::string& name, const std::string& file, const std::string& text,
             std::vector<std::string> names) {
  return row("with " + name, {{"map.nii", niftiOf({0, 1, 2, 3})}, {file, text}}, "map.nii", std::move(names));
}
Defect chosen(const std::string& name, const std::string& text, std::vector<std::string> names,
              Expected expected = opens) {
  Defect defect =
      row("with " + name, {{"map.nii", niftiOf({0, 1, 2, 3}, extensionOf(0, caretTable))}, {"mine.any", text}},
          "map.nii", std::move(names), std::move(expected));
  defect.labelTable = "mine.any";
  return defect;
}

const std::string itkSnap =
    "# ITK-SnAP Label Description File\n    0     0    0    0        0  0  0    \"Clear Label\"\n"
    "    1   255    0    0        1  1  1    \"Left tumour core\"\n    2     0  255    0      0.5  0  1    "
    "\"Oedema\"\n";
const std::string freeSurfer =
    "#No. Label Name:                            R   G   B   A\n\n0   Unknown                                 0   0   "
    "0 "
    "  0\n1   Left-Cerebral-White-Matter              245 245 245 0\n2   Left Lateral Ventricle                  120 "
    "18  "
    "134 0\r\n";
const std::string bids =
    "index\tname\tabbreviation\tcolor\tmapping\n1\tGray Matter\tGM\t#ff53bb\t1\n2\tWhite\tWM\t#2f8bbe\t2\n";

/// As UTF-16 with a byte order mark, as spreadsheets write text.
std::string wide(const std::string& text) {
  std::string all = "\xff\xfe";
  for (const char c : text) all += std::string{c, '\0'};
  return all;
}

std::vector<Defect> tableDefects() {
  const std::vector<std::string> snapNames{"1 Left tumour core #ff0000", "2 Oedema #00ff00", "3 label 3"},
      surferNames{"1 Left-Cerebral-White-Matter #f5f5f5", "2 Left Lateral Ventricle #781286", "3 label 3"},
      bidsNames{"1 Gray Matter #ff53bb", "2 White #2f8bbe"};
  const std::string slicer =
      "# Color table file names.ctbl\n# 3 values\n0 Background 0 0 0 0\n1 tissue 128 174 128 255\n2 bone "
      "241 214 145 255\n";
  const std::string slicerCsv =
      "LabelValue,Name,Color_R,Color_G,Color_B,Color_A\n1,soft tissue,128,174,128,255\n2,bone,241,214,145,255\n";
  std::string semicolons = slicerCsv;
  std::ranges::replace(semicolons, ',', ';');
  std::string whole;
  for (int value = 1; value <= 400; ++value)
    whole += std::to_string(value) + " structure-" + std::to_string(value) + " 1 2 3 0\n";
  return {
      table("an ITK-SNAP table", "map.txt", itkSnap, snapNames),
      table("an ITK-SNAP table of its own ending", "map.label", itkSnap, snapNames),
      table("a FreeSurfer table", "map.txt", freeSurfer, surferNames),
      table("FreeSurfer's own table in the folder", "FreeSurferColorLUT.txt", freeSurfer, surferNames),
      table("a Slicer table", "map.ctbl", slicer, {"1 tissue #80ae80", "2 bone #f1d691"}),
      table("a Slicer table of commas", "map.csv", slicerCsv, {"1 soft tissue #80ae80", "2 bone #f1d691"}),
      table("a Slicer table of semicolons", "map.csv", semicolons, {"1 soft tissue #80ae80", "2 bone #f1d691"}),
      table("a table of quoted names", "map.csv",
            "LabelValue,Name,Color_R,Color_G,Color_B\n1,\"kidney, left\",128,174,128\n2,\"a \"\"cyst\"\"\",1,2,3\n",
            {"1 kidney, left #80ae80", "2 a \"cyst\" #010203"}),
      table("an ITK-SNAP table of tabs and returns", "map.txt",
            "1\t255\t0\t0\t1\t1\t1\t\"Left tumour core\"\r\n2\t0\t255\t0\t1\t1\t1\t\"Oedema\"\r\n", snapNames),
      table("a FreeSurfer table of tabs", "map.txt", "1\tLeft Lateral Ventricle\t120\t18\t134\t0\n",
            {"1 Left Lateral Ventricle #781286"}),
      table("a BIDS table with returns", "map.tsv", "index\tname\tcolor\r\n1\tGray Matter\t#ff53bb\r\n",
            {"1 Gray Matter #ff53bb"}),
      table("a BIDS table of 16-bit characters", "map.tsv",
            wide("index\tname\tcolor\n1\tGray Matter\t#ff53bb\n2\tNoyau caud\xe9\t#2f8bbe\n"),
            {"1 Gray Matter #ff53bb", "2 Noyau caud\xc3\xa9 #2f8bbe"}),
      table("a BIDS table", "map.tsv", bids, bidsNames),
      table("a table of 400 structures", "map.txt", whole, {"1 structure-1 #010203", "3 structure-3"}),
      table("a table of numbers and names", "labels.tsv", "1\tleft kidney\n2\tspleen\n", {"1 left kidney", "2 spleen"}),
      table("a table with a byte order mark", "map.tsv", "\xEF\xBB\xBF" + bids, bidsNames),
      table("a table of colours beyond 255", "map.txt", "1 liver 300 0 0 0\n", {"1 liver"}),
      table("a table that is none", "map.txt", "Dear colleague,\n", {"1 label 1"}),
      table("a table of noise", "map.txt", std::string(3000, '\x93'), {"1 label 1"}),
      row("of BIDS with its table above",
          {{"sub-1/anat/sub-1_desc-aseg_dseg.nii", niftiOf({0, 1, 2, 3})},
           {"sub-1/anat/volume.nii", niftiOf({9, 8, 7, 6})},
           {"desc-aseg_dseg.tsv", bids}},
          "sub-1/anat/sub-1_desc-aseg_dseg.nii", bidsNames),
      chosen("a chosen ITK-SNAP table", itkSnap, {"1 Left tumour core #ff0000", "3 no colour"}),
      chosen("a chosen BIDS table", bids, {"1 Gray Matter #ff53bb", "2 White #2f8bbe"}),
      chosen("a chosen table that is none", "Dear colleague,\n", {}, error("is no table of labels")),
  };
}

std::vector<Defect> extensionDefects() {
  const std::vector<std::string> names{"1 spleen #00ff00", "2 kidney_right #ff8000", "3 no colour"};
  const Bytes map{0, 1, 2, 3};
  const auto nifti = [&](const std::string& name, const std::string& bytes, std::vector<std::string> wanted) {
    return row("in NIfTI with " + name, {{"map.nii", bytes}}, "map.nii", std::move(wanted));
  };
  const std::string table = extensionOf(0, caretTable);
  std::string tooLong = table, pair = niftiOf(map);
  tooLong.replace(0, 4, bytesOf(std::int32_t{0x7fffffff}));
  pair.replace(108, 4, bytesOf(0.0f));
  pair.replace(344, 2, "ni");
  pair[348] = 1;
  return {
      nifti("a table of TotalSegmentator's", niftiOf(map, table), names),
      nifti("a table of Workbench's", niftiOf(map, extensionOf(30, caretTable)), names),
      nifti("a table in the other byte order", niftiOf(map, extensionOf(0, caretTable, true), true), names),
      nifti("a table behind another extension", niftiOf(map, extensionOf(6, "a comment") + table), names),
      nifti("an extension of another kind", niftiOf(map, extensionOf(6, "<LabelTable>")), {"1 label 1"}),
      nifti("an extension of two thousand million bytes", niftiOf(map, tooLong), {"1 label 1"}),
      nifti("a table that is cut", niftiOf(map, extensionOf(0, caretTable.substr(0, 400))), {"1 spleen #00ff00"}),
      nifti(
          "a table of escapes",
          niftiOf(map, extensionOf(
                           0, "<LabelTable><Label Key='1' Red='1' Green='0' Blue='0'>A &amp; B</Label></LabelTable>")),
          {"1 A & B #ff0000"}),
      row("in packed NIfTI with a table", {{"map.nii.gz", gzipped(niftiOf(map, table))}}, "map.nii.gz", names),
      row("in NIfTI as a pair with a table", {{"map.hdr", pair.substr(0, 352) + table}, {"map.img", bytesOf(map)}},
          "map.hdr", names),
  };
}

std::vector<Defect> maskDefects() {
  const std::string liver = niftiOf({1, 1, 1, 0}), spleen = niftiOf({0, 0, 1, 1}), empty = niftiOf({0, 0, 0, 0});
  const auto masks = [](const std::string& name, const std::map<std::string, std::string>& files,
                        std::vector<std::string> names, Expected expected) {
    std::map<std::string, std::string> inside;
    for (const auto& [file, bytes] : files) inside["segmentations/" + file] = bytes;
    return row("as masks " + name, inside, "segmentations", std::move(names), std::move(expected));
  };
  return {
      masks("of separate structures",
            {{"liver.nii.gz", gzipped(niftiOf({1, 1, 0, 0}))}, {"spleen.nii.gz", gzipped(spleen)}},
            {"1 liver", "2 spleen"}, opens),
      masks("that overlap", {{"liver.nii", liver}, {"spleen.nii", spleen}}, {"1 liver", "2 spleen"},
            warning("labels overlap at 1 voxel; the smaller structure's label is kept there (spleen over liver at 1)")),
      masks("in their natural order", {{"rib_10.nii", spleen}, {"rib_2.nii", niftiOf({1, 0, 0, 0})}},
            {"1 rib_2", "2 rib_10"}, opens),
      masks("of a structure that is not there", {{"liver.nii", liver}, {"aorta.nii", empty}}, {"1 aorta", "2 liver"},
            opens),
      masks("with endings in their names", {{"liver.seg.nii.gz", gzipped(liver)}}, {"1 liver.seg"}, opens),
      masks("of several formats",
            {{"liver.nii", liver},
             {"spleen.mha",
              "NDims = 3\nDimSize = 4 1 1\nElementSpacing = 1 1 1\nOffset = 0 0 0\nElementType = MET_UCHAR\n"
              "ElementDataFile = LOCAL\n" +
                  std::string("\0\0\0\1", 4)}},
            {"1 liver", "2 spleen"}, opens),
      masks("of 255", {{"liver.nii", niftiOf({255, 0, 0, 0})}}, {"1 liver"}, opens),
      masks("beside other files", {{"liver.nii", liver}, {"statistics.json", "{}"}}, {"1 liver"}, opens),
      masks("beside a map of several labels", {{"all.nii", niftiOf({0, 1, 2, 3})}, {"liver.nii", liver}}, {"1 liver"},
            warning("1 of 2 files left out, which are no masks of one structure (all.nii holds several labels)")),
      masks("beside a cut file", {{"a.nii", liver.substr(0, 353)}, {"liver.nii", liver}}, {"1 liver"},
            warning("1 of 2 files left out, which are no masks of one structure (a.nii ")),
      masks("beside an archive named as a mask",
            {{"a.nii", "PK\x03\x04" + std::string(60, '\0')}, {"liver.nii", liver}}, {"1 liver"},
            warning("1 of 2 files left out, which are no masks of one structure (a.nii is an archive)")),
      masks("of which none can be read", {{"all.nii", niftiOf({0, 1, 2, 3})}}, {},
            error("holds no mask that can be read (all.nii holds several labels)")),
      masks("that are not there", {{"readme.txt", "none"}}, {}, error("is a folder, not a label map")),
      masks("outside the volume",
            {{"liver.mha",
              "NDims = 3\nDimSize = 1 1 1\nElementSpacing = 1 1 1\nOffset = 500 0 0\nElementType = MET_UCHAR\n"
              "ElementDataFile = LOCAL\n\x01"}},
            {"1 liver"}, warning("every label lies outside the volume")),
  };
}

}  // namespace

std::vector<Defect> labelNameDefects() {
  std::vector<Defect> all = tableDefects();
  for (const auto& part : {extensionDefects(), maskDefects()}) all.insert(all.end(), part.begin(), part.end());
  return all;
}

}  // namespace fenestra::tests
