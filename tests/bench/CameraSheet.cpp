// camera-sheet FOLDER [PART]: where the two cameras look from, for structures of the head, thorax, abdomen, hand, foot
// and thin stacks: the paper's placement beside the one with habits (rendering/viewpoints/Habits.h). Writes
// cameras.png, a row for each structure, and cameras.md, and leaves out what needs real data that is not there.

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <QGuiApplication>
#include <QImage>
#include <QPainter>

#include "io/study/ReadStudy.h"
#include "rendering/Renderer.h"
#include "rendering/egl/EglContext.h"
#include "rendering/gpu/GpuScene.h"
#include "rendering/placement/Placer.h"
#include "rendering/scene/VisibleFraming.h"
#include "tests/bench/MarkdownTable.h"
#include "tests/bench/PlacementSubjects.h"
#include "tests/support/TestData.h"

namespace fenestra {
namespace {

namespace fs = std::filesystem;
using namespace placement;
using bench::fixed, bench::tableHeader, bench::tableRow;

constexpr glm::ivec2 cell{170, 158};  ///< pixels
constexpr int gap = 6, margin = 24;   ///< pixels, the latter for captions
constexpr int finer = 2;              ///< times finer is what is rendered and then averaged
constexpr double zoom = 1.25;
constexpr double usualWidth = 700.0;  ///< pixels of a picture that w_open refers to

struct Row {
  std::string name;
  io::StudyRequest request;
};

std::vector<Row> rowsOf(const std::string& part) {
  std::vector<Row> rows;
  const auto add = [&](const std::string& name, const fs::path& image, const fs::path& labels,
                       std::vector<std::string> focus) {
    if (name.find(part) == std::string::npos) return;
    io::StudyRequest request;
    request.path = tests::findTestData(image);
    request.labels = tests::findTestData(labels);
    request.focusLabels = std::move(focus);
    request.makePlain();
    request.look.background = glm::dvec3(0.05, 0.055, 0.07);
    if (request.path.empty() || request.labels.empty())
      std::cerr << "left out: " << name << ", which needs " << image.string() << '\n';
    else
      rows.push_back({name, std::move(request)});
  };
  const auto body = [&](const std::string& name, const std::string& region, std::vector<std::string> focus) {
    const std::string folder = "labelled/bodyparts3d/" + region + "/" + region;
    add(name, folder + "_ct.nii.gz", folder + "_seg.nii.gz", std::move(focus));
  };
  const auto abdomen = [&](const std::string& name, std::vector<std::string> focus) {
    add(name, "labelled/totalsegmentator-torso/example_ct.nii.gz",
        "labelled/totalsegmentator-torso/example_seg_fast_force_split.nii.gz", std::move(focus));
  };
  const auto brain = [&](const std::string& name, std::vector<std::string> focus) {
    add(name, "labelled/brain-colin27/ch2.nii.gz", "labelled/brain-colin27/aal.nii.gz", std::move(focus));
  };
  body("head: ventricles", "head", {"139"});
  body("head: eyes", "head", {"140", "142"});
  body("head: mandible", "head", {"151"});
  brain("brain: hippocampus", {"37", "38"});
  body("thorax: heart", "torso", {"167", "168", "169", "170"});
  body("thorax: aorta", "torso", {"52"});
  add("thorax: lungs", "labelled/slicer-ctchest/CTChest4.nrrd", "labelled/slicer-ctchest/Segmentation.seg.nrrd",
      {"right lung", "left lung"});
  abdomen("abdomen: kidneys", {"2", "3"});
  abdomen("abdomen: liver", {"5"});
  abdomen("abdomen: vertebra L3", {"29"});
  body("hand: scaphoid", "hand", {"147"});
  body("hand: third metacarpal", "hand", {"140"});
  body("foot: talus", "foot", {"152"});
  body("foot: metatarsals", "foot", {"141", "142", "143", "144", "145"});
  add("thin stack, 20 slices: liver", "labelled/totalsegmentator-dicom/example_ct_dicom",
      "labelled/totalsegmentator-dicom/example_seg_dicom.nii.gz", {"5"});
  return rows;
}

Options pure() {
  Options options;
  options.habits = noHabits;
  return options;
}

/// A camera's direction as degrees to the patient's left of the front, and degrees above.
std::string directionText(glm::dvec3 d) {
  const double left = glm::degrees(std::atan2(d.x, -d.y)), above = glm::degrees(std::asin(std::clamp(d.z, -1.0, 1.0)));
  return fixed(left, 0) + "°, " + fixed(above, 0) + "°";
}

class Sheet {
 public:
  explicit Sheet(int rows)
      : page_(margin + 4 * (cell.x + gap) - gap, margin + rows * (cell.y + gap) + margin, QImage::Format_RGB32) {
    page_.fill(Qt::white);
    painter_.begin(&page_);
    painter_.setPen(Qt::black);
    const char* const captions[] = {"C1, the paper's", "C2, the paper's", "C1, with habits", "C2, with habits"};
    for (int c = 0; c < 4; ++c)
      painter_.drawText(QRect(left(c), 0, cell.x, margin), Qt::AlignCenter, QString::fromUtf8(captions[c]));
    painter_.drawText(QRect(0, page_.height() - margin, page_.width(), margin), Qt::AlignCenter,
                      QString::fromUtf8(bench::bodyPartsCredit));
  }

