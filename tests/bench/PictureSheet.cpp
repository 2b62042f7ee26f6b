// picture-sheet SHEET OUT.png [FOLDER]: scenes, one a row, each drawn in several ways from one camera, one a column.
// Real data only where the real-data collection is. With FOLDER, every picture also goes there by itself at full size.
// Sheets:
//
// figures: the adaptive cutaway as in the method's Figures 4, 5 and 8: plain, w_open 0, w_open 24, with the context
// layer, with the border, and with both and brushed (tests/bench/figures has the strokes); with occlusion and
// soft shadow. The last row is its Figure 6, for a hand and a foot: C1, then C2 in the half sphere and in the band
// around it.
// look: reconstruction, smooth surfaces of labels, occlusion and soft shadow, one by one and together.
// methods: every method at its defaults.
// defaults: what data open with, beside the plain look.

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <QGuiApplication>

#include "tests/bench/MethodVariants.h"
#include "tests/bench/Sheet.h"
#include "tests/support/TestData.h"

namespace fenestra::bench {
namespace {

namespace fs = std::filesystem;

const fs::path figures = FENESTRA_FIGURES;

/// Collects rows; leaves out those whose data is not there, and says so.
class Rows {
 public:
  /// The look that the rows' data open in.
  enum class Start { Plain, AsUsual };
  explicit Rows(Start start = Start::Plain) : start_(start) {}

  void phantom(const std::string& name, const std::string& caption) {
    io::StudyRequest options;
    options.phantom = name;
    add({name, caption, std::move(options), 1.15});
  }
  void ranged(const std::string& name, const std::string& caption, const fs::path& path, ValueRange focus,
              io::ViewAngles camera, double zoom) {
    io::StudyRequest options;
    options.path = tests::findTestData(path);
    options.focusRange = focus;
    options.camera = camera;
    if (options.path.empty()) return leaveOut(caption, path);
    add({name, caption, std::move(options), zoom});
  }
  void labelled(const std::string& name, const std::string& caption, const fs::path& path, const fs::path& labels,
                std::vector<std::string> focus, io::ViewAngles camera, double zoom, double raise = 0.0) {
    io::StudyRequest options;
    options.path = tests::findTestData(path);
    options.labels = tests::findTestData(labels);
    options.focusLabels = std::move(focus);
    options.camera = camera;
    if (options.path.empty() || options.labels.empty()) return leaveOut(caption, path);
    add({name, caption, std::move(options), zoom, raise});
  }

  void whole(const std::string& name, const std::string& caption, const fs::path& path, io::ViewAngles camera) {
    io::StudyRequest options;
    options.path = tests::findTestData(path);
    options.camera = camera;
    if (options.path.empty()) return leaveOut(caption, path);
    add({name, caption, std::move(options)});
  }

  Row* last(const std::string& name) { return !rows_.empty() && rows_.back().name == name ? &rows_.back() : nullptr; }
  std::vector<Row> take() { return std::move(rows_); }

 private:
  void add(Row row) {
    if (start_ == Start::Plain) row.options.makePlain();
    row.options.look.background = glm::dvec3(0.05, 0.055, 0.07);
    rows_.push_back(std::move(row));
  }
  static void leaveOut(const std::string& caption, const fs::path& path) {
    std::cerr << "left out: " << caption << ", which needs " << path.string() << '\n';
  }

