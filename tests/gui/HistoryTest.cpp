// Undo and redo of a document's edits.

#include <array>
#include <functional>
#include <random>

#include <gtest/gtest.h>

#include <QSignalSpy>

#include "viewer/model/Document.h"

namespace fenestra::viewer::historyTest {
namespace {

io::Study study() {
  auto volume = std::make_shared<Volume>();
  auto labels = std::make_shared<LabelMap>();
  volume->grid = labels->grid = {.dims = glm::ivec3(4)};
  volume->voxels = Voxels(ScalarType::Int16, volume->grid.voxelCount());
  labels->voxels = Voxels(ScalarType::UInt8, volume->grid.voxelCount());
  for (std::size_t i = 0; i < volume->voxels.count(); ++i)
    volume->voxels.as<std::int16_t>()[i] = static_cast<std::int16_t>(10 * i);
  volume->computeRange();
  labels->labels = {{1, "first", {1, 0, 0}}, {2, "second", {0, 1, 0}}, {7, "third", {0, 0, 1}}};
  io::Study made;
  made.scene.volume = volume;
  made.scene.labels = labels;
  made.scene.look.context.function.nodes = {{100.0, {{1, 1, 1}, 0.0}}, {200.0, {{1, 1, 1}, 1.0}}};
  made.scene.look.context.preset = "ct-bone";
  return made;
}

BrushStroke dab(double x) { return {.anchors = {{x, 0.0, 0.0}}}; }

/// Random edits of all kinds, made as the window makes them.
class RandomEdits {
 public:
  RandomEdits(Document& document, unsigned seed) : document_(document), engine_(seed) {}

  void make() {
    switch (below(8)) {
      case 0:
        return document_.setFocused(std::array<std::uint16_t, 3>{1, 2, 7}[below(3)], below(2) == 0);
      case 1:
        return document_.setFocus(ValueFocus{.values = {number(), 1000.0 + number()}});
      case 2:
        return document_.setShift(number());
      case 3:
        return document_.setPreset(std::array{"ct-bone", "ct-angio", "mr"}[below(3)]);
      case 4: {
        Look look = document_.look();
        look.cutaway.openWidth = number();
        look.cutaway.enabled = below(2) == 0;
        return document_.edit(QStringLiteral("Cutaway"), std::move(look));
      }
      case 5: {
        Look look = document_.look();
        look.contextLayer.strength = number();
        look.shading.ambient = number();
        look.background.g = number();
        look.hideTable = below(2) == 0;
        look.reconstruction = static_cast<Reconstruction>(below(4));
        look.labelSmoothing = static_cast<LabelSmoothing>(below(3));
        look.edges = static_cast<Edges>(below(2));
        look.backdrop = static_cast<Backdrop>(below(2));
        look.backgroundTop.b = number();
        return document_.edit(QStringLiteral("Light"), std::move(look));
      }
      case 6: {
        BrushStrokes strokes = document_.strokes();
        BrushStroke stroke;
        stroke.mode = static_cast<BrushMode>(below(4));
        stroke.radius = 1.0 + number();
        for (std::size_t anchor = 0; anchor <= below(60); ++anchor) stroke.anchors.emplace_back(number());
        strokes.push_back(stroke);
        return document_.setStrokes(std::move(strokes), QStringLiteral("Stroke"));
      }
      default: {
        BrushStrokes strokes = document_.strokes();
        if (strokes.empty()) return;
        const std::size_t one = below(strokes.size());
        if (below(2) == 0)
          strokes[one].hidden = !strokes[one].hidden;
        else
          strokes.erase(strokes.begin() + static_cast<std::ptrdiff_t>(one));
        return document_.setStrokes(std::move(strokes), QStringLiteral("Strokes"));
      }
    }
  }

 private:
  std::size_t below(std::size_t end) { return std::uniform_int_distribution<std::size_t>(0, end - 1)(engine_); }
  double number() { return std::uniform_real_distribution<double>(0.0, 100.0)(engine_); }

