#pragma once
// One anatomical plane through the volume, or the plane that it was turned to (SlicePlanes): grey values under the
// window, label colours, focus outline, crosshair. Plain QWidget and QImage, so it works where 3-D cannot start.
//
// Left click: crosshair and focus, see clickStructure(); left drag: window/level, unless a tool takes it; middle: pan;
// right drag or Ctrl+wheel: zoom; wheel and arrows: slices; Shift+wheel: slab; Shift+move: crosshair. The tools:
// CarveTool, SelectionTool, ToleranceWheel, ClipTool, PathTool, MeasureTool, PlaneTool, RegionBallTool.

#include <memory>
#include <optional>

#include <QImage>
#include <QPainterPath>
#include <QPolygonF>
#include <QTransform>
#include <QWidget>

#include "rendering/settings/Focus.h"
#include "rendering/volume/LabelMap.h"
#include "rendering/volume/Slab.h"
#include "rendering/volume/Slice.h"
#include "viewer/model/Fidelity.h"
#include "viewer/model/Lateness.h"
#include "viewer/tools/CarveTool.h"
#include "viewer/tools/ClipTool.h"
#include "viewer/tools/MeasureTool.h"
#include "viewer/tools/PathTool.h"
#include "viewer/tools/PlaneTool.h"
#include "viewer/tools/RegionBallTool.h"
#include "viewer/tools/SelectionTool.h"
#include "viewer/tools/ToleranceWheel.h"
#include "viewer/tools/ViewTools.h"

namespace fenestra::viewer {

class Document;
class OpeningEdge;
class SliceCanvas;
class SliceCursor;
class SlicePlanes;
class ViewOptions;
struct Workspace;

class SliceView : public QWidget {
  Q_OBJECT
 public:
  /// `workspace` and `opening` outlive this.
  SliceView(SlicePlane plane, Workspace& workspace, OpeningEdge& opening, QWidget* parent = nullptr);
  ~SliceView() override;

  SlicePlane plane() const { return geometry_.plane; }
  /// All slices along the plane's normal: where they lie, and their pictures' size of at least the volume's voxels.
  const SliceGeometry& sliceGeometry() const { return geometry_; }
  int slice() const { return slice_; }
  const MeasureTool& measureTool() const { return measureTool_; }
  const ClipTool& clipTool() const { return clipTool_; }
  const PlaneTool& planeTool() const { return planeTool_; }
  /// Fits the whole slice into the view, neither flipped nor turned, and sets the data's own window and level.
  void resetView();

  /// How the picture lies in the view: mirrored across, then turned clockwise.
  struct Turn {
    bool mirrored = false;
    int quarters = 0;  ///< 0 to 3
    bool operator==(const Turn&) const = default;
  };
  /// The user's turn, and with ViewOptions::isNeurological() the mirroring that this is for axial and coronal slices.
  Turn turn() const;
  void flipAcross();
  void flipDown();
  void turnClockwise();
  /// World directions of the view's right and down, as long as a pixel of the slice along them.
  glm::dvec3 screenRight() const;
  glm::dvec3 screenDown() const;
  /// Shows a millimetre as one on the screen, around the middle. False where the screen does not say how large it is.
  bool showTrueSize();
  bool isTrueSize() const;
  /// Device-independent pixels of a millimetre, and showing so many, around the crosshair.
  double scale() const { return pixelsPerMm(); }
  void setScale(double pixelsPerMm);

  /// Where a world point lies in the widget when projected onto the slice, and the point of the shown slice at a place
  /// in the widget.
  QPointF widgetFromWorld(glm::dvec3 world) const;
  glm::dvec3 worldFromWidget(QPointF position) const;

  /// The edge of what C1's opening removes of the shown slice, in the widget; empty while C1 moves.
  QPainterPath openingEdge() const;
  /// Something that the slices show has yet to be made of what was asked for.
  void setAwaits(bool awaits);
  /// What makes the view less than exact; see Fidelity.h.
  std::vector<FidelityCause> fidelity() const;
  /// Draws the view as it is on screen; without `marks` only the picture with its tints and outlines.
  void draw(QPainter& painter, bool marks);
  /// The plane's name, as the view's title shows it.
  QString name() const;
  bool showsText() const;  ///< in the corners

  QSize sizeHint() const override { return {320, 300}; }
  QSize minimumSizeHint() const override { return {120, 120}; }

 Q_SIGNALS:
  /// The mouse points at a world position.
  void pointed(glm::dvec3 world);
  void left();
  void menuRequested(glm::dvec3 world, QPoint globalPosition);
  /// `measure` is its place in Document::measures().
  void measureMenuRequested(std::size_t measure, QPoint globalPosition);
  void maximiseRequested();
  /// The user has zoomed; see scale().
  void scaled();
  /// A click without a modifier, at a world position.
  void picked(glm::dvec3 world);
  /// The click that was reported last was the first half of a double click.
  void pickTakenBack();

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void leaveEvent(QEvent* event) override;