  Start start_;
  std::vector<Row> rows_;
};

const fs::path headCt = "ct-head/ct.nii.gz";
const fs::path torsoCt = "labelled/totalsegmentator-torso/example_ct.nii.gz";
const fs::path torsoLabels = "labelled/totalsegmentator-torso/example_seg_fast_force_split.nii.gz";
const fs::path brainMr = "labelled/brain-colin27/ch2.nii.gz", brainLabels = "labelled/brain-colin27/aal.nii.gz";
const fs::path chestCt = "labelled/slicer-ctchest/CTChest4.nrrd";
const fs::path chestLabels = "labelled/slicer-ctchest/Segmentation.seg.nrrd";
constexpr ValueRange skull{0.5, 1.0};  ///< bone of headCt, in the file's own scale
const std::vector<std::string> carpus{"143", "144", "145", "146", "147", "148", "149", "150"};  ///< of the hand
const std::vector<std::string> hindfoot{"146", "152"};  ///< calcaneus and talus, of the foot

/// One of the volumes that BodyParts3D's meshes were made into.
void body(Rows& rows, const std::string& region, const std::string& structures, std::vector<std::string> focus,
          io::ViewAngles camera) {
  const std::string start = "labelled/bodyparts3d/" + region + "/" + region;
  rows.labelled("bodyparts-" + region, "BodyParts3D: " + region + structures, start + "_ct.nii.gz",
                start + "_seg.nii.gz", std::move(focus), camera, 1.0);
}

void head(Rows& rows) {
  rows.ranged("head", "CT head: skull", headCt, skull, {55.0, 5.0}, 1.25);
  if (Row* row = rows.last("head")) row->options.transferFunction = (figures / "head-transfer-function.json").string();
}

Sheet figureSheet() {
  Rows rows;
  const auto finish = [&](const std::string& name, const std::string& strokes, double zoom,
                          Reconstruction reconstruction) {
    Row* row = rows.last(name);
    if (!row) return;
    row->options.strokes = figures / strokes;
    row->options.look.reconstruction = reconstruction;
    row->zoom = zoom;
  };
  rows.phantom("torso", "Phantom");
  finish("torso", "torso-strokes.json", 1.0, Reconstruction::Smooth);
  head(rows);
  finish("head", "head-strokes.json", 1.05, Reconstruction::Linear);
  rows.labelled("labelled", "CT torso: kidneys, aorta", torsoCt, torsoLabels, {"2", "3", "52"}, {180.0, 10.0}, 1.0,
                50.0);
  finish("labelled", "labelled-strokes.json", 1.35, Reconstruction::Smoother);
  if (Row* row = rows.last("labelled"))
    row->options.labelChanges.colours = {{"2", {0.62, 0.25, 0.2}}, {"3", {0.62, 0.25, 0.2}}, {"52", {0.75, 0.12, 0.1}}};
  const auto finishBody = [&](const std::string& region) {
    const std::string name = "bodyparts-" + region;
    finish(name, region + "-strokes.json", 1.0, Reconstruction::Linear);
    if (Row* row = rows.last(name)) row->options.transferFunction = "ct-soft-tissue";
  };
  body(rows, "hand", ": carpus", carpus, {0.0, 0.0});
  finishBody("hand");
  body(rows, "foot", ": talus, calcaneus", hindfoot, {270.0, 10.0});
  finishBody("foot");

  const auto column = [](const std::string& name, const std::string& ready, double openWidth, bool hasStrokes = false) {
    return Column{name, name, [=](Look& look) {
                    look.labelSmoothing = LabelSmoothing::Strong;
                    look.shading.occlusion = 0.6;
                    look.shading.shadow = 0.5;
                    const auto looks = openingLooks();
                    std::find_if(looks.begin(), looks.end(), [&](const OpeningLook& each) {
                      return each.id == ready;
                    })->applyTo(look.cutaway, look.contextLayer);
                    look.cutaway.enabled = name != "plain";
                    look.cutaway.openWidth = openWidth;
                    if (!hasStrokes) look.strokes.clear();
                  }};
  };
  Sheet sheet{
      rows.take(),
      {column("plain", "bare", 0.0), column("open-0", "bare", 0.0), column("open-24", "bare", 24.0),
       column("context", "context", 24.0), column("border", "border", 24.0), column("brushed", "full", 24.0, true)},
      {256, 238},
      false};
  for (Row row : sheet.rows) {
    if (!row.name.starts_with("bodyparts-")) continue;
    row.options.strokes.clear();
    sheet.placed.push_back(std::move(row));
  }
  return sheet;
}

Sheet lookSheet() {
  Rows rows;
  head(rows);
  rows.labelled("torso", "CT torso, 3 mm: kidney", torsoCt, torsoLabels, {"2"}, {150.0, 5.0}, 1.3);
  rows.labelled("chest", "CT chest, 10 mm: lungs", chestCt, chestLabels, {"right lung", "left lung"}, {25.0, 10.0},
                1.3);
  rows.labelled("brain", "MR brain: hippocampus", brainMr, brainLabels, {"37", "38"}, {90.0, 20.0}, 1.3);
  rows.phantom("torso", "Phantom");

  const auto spline = [](Look& look) { look.reconstruction = Reconstruction::Smoother; };
  const auto surfaces = [](Look& look) { look.labelSmoothing = LabelSmoothing::Strong; };
  const auto hollows = [](Look& look) { look.shading.occlusion = 0.6; };
  const auto shadows = [](Look& look) { look.shading.shadow = 0.5; };
  return {rows.take(),
          {{"before", "As it was", [](Look&) {}},
           {"cubic", "Curved", [](Look& look) { look.reconstruction = Reconstruction::Cubic; }},
           {"smoother", "Smoothed more", spline},
           {"labels", "Label surfaces", surfaces},
           {"occlusion", "Occlusion", hollows},
           {"shadow", "Soft shadow", shadows},
           {"all", "All, smooth edges",
            [=](Look& look) {
              spline(look);
              surfaces(look);
              hollows(look);
              shadows(look);
              look.edges = Edges::Smooth;
            }}},
          {200, 186}};
}

Sheet methodSheet() {
  Rows rows;
  rows.phantom("torso", "Phantom: organs");
  head(rows);
  rows.labelled("brain", "MR brain: hippocampus", brainMr, brainLabels, {"37", "38"}, {90.0, 20.0}, 1.3);
  rows.labelled("kidneys", "CT torso: kidneys", torsoCt, torsoLabels, {"2", "3"}, {180.0, 10.0}, 1.3);
  rows.labelled("aorta", "CT torso: aorta", torsoCt, torsoLabels, {"52"}, {40.0, 5.0}, 1.3);
  Sheet sheet{rows.take(), {}, {200, 186}};
  for (const MethodVariant& variant : methodVariants())
    sheet.columns.push_back(
        {variant.name, variant.caption, [method = variant.method](Look& look) { look.method = method; }});
  return sheet;
}

Sheet defaultsSheet() {
  Rows rows(Rows::Start::AsUsual);
  rows.phantom("torso", "Phantom: organs");
  const fs::path archive = "visible-human/VHMCT1mm_Head.tar.xz";
  rows.ranged("vhm", "CT head, 1 mm: skull", archive, {300.0, 3000.0}, {55.0, 5.0}, 1.0);
  if (Row* row = rows.last("vhm")) row->options.path = tests::unpackTestData(archive, archive.stem().stem());
  rows.ranged("head", "CT head, not in HU", headCt, {0.6, 1.0}, {55.0, 5.0}, 1.0);
  rows.labelled("kidneys", "CT torso, 3 mm", torsoCt, torsoLabels, {"2", "3"}, {180.0, 10.0}, 1.0);
  rows.labelled("kidney", "CT torso: kidney", torsoCt, torsoLabels, {"2"}, {150.0, 5.0}, 1.0);
  rows.labelled("chest", "CT chest, 10 mm", chestCt, chestLabels, {"right lung", "left lung"}, {25.0, 10.0}, 1.0);
  rows.labelled("lung", "CT lung, 2.5 mm", "labelled/elastix-lung/3DCT_lung.mha",
                "labelled/elastix-lung/3DCT_lung_baseline_mask.mha", {"1"}, {0.0, 0.0}, 1.0);
  rows.labelled("brain", "MR T1: hippocampus", brainMr, brainLabels, {"37", "38"}, {90.0, 20.0}, 1.0);
  rows.whole("mr", "MR head, 5 mm", "visible-human/vm_head_mri.mha", {40.0, 10.0});
  rows.whole("coarse-mr", "MR head, 4 mm", "formats/metaimage/HeadMRVolume.mhd", {30.0, 10.0});
  rows.whole("mask", "Mask as a volume", "formats/nifti/with_extension.nii.gz", {30.0, 10.0});
  body(rows, "hand", "", {"120", "121"}, {0.0, 0.0});
  body(rows, "foot", "", {"119", "120"}, {60.0, 10.0});
  body(rows, "head", "", {"135", "137"}, {60.0, 5.0});
  body(rows, "torso", "", {"2", "3", "52"}, {20.0, 5.0});
  rows.ranged("ge", "CT, uneven slices", "dicom/ct-tilt-irregular-ge", {300.0, 3000.0}, {40.0, 10.0}, 1.0);
  return {rows.take(), {{"before", "Plain", [](Look&) {}}, {"after", "As data open", [](Look&) {}, false}}, {260, 242}};
}

}  // namespace
}  // namespace fenestra::bench

int main(int argc, char** argv) {
  CLI::App program{"Draws scenes in several ways on one sheet.", "picture-sheet"};
  std::string sheet, output, folder;
  program.add_option("SHEET", sheet)->required()->check(CLI::IsMember({"figures", "look", "methods", "defaults"}));
  program.add_option("OUT", output, "PNG")->required();
  program.add_option("FOLDER", folder, "where every picture also goes by itself");
  CLI11_PARSE(program, argc, argv);
  // Text is drawn into pictures alone.
  qputenv("QT_QPA_PLATFORM", "offscreen");
  const QGuiApplication application(argc, argv);
  try {
    using namespace fenestra::bench;
    draw(sheet == "figures"    ? figureSheet()
         : sheet == "look"     ? lookSheet()
         : sheet == "defaults" ? defaultsSheet()
                               : methodSheet(),
         output, folder);
  } catch (const std::exception& error) {
    std::cerr << "picture-sheet: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