  Document& document_;
  std::mt19937 engine_;
};

TEST(History, AThousandRandomEditsAreUndoneAndRedoneToTheBit) {
  Document document;
  document.open(study());
  RandomEdits random(document, 5);
  std::vector<Look> states{document.look()};
  std::vector<Scene> scenes{document.scene()};
  while (states.size() <= 1000) {
    const int before = document.undoStack().index();
    random.make();
    const bool changed = !(document.look() == states.back());
    ASSERT_EQ(document.undoStack().index(), before + (changed ? 1 : 0)) << "a step for a change, and for nothing else";
    if (!changed) continue;
    states.push_back(document.look());
    scenes.push_back(document.scene());
  }
  ASSERT_EQ(document.undoStack().count(), 1000);
  for (std::size_t at = 1000; at-- > 0;) {
    document.undoStack().undo();
    ASSERT_EQ(document.look(), states[at]) << "after undoing step " << at;
    ASSERT_EQ(document.scene(), scenes[at]) << "after undoing step " << at;
  }
  EXPECT_FALSE(document.undoStack().canUndo());
  for (std::size_t at = 1; at <= 1000; ++at) {
    document.undoStack().redo();
    ASSERT_EQ(document.look(), states[at]) << "after redoing step " << at;
    ASSERT_EQ(document.scene(), scenes[at]) << "after redoing step " << at;
  }
  EXPECT_FALSE(document.undoStack().canRedo());
}

TEST(History, StepsOfOneGestureAreOneStep) {
  Document document;
  document.open(study());
  const Look first = document.look();
  History& history = document.history();
  history.beginGesture();
  for (const double shift : {1.0, 2.0, 3.0}) document.setShift(shift);
  document.focusOn(2);
  history.endGesture();
  EXPECT_EQ(history.stack().count(), 2) << "another name is another step";
  document.setShift(4.0);
  document.setShift(5.0);
  EXPECT_EQ(history.stack().count(), 4) << "outside a gesture each is its own";
  history.beginGesture();
  document.setShift(6.0);
  history.endGesture();
  history.beginGesture();
  document.setShift(7.0);
  history.endGesture();
  EXPECT_EQ(history.stack().count(), 6);
  history.stack().setIndex(1);
  EXPECT_EQ(document.shift(), 3.0);
  history.stack().setIndex(0);
  EXPECT_EQ(document.look(), first);
}

TEST(History, StrokesThatGrowWithinAGestureComeBackWhole) {
  Document document;
  document.open(study());
  document.setStrokes({dab(1.0), dab(2.0)}, QStringLiteral("Load"));
  const Look before = document.look();
  document.history().beginGesture();
  BrushStroke stroke = dab(3.0);
  for (int point = 0; point < 20; ++point) {
    stroke.anchors.emplace_back(3.0, point, 0.0);
    BrushStrokes strokes = before.strokes;
    strokes.push_back(stroke);
    document.setStrokes(std::move(strokes), QStringLiteral("Stroke"));
  }
  document.history().endGesture();
  const Look after = document.look();
  ASSERT_EQ(document.undoStack().count(), 2);
  document.undoStack().undo();
  EXPECT_EQ(document.look(), before);
  document.undoStack().redo();
  EXPECT_EQ(document.look(), after);
}

TEST(History, StrokesDeletedAnywhereWithinAGestureComeBackInTheirOrder) {
  const BrushStrokes all{dab(1.0), dab(2.0), dab(3.0), dab(4.0)};
  for (std::size_t first = 0; first < all.size(); ++first)
    for (std::size_t second = 0; second + 1 < all.size(); ++second) {
      SCOPED_TRACE(std::to_string(first) + " then " + std::to_string(second));
      Document document;
      document.open(study());
      document.setStrokes(all, QStringLiteral("Load"));
      const Look before = document.look();
      document.history().beginGesture();
      for (const std::size_t place : {first, second}) {
        BrushStrokes strokes = document.strokes();
        strokes.erase(strokes.begin() + static_cast<std::ptrdiff_t>(place));
        document.setStrokes(std::move(strokes), QStringLiteral("Delete stroke"));
      }
      document.history().endGesture();
      const Look after = document.look();
      ASSERT_EQ(document.undoStack().count(), 2);
      document.undoStack().undo();
      EXPECT_EQ(document.look(), before);
      document.undoStack().redo();
      EXPECT_EQ(document.look(), after);
    }
}

TEST(History, AGestureThatEndsWhereItBeganIsNoStep) {
  Document document;
  document.open(study());
  document.history().beginGesture();
  document.setShift(1.0);
  document.setShift(0.0);
  document.history().endGesture();
  EXPECT_EQ(document.undoStack().count(), 0);
  document.setShift(0.0);
  document.edit(QStringLiteral("Look"), document.look());
  document.setFocus(document.focus());
  EXPECT_EQ(document.undoStack().count(), 0) << "what changes nothing is no step";
}

TEST(History, AGestureDoesNotReachBackOverASave) {
  Document document;
  document.open(study());
  document.history().beginGesture();
  document.setShift(1.0);
  document.undoStack().setClean();
  document.setShift(2.0);
  document.history().endGesture();
  EXPECT_FALSE(document.undoStack().isClean());
  document.undoStack().undo();
  EXPECT_TRUE(document.undoStack().isClean());
  EXPECT_EQ(document.shift(), 1.0);
}

TEST(History, WhatIsTakenBackCannotBeRedone) {
  Document document;
  document.open(study());
  document.focusOn(1);
  document.focusOn(7);
  document.history().takeBack();
  EXPECT_TRUE(document.isFocused(1));
  EXPECT_FALSE(document.undoStack().canRedo());
  EXPECT_EQ(document.undoStack().count(), 1);
}

TEST(History, AnotherStudyOrLabelMapStartsAnew) {
  Document document;
  document.open(study());
  document.setShift(1.0);
  document.open(study());
  EXPECT_EQ(document.undoStack().count(), 0);
  document.focusOn(1);
  document.setLabels(nullptr);
  EXPECT_EQ(document.undoStack().count(), 0) << "undoing would bring back a focus of labels that no longer exist";
}

/// A change of a given size.
class Weight : public Change {
 public:
  explicit Weight(std::size_t bytes, int& sum) : bytes_(bytes), sum_(sum) { ++sum_; }
  void undo() override { --sum_; }
  void redo() override { ++sum_; }
  bool absorb(const Change&) override { return false; }
  bool isNothing() const override { return false; }
  std::size_t bytes() const override { return bytes_; }

