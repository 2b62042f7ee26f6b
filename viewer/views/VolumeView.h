#pragma once
// One 3-D view: what a camera of the pair sees, drawn by a Renderer, with crosshair mark, orientation cube and
// (parallel projection only) scale bar over it.
//
// While something changes it draws as the pacer says, in its turn and not while the window is painted. After a moment
// of rest it refines the picture up to full quality, in slices of time between which the window answers; a change stops
// the refinement. Uploads and compilation run on another thread; until they are done the view keeps its last picture. A
// brush stroke changes little of the picture and is drawn at full quality at once.
//
// Left drag: rotate, unless a tool takes it; left click: crosshair and focus to what is seen, see clickStructure();
// middle: pan; right drag or wheel: zoom; arrows: turn by steps. The tools: BrushTool, CarveTool, SelectionTool,
// ToleranceWheel, ClipTool, WallTool, PlaneBallTool, RegionBallTool. Strokes that begin while another thread has the
// context wait until it is free.
//
// Another volume blanks the view at once, and a line says what is awaited until its first picture is there. A picture
// that has not been what was asked for since a moment is marked.

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include <QImage>
#include <QTimer>
#include <QWidget>

#include "rendering/scene/Opening.h"
#include "rendering/scene/Scene.h"
#include "rendering/scene/View.h"
#include "viewer/model/Fidelity.h"
#include "viewer/model/FramePacer.h"
#include "viewer/model/Lateness.h"
#include "viewer/model/ViewLink.h"
#include "viewer/tools/BrushTool.h"
#include "viewer/tools/CarveTool.h"
#include "viewer/tools/ClipTool.h"
#include "viewer/tools/PathTool.h"
#include "viewer/tools/PlaneBallTool.h"
#include "viewer/tools/RegionBallTool.h"
#include "viewer/tools/SelectionTool.h"
#include "viewer/tools/ToleranceWheel.h"
#include "viewer/tools/ViewTools.h"
#include "viewer/tools/WallTool.h"

namespace fenestra {
class GpuScene;
}

namespace fenestra::viewer {

class ActiveTool;
class Brush;
class ContextAnimation;
class Document;
class DrawingTurns;
class PictureCanvas;
class PictureSurface;
class RefinedPicture;
class ScenePreparation;
class SliceCursor;
class ViewOptions;
struct Workspace;

/// A picture at full quality, with the scene and the view that it shows.
struct FinishedPicture {
  Scene scene;
  View view;
  std::vector<glm::vec4> pixels;  ///< premultiplied RGBA before rounding to 8 bits, row by row from the top
  QImage image;                   ///< rounded, over the scene's background
};

class VolumeView : public QWidget {
  Q_OBJECT
 public:
  /// What all 3-D views of a window share: the voxels on the GPU and their OpenGL context, the measured speed of the
  /// machine, the turns in which views draw, the animation of the context, and whether the CPU draws.
  struct Shared {
    std::shared_ptr<ScenePreparation> preparation;
    std::shared_ptr<FramePacer> pacer;
    std::shared_ptr<DrawingTurns> turns;
    std::shared_ptr<ContextAnimation> animation;
    bool software = false;
  };

  /// `index` is the camera's place in the workspace's cameras. The workspace outlives this.
  VolumeView(int index, Workspace& workspace, Shared shared, QWidget* parent = nullptr);
  ~VolumeView() override;

