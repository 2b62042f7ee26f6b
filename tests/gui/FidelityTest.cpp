// The causes that make a picture less than exact, each forced by the data, the scene or the picture's own state.

#include <gtest/gtest.h>

#include <functional>

#include "rendering/segmentation/DrawnScene.h"
#include "rendering/settings/StartingLook.h"
#include "viewer/model/Fidelity.h"

namespace fenestra::viewer::fidelityTest {
namespace {

/// A bounded picture of a small volume that nothing alters.
struct Shown {
  io::Study study;
  Scene scene;
  PictureState state{.quality = Quality::Normal, .maxError = 0.5};

  Shown() {
    auto volume = std::make_shared<Volume>();
    volume->grid.dims = glm::ivec3(300);  // fine voxels, so that automatic smoothing has nothing to do
    volume->voxels = Voxels(ScalarType::UInt8, volume->grid.voxelCount());
    auto labels = std::make_shared<LabelMap>();
    labels->grid = volume->grid;
    labels->labels = {{1, "one", {1.0, 1.0, 1.0}}, {2, "two", {1.0, 1.0, 1.0}}};
    scene.volume = volume;
    scene.labels = labels;
    scene.look.hideTable = false;
  }
  std::vector<FidelityCause> causes() const { return fidelityOf(study, scene, state); }
  Fidelity grade() const { return gradeOf(causes()); }
  QString text() const { return linesOf(causes()).join(QLatin1Char('\n')); }
};

io::GeometryReport resampled(int gaps) {
  io::GeometryReport report;
  report.applied = io::Regularise::Linear;
  report.slices = 18;
  report.planes = 20;
  for (int plane = 0; plane < gaps; ++plane) report.interpolatedPlanes.push_back(plane);
  return report;
}

TEST(Fidelity, NothingAltersAPictureWithinAnInvisibleBound) {
  Shown shown;
  EXPECT_EQ(shown.grade(), Fidelity::Faithful) << shown.text().toStdString();
  shown.state.maxError = 2.0;
  EXPECT_EQ(shown.grade(), Fidelity::Bounded);
  EXPECT_TRUE(shown.text().contains(QStringLiteral("at most 2/255")));
  EXPECT_TRUE(shown.text().contains(QStringLiteral("not verified")));
  shown.state.verified = QStringLiteral("99.9 % within 2/255");
  EXPECT_TRUE(shown.text().contains(QStringLiteral("verified: 99.9 % within 2/255")));
  EXPECT_FALSE(shown.text().contains(QStringLiteral("not verified")));
}

TEST(Fidelity, ASliceOfEvenDataIsFaithful) {
  Shown shown;
  shown.state = {.is3D = false};
  shown.scene.look.labelSmoothing = LabelSmoothing::Strong;  // of 3-D pictures alone
  shown.scene.look.focus = LabelFocus{{1}};
  EXPECT_TRUE(shown.causes().empty());
  EXPECT_EQ(linesOf(shown.causes()), QStringList{QStringLiteral("faithful")});
}

/// Each row forces one cause; `in` and `of` are where it counts and what its line says.
struct Alteration {
  const char* name;
  std::function<void(Shown&)> force;
  const char* says;
  bool in3D = true, inSlices = false;
  Fidelity grade = Fidelity::Altered;
};

std::vector<Alteration> alterations() {
  const auto warning = [](io::Warning::Kind kind) {
    return [kind](Shown& shown) { shown.study.warnings = {{kind, "something", {"a", "b"}}}; };
  };
  using Kind = io::Warning::Kind;
  return {
      {"old", [](Shown& s) { s.state.isCurrent = false; }, "not yet what was asked for", true, true},
      {"draft",
       [](Shown& s) {
         s.state.isDraft = true;
         s.state.scale = 0.5;
       },
       "50 % of the size", true, true},
      {"no bound", [](Shown& s) { s.state.maxError.reset(); }, "no bound (quality: normal)", true, false,
       Fidelity::Approximate},
      {"joined voxels", [](Shown& s) { s.state.reduction = QStringLiteral("2×2×2 voxels as one"); }, "2×2×2"},
      {"spline", [](Shown& s) { s.scene.look.reconstruction = Reconstruction::Smooth; }, "smoothed between voxels",
       true, false, Fidelity::Approximate},
      {"smoother spline", [](Shown& s) { s.scene.look.reconstruction = Reconstruction::Smoother; }, "several voxels",
       true, false, Fidelity::Approximate},
      {"cubic spline", [](Shown& s) { s.scene.look.reconstruction = Reconstruction::Cubic; }, "cubic", true, false,
       Fidelity::Approximate},
      {"labels",
       [](Shown& s) {
         s.scene.look.focus = LabelFocus{{1}};
         s.scene.look.labelSmoothing = LabelSmoothing::Light;
       },
       "labels is smoothed lightly", true, false, Fidelity::Approximate},
      {"clipped",
       [](Shown& s) {
         s.scene.look.clipping.planes = {{glm::dvec3(1, 0, 0), 5.0}};
       },
       "clipped, by 1 plane"},
      {"hidden",
       [](Shown& s) {
         s.scene.look.labels = {{.label = 1, .role = LabelRole::Hidden}, {.label = 2, .role = LabelRole::Hidden}};
       },
       "2 structures are hidden"},
      {"carved", [](Shown& s) { s.scene.removed = std::make_shared<RemovedVoxels>(); }, "carved away"},
      {"table",
       [](Shown& s) {
         auto table = std::make_shared<CoarseMask>();
         table->count = 1;
         s.scene.table = table;
         s.scene.look.hideTable = true;
       },
       "table is left out"},
      {"resampled", [](Shown& s) { s.study.geometry = resampled(0); }, "18 slices are resampled onto 20", true, true},
      {"interpolated", [](Shown& s) { s.study.geometry = resampled(3); }, "3 of 20 planes are interpolated", true,
       true},
      {"tilt",
       [](Shown& s) {
         s.study.geometry = resampled(0);
         s.study.geometry->sheared = true;
       },
       "tilt is made straight", true, true},
      {"misplaced",
       [](Shown& s) {
         s.study.geometry = io::GeometryReport{};
         s.study.geometry->displacement = 12.5;
       },
       "up to 12.5 mm from their true places", true, true},
      {"assumed geometry", warning(Kind::NoGeometry), "are assumed, because the file does not give them (2 files)",
       true, true},
      {"damage", warning(Kind::DamagedPixels), "outside of what the file's header allows", true, true},
      {"precision", warning(Kind::PrecisionLoss), "rounded", true, true},
      {"missing slices", warning(Kind::MissingSlices), "slices are missing", true, true},
      {"unreadable", warning(Kind::UnreadableFiles), "files were left out", true, true},
      {"duplicates", warning(Kind::DuplicateSlices), "one place were left out", true, true},
      {"mixed sizes", warning(Kind::MixedSizes), "another size or direction", true, true},
      {"changed data", warning(Kind::ChangedData), "differ from those of the session", true, true},
  };
}

TEST(Fidelity, NothingAltersAPictureInSilence) {
  for (const Alteration& each : alterations()) {
    Shown shown;
    each.force(shown);
    EXPECT_EQ(shown.grade(), each.in3D ? each.grade : Fidelity::Faithful) << each.name;
    EXPECT_TRUE(shown.text().contains(QString::fromUtf8(each.says))) << each.name << ": " << shown.text().toStdString();
    EXPECT_EQ(shown.causes().front().grade, each.grade) << each.name << ": the worst is told first";
    shown.state.is3D = false;
    EXPECT_EQ(shown.grade(), each.inSlices ? Fidelity::Altered : Fidelity::Faithful) << each.name << " in a slice";
  }
}

TEST(Fidelity, WhatDataOpenWithWarnsOfNothing) {
  Shown shown;
  shown.scene.look = startingLook();
  shown.scene.look.focus = LabelFocus{{1}};
  shown.state.maxError.reset();
  EXPECT_EQ(shown.grade(), Fidelity::Approximate) << shown.text().toStdString();
  shown.scene.look.labels = {{.label = 2, .role = LabelRole::Hidden}};
  EXPECT_EQ(shown.grade(), Fidelity::Altered);
}

TEST(Fidelity, ASliceSaysThatItWasNotScanned) {
  Shown shown;
  shown.study.geometry = resampled(3);
  shown.state = {.is3D = false, .isInterpolated = true};
  EXPECT_TRUE(shown.text().contains(QStringLiteral("this plane was not scanned")));
}

TEST(Fidelity, WhatTheGeometrysReportTellsIsToldOnce) {
  Shown shown;
  shown.study.geometry = resampled(0);
  shown.study.warnings = {{io::Warning::Kind::MissingSlices, "1 slice missing", {}}};
  shown.study.geometry->findings = shown.study.warnings;
  EXPECT_FALSE(shown.text().contains(QStringLiteral("slices are missing")));
}

TEST(Fidelity, AnnouncementsAlterNothing) {
  Shown shown;
  for (const auto kind : {io::Warning::Kind::Recognised, io::Warning::Kind::TimePoints, io::Warning::Kind::MovedData})
    shown.study.warnings.push_back({kind, "something", {}});
  EXPECT_EQ(shown.grade(), Fidelity::Faithful);
}

}  // namespace
}  // namespace fenestra::viewer::fidelityTest