 private:
  std::size_t bytes_;
  int& sum_;
};

TEST(History, MeasuresGoBeforeTheirVolume) {
  Document document;
  document.open(study());
  const Measure distance{MeasureKind::Distance, {{0, 0, 1}, {2, 0, 1}}, {1, 0, 0}, {0, 1, 0}};
  std::vector<std::size_t> heard;
  QObject::connect(&document, &Document::volumeChanged, [&] { heard.push_back(document.measures().size()); });
  document.setMeasures({distance}, QStringLiteral("Distance"));
  document.open(study());
  document.setMeasures({distance}, QStringLiteral("Distance"));
  document.close();
  EXPECT_EQ(heard, (std::vector<std::size_t>{0, 0})) << "a tool would look them up in another volume, or in none";
}

TEST(History, MemoryIsBoundedAndTheOldestStepsGoFirst) {
  constexpr std::size_t limit = 100000;
  History history(limit);
  int sum = 0;
  QSignalSpy named(&history.stack(), &QUndoStack::undoTextChanged);
  for (int step = 1; step <= 500; ++step) {
    history.push(QString::number(step), std::make_shared<Weight>(step % 7 == 0 ? 30000 : 900, sum));
    ASSERT_LE(history.bytes(), limit);
    ASSERT_EQ(history.stack().undoText(), QString::number(step));
    ASSERT_EQ(named.count(), step);
    ASSERT_EQ(sum, step) << "dropping old steps neither undoes nor redoes any";
  }
  const int kept = history.stack().count();
  EXPECT_GE(kept, 6);
  while (history.stack().canUndo()) history.stack().undo();
  EXPECT_EQ(sum, 500 - kept);
  while (history.stack().canRedo()) history.stack().redo();
  EXPECT_EQ(sum, 500);
  history.push(QStringLiteral("huge"), std::make_shared<Weight>(2 * limit, sum));
  EXPECT_EQ(history.stack().count(), 1) << "the latest stays";
}

TEST(History, TheSavedStateIsKnownAfterOldStepsHaveGone) {
  for (const int savedAt : {0, 60, 95}) {
    History history(100000);
    int sum = 0;
    const auto push = [&] { history.push(QStringLiteral("step"), std::make_shared<Weight>(4000, sum)); };
    for (int step = 0; step < savedAt; ++step) push();
    history.stack().setClean();
    for (int step = savedAt; step < 100; ++step) push();
    EXPECT_FALSE(history.stack().isClean());
    while (history.stack().canUndo() && !history.stack().isClean()) history.stack().undo();
    EXPECT_EQ(history.stack().isClean(), savedAt == 95) << savedAt;
    if (savedAt == 95) {
      EXPECT_EQ(sum, 95);
    }
  }
}

TEST(History, StrokesAreCountedByTheirAnchors) {
  Document document;
  document.open(study());
  BrushStroke stroke;
  stroke.anchors.resize(1000);
  document.setStrokes({stroke}, QStringLiteral("Stroke"));
  const std::size_t one = document.history().bytes();
  EXPECT_GE(one, 1000 * sizeof(glm::dvec3));
  BrushStrokes two = document.strokes();
  two.push_back(stroke);
  document.setStrokes(std::move(two), QStringLiteral("Stroke"));
  // The second step holds the second stroke alone; the allocator may add a few bytes.
  EXPECT_NEAR(static_cast<double>(document.history().bytes()), 2.0 * static_cast<double>(one), 1000.0);
}

/// Steps hold what they point to, or the limit of the history would not be one.
TEST(History, EverythingThatALookPointsToIsCounted) {
  constexpr std::size_t count = 1000;
  const TransferFunction function{std::vector<TransferFunction::Node>(count)};
  const std::vector<glm::dvec3> points(count);
  const struct {
    const char* name;
    std::size_t bytes;
    std::function<void(Look&)> change;
  } parts[] = {
      {"function of the context", sizeof(TransferFunction::Node),
       [&](Look& look) { look.context.function = function; }},
      {"function of the focus", sizeof(TransferFunction::Node),
       [&](Look& look) { look.focusAppearance.function = function; }},
      {"function of a label", sizeof(TransferFunction::Node),
       [&](Look& look) { look.labels = {{.label = 1, .function = function}}; }},
      {"labels", sizeof(LabelSetting), [&](Look& look) { look.labels.resize(count); }},
      {"labels in focus", sizeof(std::uint16_t),
       [&](Look& look) { look.focus = LabelFocus{std::vector<std::uint16_t>(count)}; }},
      {"seeds", sizeof(glm::dvec3),
       [&](Look& look) {
         look.focus = RegionFocus{{{0, 0, 0}}, points, {}};
       }},
      {"painted region", sizeof(glm::dvec3),
       [&](Look& look) {
         look.focus = RegionFocus{{}, {}, {}, {{points}}};
       }},
      {"brush stroke", sizeof(glm::dvec3), [&](Look& look) { look.strokes = {{.anchors = points}}; }},
      {"carving", sizeof(glm::dvec3), [&](Look& look) { look.removals.emplace_back().points = points; }},
      {"bends", sizeof(Bend), [&](Look& look) { look.removals.emplace_back().bends.resize(count); }},
      {"labels that are never clipped", sizeof(std::uint16_t), [&](Look& look) { look.clipping.exempt.resize(count); }},
      {"file", 1, [&](Look& look) { look.context.file = std::string(count, 'x'); }},
  };
  for (const auto& part : parts) {
    SCOPED_TRACE(part.name);
    Document document;
    document.open(study());
    Look look = document.look();
    part.change(look);
    document.edit(QStringLiteral("step"), std::move(look));
    EXPECT_GE(document.history().bytes(), count * part.bytes);
    EXPECT_LT(document.history().bytes(), count * part.bytes + 20000) << "counted once";
  }
}

TEST(History, AFocusBesideAnEditOfLabelsIsCounted) {
  Document document;
  document.open(study());
  segmentation::LabelEdit edit = segmentation::renamed(*document.labels(), 1, "another");
  std::shared_ptr<const LabelMap> after = edit.applied(document.labels().get());
  const std::vector<glm::dvec3> seeds(1000);
  document.editLabels(QStringLiteral("step"), std::move(edit), std::move(after), RegionFocus{seeds, {}, {}});
  EXPECT_GE(document.history().bytes(), seeds.size() * sizeof(glm::dvec3));
}

}  // namespace
}  // namespace fenestra::viewer::historyTest
