// figure-sheet OUT.png [FOLDER]: pictures of the adaptive cutaway like those of the method's Figures 4, 5 and 8 on one
// sheet. Rows: the torso phantom, a CT head, a labelled CT of a torso (the real ones only where the real-data
// collection is). Columns: plain, w_open 0, w_open 24, with the context layer, with the border, and with both
// and brushed (tests/bench/figures has the strokes). With FOLDER, every picture also goes there by itself at full size.

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "app/SceneOptions.h"
#include "io/ImageWriter.h"
#include "rendering/Renderer.h"
#include "rendering/egl/EglContext.h"
#include "rendering/gpu/GpuScene.h"
#include "tests/support/TestData.h"

namespace fenestra {
namespace {

namespace fs = std::filesystem;

constexpr glm::ivec2 cell{256, 238};          ///< pixels on the sheet
constexpr int gap = 6;                        ///< pixels between cells
constexpr int finer = 3;                      ///< times finer is what is rendered and then averaged
constexpr double methodPictureWidth = 700.0;  ///< the method's pictures, which w_open of 24 px refers to

const fs::path figures = FENESTRA_FIGURES;

struct Row {
  std::string name;
  app::SceneOptions options;
  double zoom = 1.0;
  double raise = 0.0;  ///< mm that the camera is moved up
};

std::vector<Row> rows() {
  std::vector<Row> list;
  const glm::dvec3 backdrop(0.05, 0.055, 0.07);
  const auto add = [&](const std::string& name, app::SceneOptions options, double zoom, double raise,
                       const fs::path& strokes) {
    options.strokes = figures / strokes;
    options.look.background = backdrop;
    list.push_back({name, std::move(options), zoom, raise});
  };
  app::SceneOptions torso;
  torso.phantom = "torso";
  add("phantom", torso, 1.15, 0.0, "torso-strokes.json");

  app::SceneOptions head;
  head.path = tests::findTestData("ct-head/ct.nii.gz");
  head.transferFunction = (figures / "head-transfer-function.json").string();
  head.focusRange = ValueRange{0.5, 1.0};  // bone, in the file's own scale
  head.camera = app::ViewAngles{55.0, 5.0};
  if (head.path.empty())
    std::cerr << "left out the head: needs ct-head/ct.nii.gz\n";
  else
    add("head", head, 1.25, 0.0, "head-strokes.json");

  app::SceneOptions labelled;
  const fs::path folder = "labelled/totalsegmentator-torso";
  labelled.path = tests::findTestData(folder / "example_ct.nii.gz");
  labelled.labels = tests::findTestData(folder / "example_seg_fast_force_split.nii.gz");
  labelled.focusLabels = {"2", "3", "52"};  // kidneys and aorta
  labelled.camera = app::ViewAngles{180.0, 10.0};
  if (labelled.path.empty() || labelled.labels.empty())
    std::cerr << "left out the labelled torso: needs " << folder.string() << '\n';
  else
    add("labelled", labelled, 1.45, 50.0, "labelled-strokes.json");
  return list;
}

/// The scene of a row as a column shows it.
struct Column {
  std::string name;
  bool cutaway = true;
  double openWidth = 24.0;
  std::string look;
  bool brushed = false;
};
const std::vector<Column> columns{{"plain", false, 0.0, "bare"},    {"open-0", true, 0.0, "bare"},
                                  {"open-24", true, 24.0, "bare"},  {"context", true, 24.0, "context"},
                                  {"border", true, 24.0, "border"}, {"brushed", true, 24.0, "full", true}};

Scene sceneOf(const Scene& row, const Column& column) {
  Scene scene = row;
  const auto looks = openingLooks();
  std::find_if(looks.begin(), looks.end(), [&](const OpeningLook& look) {
    return look.id == column.look;
  })->applyTo(scene.look.cutaway, scene.look.contextLayer);
  scene.look.cutaway.enabled = column.cutaway;
  scene.look.cutaway.openWidth = column.openWidth;
  if (!column.brushed) scene.look.strokes.clear();
  return scene;
}

/// 8-bit RGB, row by row.
struct Sheet {
  glm::ivec2 size;
  std::vector<std::uint8_t> pixels;

  explicit Sheet(glm::ivec2 extent)
      : size(extent), pixels(static_cast<std::size_t>(extent.x) * static_cast<std::size_t>(extent.y) * 3, 255) {}

  /// The means of finer × finer pixels of an RGBA picture.
  void place(const std::vector<std::uint8_t>& picture, glm::ivec2 origin) {
    for (int j = 0; j < cell.y; ++j)
      for (int i = 0; i < cell.x; ++i)
        for (int channel = 0; channel < 3; ++channel) {
          int sum = 0;
          for (int k = 0; k < finer * finer; ++k) {
            const int x = i * finer + k % finer, y = j * finer + k / finer;
            sum += picture[static_cast<std::size_t>((y * cell.x * finer + x) * 4 + channel)];
          }
          pixels[static_cast<std::size_t>(((origin.y + j) * size.x + origin.x + i) * 3 + channel)] =
              static_cast<std::uint8_t>((sum + finer * finer / 2) / (finer * finer));
        }
  }
};

std::vector<std::uint8_t> withoutAlpha(const std::vector<std::uint8_t>& rgba) {
  std::vector<std::uint8_t> rgb;
  for (std::size_t i = 0; i < rgba.size(); ++i)
    if (i % 4 != 3) rgb.push_back(rgba[i]);
  return rgb;
}

void draw(const fs::path& output, const fs::path& folder) {
  const egl::EglContext context;
  const std::vector<Row> all = rows();
  Sheet sheet((cell + gap) * glm::ivec2(static_cast<int>(columns.size()), static_cast<int>(all.size())) - gap);
  for (std::size_t r = 0; r < all.size(); ++r) {
    const app::LoadedScene loaded = app::loadScene(all[r].options);
    View view = loaded.view;
    view.camera = view.camera.zoomed(all[r].zoom).panned(0.0, all[r].raise);
    view.size = cell * finer;
    view.pixelScale = view.size.x / methodPictureWidth;
    view.quality = Quality::High;
    Renderer renderer(std::make_shared<GpuScene>());
    for (std::size_t c = 0; c < columns.size(); ++c) {
      renderer.render(sceneOf(loaded.scene, columns[c]), view);
      const std::vector<std::uint8_t> picture = renderer.readPicture();
      sheet.place(picture, (cell + gap) * glm::ivec2(static_cast<int>(c), static_cast<int>(r)));
      if (!folder.empty())
        io::writePng(folder / (all[r].name + "-" + columns[c].name + ".png"), view.size, 3, withoutAlpha(picture));
    }
  }
  io::writePng(output, sheet.size, 3, sheet.pixels);
}

}  // namespace
}  // namespace fenestra

int main(int argc, char** argv) {
  if (argc < 2 || argc > 3) {
    std::cerr << "usage: figure-sheet OUT.png [FOLDER]\n";
    return 2;
  }
  try {
    fenestra::draw(argv[1], argc > 2 ? argv[2] : "");
  } catch (const std::exception& error) {
    std::cerr << "figure-sheet: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