 private:
  /// A growth's steps on the slice.
  struct Steps {
    std::vector<std::uint16_t> all;      ///< empty until they are read
    std::shared_ptr<const LabelMap> of;  ///< the map that they are read from
  };
  /// Shows another volume from the beginning: neither a drag nor a click on the one before goes on.
  void showVolume();
  void readGeometry();
  /// Drops the shown slice's data and images.
  void forgetSlice();
  void followCursor();
  /// The plane lies elsewhere: the crosshair keeps its place in the view.
  void followPlane();
  /// Goes on with other slices; a point keeps its place in the view.
  void setGeometry(const SliceGeometry& geometry, glm::dvec3 kept);
  /// Drops what was made for other pixels than those that the view needs now.
  void preparePicture();
  void invalidate();
  void makeImage();
  /// Tints of a pixel's label, and of the focus over it.
  class Tints;
  /// Pixels of the picture, from its corner, to the widget.
  QTransform widgetFromPixels() const;
  /// Millimetres from the corner of the slice's first pixel to the widget.
  QTransform widgetFromMm() const;
  /// The view's sides along the slice's right and down, in the widget's pixels.
  QSizeF sizeAlongSlice() const;
  /// A move in the widget as one on the slice, mm.
  QPointF mmOfMove(QPointF move) const;
  void setTurn(Turn turn);
  /// Device-independent pixels of a millimetre on the screen; 0 where the screen does not say it.
  double screenPixelsPerMm() const;
  /// Which sides the patient's left and right are on, and how the picture was turned, in words.
  QStringList conventionText() const;
  void readSteps(Steps& steps, std::shared_ptr<const LabelMap> of) const;
  void collectOutlines(const std::vector<char>& focused);
  void zoomAt(QPointF position, double factor);
  /// As the user does it by the mouse or a key.
  void zoomByHand(QPointF position, double factor);
  void click(QPointF position, Qt::KeyboardModifiers modifiers);
  double pixelsPerMm() const;
  /// Window and level in one line, or in two where one would reach the edge's letter.
  QStringList windowText(const QFontMetrics& metrics) const;
  bool inPicture(glm::dvec3 world) const;
  class ToolCanvas;
  std::unique_ptr<SliceCanvas> makeCanvas();
  const QList<QPolygonF>& removedOutline() const;
  /// Outlines of the focus, the opening and the removals.
  void drawOutlines(QPainter& painter) const;
  /// Crosshair, seeds, letters, scale bar and corner text.
  void drawMarks(QPainter& painter, bool interpolated) const;
  void drawCrosshair(QPainter& painter) const;
  /// What the slice is, beside its name and its number.
  QStringList planeText() const;
  void drawSeeds(QPainter& painter) const;
  /// Marks the planes that were not scanned. Returns whether the shown slice is one.
  bool drawInterpolated(QPainter& painter) const;
  bool showsInterpolated() const;

  Document& document_;
  SliceCursor& cursor_;
  SlicePlanes& planes_;
  ViewOptions& options_;

  SliceGeometry geometry_;
  int slice_ = 0;
  QSizeF fitted_;  ///< mm, what fits into the view at zoom 1: stays while the plane turns
  /// The pixels that the view shows: geometry_'s own, or those of a turned plane that are in sight, at the size of the
  /// screen's where these are larger. All pictures and outlines below are in these pixels.
  struct Picture {
    SliceGeometry geometry;
    int slice = 0;
    QPointF corner;  ///< mm from geometry_'s corner
    Slab slab;
  };
  Picture picture_;
  Picture wantedPicture() const;
  std::vector<float> values_;  ///< real values of the slice
  struct GreyLevels {
    WindowLevel window;
    bool lowIsWhite = false;
    bool operator==(const GreyLevels&) const = default;
  } greyLevels_;                       ///< what grey_ was made with
  std::vector<std::uint8_t> grey_;     ///< the values through the window; empty until it is made
  std::vector<std::uint16_t> labels_;  ///< labels of the slice; empty without labels
  Steps steps_;                        ///< of the region that shows as the focus
  Steps awaited_;                      ///< of the region in the focus, while another focus shows
  QImage image_;                       ///< null until it is made
  QList<QPolygonF> outline_;           ///< outline of the focus, in slice pixels from the picture's corner
  QList<QPolygonF> awaitedOutline_;    ///< of awaited_, as outline_

  OpeningEdge& opening_;
  /// Outline of what is carved away, in pixels as outline_; empty until it is found.
  mutable std::optional<QList<QPolygonF>> removedOutline_;
  mutable std::optional<QList<QPolygonF>> openingOutline_;  ///< in pixels as outline_; empty until it is found

  Turn turn_;          ///< the user's
  double zoom_ = 1.0;  ///< 1: the whole slice fits
  QPointF centre_;     ///< slice position in the middle of the widget, in mm from the corner of the slice's first pixel

  QPointF pressed_, last_;  ///< mouse positions of the press and of the last move
  WindowLevel windowAtPress_;
  bool dragging_ = false;
  /// The state before the last click, which a double click restores.
  struct BeforeClick {
    Focus focus;
    glm::dvec3 cursor;
  };
  std::optional<BeforeClick> beforeClick_;
  const std::unique_ptr<SliceCanvas> canvas_;  ///< this view, as tools see it
  CarveTool carveTool_;
  SelectionTool selectionTool_;
  ToleranceWheel toleranceWheel_;
  ClipTool clipTool_;
  RegionBallTool ballTool_;
  PathTool pathTool_;
  MeasureTool measureTool_;
  PlaneTool planeTool_;
  ViewTools tools_;
  bool toolTookPress_ = false;
  bool awaits_ = false;     ///< see setAwaits()
  Lateness lateness_;       ///< of what was asked for and does not show
  double wheel_ = 0.0;      ///< wheel angle that is not yet a whole notch, in eighths of a degree
  double slabWheel_ = 0.0;  ///< the same, of the wheel that changes the slab
};

}  // namespace fenestra::viewer