  void add(const Row& row) {
    const io::Study study = io::readStudy(row.request);
    const Scene& scene = study.drawn.scene();
    const auto gpu = std::make_shared<GpuScene>();
    gpu->update(scene);
    Placer placer;
    const Measured& measured = placer.measure(*gpu, scene, {}, {});
    const Framing framing = visibleFraming(shownVolume(scene), scene.look.context.shifted());
    View view = *study.view;
    view.size = finer * cell;
    view.pixelScale = view.size.x / usualWidth;
    view.quality = Quality::High;
    Renderer renderer(gpu);
    std::vector<std::string> cells{row.name};
    int column = 0;
    for (const Options& options : {pure(), Options()}) {
      const Placement placed = choose(measured, options, jointByDefault);
      for (const std::optional<std::size_t> index : {placed.c1, placed.c2}) {
        const Candidate& candidate = measured.candidates[index.value()];
        view.camera = Camera::fromDirection(candidate.direction, framing, Projection::Perspective).zoomed(zoom);
        renderer.render(scene, view);
        draw(renderer.readPicture(), view.size, column++);
        cells.push_back(directionText(candidate.direction));
        cells.push_back(fixed(candidate.descriptors.awkwardness.throughCutEnd, 2));
      }
      cells.push_back(fixed(placed.share, 2));
    }
    painter_.save();
    painter_.translate(0, top() + cell.y);
    painter_.rotate(-90.0);
    painter_.drawText(QRect(0, 0, cell.y, margin), Qt::AlignCenter, QString::fromStdString(row.name));
    painter_.restore();
    ++row_;
    table_ += tableRow(cells);
  }

  void save(const fs::path& folder, const std::string& gl) {
    painter_.end();
    const fs::path picture = folder / "cameras.png";
    if (!page_.save(QString::fromStdString(picture.string())))
      throw std::runtime_error(picture.string() + ": cannot be written");
    std::ofstream(folder / "cameras.md")
        << "# Where the cameras look from\n\nWritten by `camera-sheet` (build target of that name) on " << gl
        << ". The paper's placement beside the one with habits (`rendering/viewpoints/Habits.h`), both with the joint "
           "search among 192 views and the standard ones.\n\n![A row for each structure; from left to right C1 and C2 "
           "of the paper's placement, then with habits](cameras.png)\n\n"
        << bench::bodyPartsCredit
        << " (head, heart, aorta, hand, foot; changed: voxels with simulated values).\n\nA direction is the angle from "
           "the front to the patient's left, and the angle above the horizon. *cut*: how far the view comes in through "
           "cut ends, 1 straight through one, refused above ½; *share*: of the structure's surface that the two views "
           "together show.\n\n"
        << tableHeader({"structure", "C1, the paper's", "cut", "C2", "cut", "share", "C1, with habits", "cut", "C2",
                        "cut", "share"})
        << table_;
  }

 private:
  static int left(int column) { return margin + column * (cell.x + gap); }
  int top() const { return margin + row_ * (cell.y + gap); }
  void draw(const std::vector<std::uint8_t>& pixels, glm::ivec2 size, int column) {
    const QImage picture(pixels.data(), size.x, size.y, 4 * size.x, QImage::Format_RGBX8888);
    painter_.drawImage(QRect(left(column), top(), cell.x, cell.y),
                       picture.scaled(cell.x, cell.y, Qt::IgnoreAspectRatio, Qt::SmoothTransformation));
  }

  QImage page_;
  QPainter painter_;
  std::string table_;
  int row_ = 0;
};

void run(const fs::path& folder, const std::string& part) {
  const egl::EglContext context;
  fs::create_directories(folder);
  const std::vector<Row> rows = rowsOf(part);
  if (rows.empty()) throw std::runtime_error("there is no data to draw");
  Sheet sheet(static_cast<int>(rows.size()));
  for (const Row& row : rows) sheet.add(row);
  sheet.save(folder, context.description());
}

}  // namespace
}  // namespace fenestra

int main(int argc, char** argv) {
  CLI::App program{"Draws where the cameras look from, before and with habits; writes cameras.png and cameras.md.",
                   "camera-sheet"};
  std::string folder, part;
  program.add_option("FOLDER", folder, "where the page and its picture go")->required();
  program.add_option("PART", part, "only the structures whose names hold this");
  CLI11_PARSE(program, argc, argv);
  qputenv("QT_QPA_PLATFORM", "offscreen");  // text is drawn into pictures alone
  const QGuiApplication application(argc, argv);
  try {
    fenestra::run(folder, part);
  } catch (const std::exception& error) {
    std::cerr << "camera-sheet: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
