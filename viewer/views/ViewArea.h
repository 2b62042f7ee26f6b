#pragma once
// The five views: C1 and C2 side by side over axial, sagittal and coronal. One of them can take the whole area.

#include <memory>
#include <string>
#include <vector>

#include <QSplitter>
#include <QWidget>

#include "io/session/Session.h"
#include "rendering/gpu/Schedule.h"
#include "viewer/model/OpeningEdge.h"
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
  /// The view that had the keyboard's focus last; C1 (without OpenGL, axial) before one had it.
  QWidget* activeView() const { return active_; }
  /// The schedule that the shaders of the 3-D views follow; empty without OpenGL.
  std::optional<Schedule> schedule() const;
  /// Compiles what 3-D views will need, that for a focus of the expected kind first.
  void warmUp(const Focus& expected);
  /// Every visible view shows the scene at full quality.
  bool isSettled() const;
  /// A 3-D view does not show what was asked for since a moment, because its picture is being prepared.
  bool isPreparing() const;
  /// Takes back what was asked for since the views last showed it.
  void takeBackWhatIsAwaited();
  /// All views show what was before, until something else than their pictures is made.
  void setAwaits(bool awaits);

  /// Gives the whole area to one view; when one has it already, shows all views again.
  void toggleMaximised(QWidget* view);
  bool isMaximised() const { return maximised_ != nullptr; }
  void showAll();

  /// How the 3-D views are drawn when nothing moves.
  Effort atRest() const { return pacer_->atRest(); }
  void setAtRest(Quality quality, std::optional<double> maxError);
  /// To aim at while something moves.
  void setPicturesPerSecond(int count) { pacer_->setBudget(1000.0 / count); }
  const FramePacer& pacer() const { return *pacer_; }

  /// Write and restore the pictures' sizes, their sampling and the layout.
  void describe(io::Session& session) const;
  void restore(const io::Session& session);

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
  void failed(const QString& problem);
  /// See VolumeView.
  void reduced(const QString& notice);
  void atRestChanged();
  /// See Lateness, of any 3-D view.
  void lateChanged();
  /// A 3-D view has a new picture on screen.
  void drawn();

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

  std::shared_ptr<FramePacer> pacer_;
  OpeningEdge opening_;
  std::shared_ptr<ScenePreparation> preparation_;  ///< null without OpenGL
  QSplitter *rows_, *upper_, *lower_;
  std::vector<VolumeView*> volumes_;
  std::vector<SliceView*> slices_;
  QWidget* maximised_ = nullptr;
  QWidget* active_ = nullptr;
};

}  // namespace fenestra::viewer