  int index() const { return index_; }
  /// While held, the view keeps its picture of a moving scene and does not refine it: the GPU has other work first.
  void hold(bool on) { held_ = on; }
  /// The view shows the scene at full quality, or says why it cannot.
  bool isSettled() const;
  /// Draws again; to be called after the pacer's settings have changed.
  void redraw();
  /// The view that is drawn at rest.
  View restView() const { return viewFor(shared_.pacer->atRest()); }
  /// Why the view cannot draw; empty when it can.
  const QString& problem() const { return problem_; }
  /// The last notice of reduced().
  const QString& reduction() const { return reduction_; }
  /// The camera of the picture. In a view that is taller than wide its field of view is wider, so that the volume fits.
  Camera shownCamera() const;
  std::optional<QPointF> widgetFromWorld(glm::dvec3 world) const;
  /// Where the picture on screen shows a point of the volume. Exploded views move the part that it belongs to, and a
  /// peeled layer lies on its roll.
  glm::dvec3 shownAt(glm::dvec3 world) const;
  /// The picture on screen; empty while it is not at full quality.
  std::optional<FinishedPicture> finishedPicture();
  /// The picture on the screen with its marks, in device pixels.
  QImage grabSurface();
  /// The scene as this view shows it.
  Scene shownScene() const;
  /// Draws what lies over the picture of `camera`: mark of the crosshair, corner text, orientation cube, scale bar. The
  /// chip has the grade of `causes`.
  void drawMarks(QPainter& painter, const Camera& camera, const std::vector<FidelityCause>& causes) const;
  /// What makes the picture on screen less than exact; that of a picture at rest; see Fidelity.h.
  std::vector<FidelityCause> fidelity() const;
  std::vector<FidelityCause> fidelityAtRest() const;
  bool showsText() const;  ///< in the corners
  /// Notes what a certificate states of the picture on screen. It holds until the picture changes.
  void noteVerified(const QString& statement);
  /// The picture on screen is of the open study.
  bool hasPicture() const;
  /// What was asked for and does not show.
  const Lateness& lateness() const { return lateness_; }
  /// Something else than the picture has yet to be made of what was asked for.
  void setAwaits(bool awaits);
  /// What the view waits for is made by others than its renderer: a region, a label.
  bool awaitsOthers() const;
  /// Takes back what was asked for since the view last showed it.
  void takeBackWhatIsAwaited();
  const BrushTool& brushTool() const { return brushTool_; }
  const ClipTool& clipTool() const { return clipTool_; }
  const WallTool& wallTool() const { return wallTool_; }
  const PlaneBallTool& planeTool() const { return planeTool_; }
  /// Uploads and compiles for all views; others use its OpenGL context.
  ScenePreparation& preparation() { return *shared_.preparation; }
  /// Runs `work` with the pictures' OpenGL context current. Returns false without running it where the driver has lost
  /// the context.
  bool inGlContext(const std::function<void(const std::shared_ptr<GpuScene>&)>& work);

  QSize sizeHint() const override { return {480, 380}; }
  QSize minimumSizeHint() const override { return {160, 140}; }

 Q_SIGNALS:
  void settled();
  /// A picture is on screen; `isNew`: for the first time.
  void drawn(bool isNew);
  /// C1 alone: where its rays start, once it shows the scene at full quality; null when that changes.
  void raysStarted(std::shared_ptr<const RayStarts> starts);
  void failed(const QString& problem);
  /// The volume does not fit onto the device and is drawn with fewer voxels; `notice` says with how many.
  void reduced(const QString& notice);
  void pointed(glm::dvec3 world);
  void left();
  void menuRequested(glm::dvec3 world, QPoint globalPosition);
  void maximiseRequested();

