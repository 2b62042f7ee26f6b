#pragma once
// The five views, C1, C2, axial, sagittal and coronal, laid out as an Arrangement says. One of them can take the whole
// area. A view that is not shown draws nothing.

#include <map>
#include <memory>
#include <string>
#include <vector>

#include <QSplitter>
#include <QWidget>

#include "io/session/Session.h"
#include "rendering/gpu/Schedule.h"
#include "viewer/model/OpeningEdge.h"
#include "viewer/views/Arrangement.h"
#include "viewer/views/ChooseSchedule.h"
#include "viewer/views/GlSupport.h"
#include "viewer/views/SliceView.h"
#include "viewer/views/VolumeView.h"

namespace fenestra::viewer {

class ScenePreparation;

class ViewArea : public QWidget {
  Q_OBJECT
 public:
  /// Without OpenGL a text in place of the 3-D views says why; the slices work all the same.
  /// `workspace` outlives this.
  ViewArea(Workspace& workspace, const GlSupport& gl, const Effort& atRest, const ChooseSchedule& chooseSchedule,
           QWidget* parent = nullptr);

  const std::vector<VolumeView*>& volumeViews() const { return volumes_; }  ///< empty without OpenGL
  const std::vector<SliceView*>& sliceViews() const { return slices_; }     ///< axial, sagittal, coronal
  /// The view in sight that had the keyboard's focus last; before one had it, C1 or the first that shows.
  QWidget* activeView() const { return active_; }
  /// The schedule that the shaders of the 3-D views follow; empty without OpenGL.
  std::optional<Schedule> schedule() const;
  /// Compiles what 3-D views will need, that for a focus of the expected kind first; see ScenePreparation.
  void warmUp(const Focus& expected, bool isRead);
  /// Every visible view shows the scene at full quality.
  bool isSettled() const;
  /// Frees what the device holds of a study that was closed.
  void letGo();
  /// A 3-D view does not show what was asked for since a moment, because its picture is being prepared.
  bool isPreparing() const;
  /// Takes back what was asked for since the views last showed it.
  void takeBackWhatIsAwaited();
  /// All views show what was before, until something else than their pictures is made.
  void setAwaits(bool awaits);

  /// Gives the whole area to one view; when one has it already, shows all views again.
  void toggleMaximised(QWidget* view);
  bool isMaximised() const { return maximised_ != nullptr; }
  /// Ends that: all views of the arrangement show.
  void showAll();
  /// The next view, or with -1 the one before: alone in place of the one that is maximised, and otherwise with the
  /// keyboard's focus among those that show.
  void showNeighbour(int step);

  const Arrangement& arrangement() const { return *arrangement_; }
  /// Shows an arrangement of arrangements(), with the sizes that it had last.
  void arrange(const Arrangement& arrangement);

  /// How the 3-D views are drawn when nothing moves.
  Effort atRest() const { return pacer_->atRest(); }
  void setAtRest(Quality quality, std::optional<double> maxError);
  /// To aim at while something moves.
  void setPicturesPerSecond(int count) { pacer_->setBudget(1000.0 / count); }
  const FramePacer& pacer() const { return *pacer_; }

  /// Write and restore the pictures' sizes, their sampling and the layout.
  void describe(io::Session& session) const;
  void restore(const io::Session& session);

  /// The arrangement and its sizes. Layouts of before have no arrangement, and are of the first; what cannot be read
  /// leaves the sizes as they are.
  QByteArray saveLayout() const;
  void restoreLayout(const QByteArray& layout);

 Q_SIGNALS:
  void pointed(glm::dvec3 world);
  void left();
  /// By a right click in a 3-D view.
  void menuRequested(glm::dvec3 world, QPoint globalPosition);
  void sliceMenuRequested(SlicePlane plane, glm::dvec3 world, QPoint globalPosition);
  void measureMenuRequested(std::size_t measure, QPoint globalPosition);
  /// See SliceView.
  void picked(glm::dvec3 world);
  void pickTakenBack();
  /// A slice was zoomed by hand.
  void scaled(SliceView* view);
  void failed(const QString& problem);
  /// See VolumeView.
  void reduced(const QString& notice);
  void atRestChanged();
  /// See Lateness, of any 3-D view.
  void lateChanged();
  /// A 3-D view has a new picture on screen.
  void drawn();
  /// Another arrangement shows, or one view alone, or all again.
  void arranged();

 private:
  void addVolumeViews(Workspace& workspace, const GlSupport& gl, const ChooseSchedule& chooseSchedule);
  /// Says in place of the 3-D views why there are none.
  void addReason(const GlSupport& gl);
  void addSliceViews(Workspace& workspace);
  /// Passes on the signals that all kinds of views have.
  template <class View>
  void connectView(View* view);
  /// Every view with its name in a session.
  std::vector<std::pair<std::string, QWidget*>> namedViews() const;
  /// Moves the views to where the arrangement has them; those that it has not come last, hidden.
  void place(const Arrangement& arrangement);
  /// Shows the maximised view alone, or all of the arrangement.
  void showViews();

  std::shared_ptr<FramePacer> pacer_;
  OpeningEdge opening_;
  std::shared_ptr<ScenePreparation> preparation_;  ///< null without OpenGL
  QSplitter *rows_, *upper_, *lower_;
  std::vector<VolumeView*> volumes_;
  std::vector<SliceView*> slices_;
  QWidget* reason_ = nullptr;  ///< in place of C1 where there is no OpenGL
  const Arrangement* arrangement_ = nullptr;
  std::map<std::string, QByteArray> layouts_;  ///< of the arrangements that were shown before, by id
  QWidget* maximised_ = nullptr;
  QWidget* active_ = nullptr;
};

}  // namespace fenestra::viewer