 protected:
  bool event(QEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  /// Connects what changes the scene and the cameras.
  void followScene();
  /// Shows nothing of the study before.
  void forgetStudy();
  /// The picture is not of what was asked for.
  bool isBehind() const;
  /// To be called whenever isBehind() may have changed.
  void checkLate();
  void becomeOld();
  PictureState pictureState() const;
  void contextFreed();
  void drawPrepared();
  /// Draws a changing scene; `views` 3-D views draw with each change.
  void disturb(int views);
  /// Has another thread bring the scene up to date while this one paints the slices.
  void prepare();
  /// The effort for pictures of a changing scene.
  Effort motion() const;
  /// As disturb() after a camera of the pair has moved. A linked view skips frames that there is no time for.
  void follow();
  /// Begins to refine the picture.
  void settle();
  /// As settle() at the end of a drag, which no further move follows.
  void settleAtOnce();
  /// Reports raysStarted(), with the starts or with null.
  void reportStarts();
  void forgetStarts();
  /// Refines the picture for a moment.
  void refine();
  /// A refined picture is done.
  void refined(Effort effort);
  void stopRefining();
  /// Draws changed strokes, or other slices on walls: at once where the picture shown is at full quality.
  void refresh();
  /// Runs `work`, which needs the renderer and its context. When it throws, the view shows the problem and draws
  /// nothing until another volume is opened.
  void attempt(const std::function<void()>& work);
  /// As attempt(), for events: makes the context current, and does nothing where the view has no picture or another
  /// thread is preparing one.
  void attemptOnPicture(const std::function<void()>& work);
  View viewFor(Effort effort) const;
  /// Asks for a turn to draw what is due.
  void askToDraw();
  /// Draws what is due of the scene, to be shown by the next paint.
  void draw(const Scene& scene);
  /// False: the scene is not ready to be drawn, and stays due.
  bool drawDue(const Scene& scene);
  /// Draws the scene as something moves in it, and tells the pacer how long that took.
  void drawTimed(const Scene& scene, const View& view, Effort effort, const GpuScene& gpuScene);
  /// Has the surface painted again.
  void repaintSurface();
  /// Paints the surface.
  void paint();
  /// Puts the present picture into the surface.
  void present();
  void drawOverlay();
  /// Draws the strokes that wait, see keepsForLater().
  void drawWaiting(QPainter& painter) const;
  /// The painted picture is on the screen.
  void shown();
  void zoom(double factor);
  /// The ray of a pixel: where in the volume it starts to see, world mm, its unit direction there, and how many mm
  /// before that the opening has removed.
  struct Hit {
    glm::dvec3 start, ray;
    double removed = 0.0;
    bool moved = false;  ///< the ray sees other parts of the volume elsewhere
  };
  /// What the picture shows at a place in the widget; empty on the background.
  std::optional<Hit> pick(QPointF position);
  /// A point in the voxel that is seen first: from the start on, or before it where a protected label is seen.
  glm::dvec3 surfaceAt(const Hit& hit) const;
  /// Unit direction of the last picture's ray through a place in the widget.
  glm::dvec3 rayThrough(QPointF position) const;
  /// The point of the structure that shows most on the ray of a hit.
  glm::dvec3 seenAt(const Hit& hit) const;
  /// Reports what the picture shows under the mouse, once it is at full quality.
  void readUnderMouse();
  void click(const Hit& hit, Qt::KeyboardModifiers modifiers);
  glm::dvec2 pixelAt(QPointF position) const;
  class ToolCanvas;
  std::unique_ptr<PictureCanvas> makeCanvas();
  /// Draws other slices, where there are walls.
  void moveWalls();
  /// Keeps an event of a stroke for replay(), while nothing can be read of the picture. True: it is kept.
  bool keepsForLater(const QMouseEvent& event);
  /// Handles the events that were kept, on the picture that they were meant for.
  void replay();
  /// Connects what the stroke modes and the slices change.
  void followTools();
  double mmPerPixel(const Camera& camera) const;
  std::optional<QPointF> widgetFromWorld(glm::dvec3 world, const Camera& camera) const;
  double halfVoxel() const;  ///< mm, of the shortest side

  const int index_;
  Document& document_;
  SliceCursor& cursor_;
  ViewLink& cameras_;
  ViewOptions& options_;
  const Brush& brush_;
  const ActiveTool& active_;
  const std::unique_ptr<PictureCanvas> canvas_;  ///< this view, as tools see it
  BrushTool brushTool_;
  CarveTool carveTool_;
  SelectionTool selectionTool_;
  ToleranceWheel toleranceWheel_;
  ClipTool clipTool_;
  WallTool wallTool_;
  PlaneBallTool planeTool_;
  RegionBallTool ballTool_;
  PathTool pathTool_;
  ViewTools tools_;
  std::vector<std::unique_ptr<QMouseEvent>> waiting_;  ///< events of strokes, see keepsForLater()
  Shared shared_;
  PictureSurface* surface_;

  std::unique_ptr<RefinedPicture> picture_;  ///< null before the first picture, and where there is a problem
  QString problem_;
  QString reduction_;  ///< the last notice of reduced()
  /// What the view draws in its next turn. Nothing: it keeps its picture. Motion: the scene while something moves in
  /// it. Strokes: changed strokes or slices of walls.
  enum class Due : std::uint8_t { Nothing, Motion, Strokes } due_ = Due::Motion;
  bool isNew_ = false;                ///< the picture has not been painted
  bool isUnpainted_ = false;          ///< as isNew_, but also true for a refined picture
  bool isUnseen_ = false;             ///< a new picture is painted but not yet on the screen
  bool isTimed_ = false;              ///< the pacer waits for a moving picture to come onto the screen
  int moving_ = 0;                    ///< number of views that the motion moves
  long followed_ = 0;                 ///< the pacer's frame that this view last followed in
  std::optional<Effort> refinement_;  ///< the effort of the picture being refined; empty: none is
  double refinedFor_ = 0.0;           ///< ms
  bool compiled_ = false;             ///< programs were compiled meanwhile, so refinedFor_ says nothing about speed
  bool held_ = false;
  /// A prepared scene is about to be drawn. It is drawn before the next change, or a slider that is dragged would keep
  /// the views from drawing.
  bool isPreparedDue_ = false;
  bool startsDue_ = true;  ///< raysStarted() is to be reported
  QString verified_;       ///< see noteVerified()
  Lateness lateness_;
  bool isOld_ = false;   ///< the picture is of an earlier scene or camera
  bool awaits_ = false;  ///< see setAwaits()
  /// Where the history and the frozen openings stood when the view last showed what was asked for.
  int shownStep_ = 0;
  ViewLink::Frozen shownFrozen_;
  bool settled_ = false;  ///< the last picture shows the present scene at full quality
  QTimer rest_;           ///< fires a moment after the last change
  QTimer refining_;       ///< fires between slices of refinement

  QTimer hover_;  ///< fires a moment after the mouse has stopped

  QPointF pressed_, last_;
  bool dragging_ = false;
  /// The state before the last click, which a double click restores.
  struct BeforeClick {
    Focus focus;
    glm::dvec3 cursor;
  };
  std::optional<BeforeClick> beforeClick_;
};

}  // namespace fenestra::viewer
