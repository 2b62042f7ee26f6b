#pragma once
// Places the two cameras for the focus: has it measured, chooses, flies there, and lets C2 follow C1. Where the cameras
// are is ViewLink's; this holds what was measured and how to choose.

#include <memory>
#include <optional>
#include <vector>

#include <QImage>
#include <QObject>
#include <QSize>
#include <QString>
#include <QTimer>

#include "rendering/scene/Scene.h"
#include "rendering/viewpoints/Choice.h"
#include "viewer/model/ViewLink.h"

namespace fenestra::viewer {

class Document;

struct PlacementSettings {
  placement::Sampling sampling;
  placement::Options options;
  bool joint = false;     ///< both cameras at once, for what the pair sees together
  bool follow = true;     ///< C2 goes to the best of its region when C1 is turned
  bool automatic = true;  ///< place when a focus is chosen
  bool operator==(const PlacementSettings&) const = default;
};

/// What placing needs of OpenGL. Every call may throw what the renderer throws.
class PlacementBackend {
 public:
  virtual ~PlacementBackend() = default;
  /// Placer's begin(); advance() measures one slice, of a few hundredths of a second where that is possible.
  virtual void begin(const Scene& scene, const placement::Sampling& sampling, const placement::Options& options) = 0;
  virtual bool advance() = 0;
  virtual double progress() const = 0;
  virtual const placement::Measured& measured() const = 0;
  /// A small picture; `size` in pixels.
  virtual QImage picture(const Scene& scene, const Camera& camera, QSize size) = 0;
};

class PlacementController : public QObject {
  Q_OBJECT
 public:
  PlacementController(Document& document, ViewLink& cameras, QObject* parent = nullptr);
  ~PlacementController() override;

  /// Without one nothing can be placed.
  void setBackend(std::unique_ptr<PlacementBackend> backend);

  const PlacementSettings& settings() const { return settings_; }
  /// Another weight, region or search takes effect at once, from what is measured; another number of candidates is
  /// measured first.
  void setSettings(const PlacementSettings& settings);

  bool hasBackend() const { return backend_ != nullptr; }
  /// There is OpenGL, a volume and a focus.
  bool canPlace() const;
  /// Measures the focus, unless that is done, and flies both cameras to the answer.
  void place() { measure(true); }
  /// The same where nobody asked for it: when a focus was chosen, or a study opened that wants it. It is not announced
  /// by leaving().
  void placeAutomatically() { measure(false); }
  void cancel();
  bool isMeasuring() const { return slice_.isActive(); }
  /// Measuring, or about to.
  bool isBusy() const { return slice_.isActive() || chosen_.isActive(); }
  double progress() const;

  /// C1 goes to look from there (a unit vector towards the eye); C2 follows, or turns along where the views are linked.
  void goTo(glm::dvec3 direction);

  /// Of the present focus; null until measured.
  const placement::Measured* measured() const;
  /// What cannot be, or why no answer stands out; empty when all is well.
  const QString& note() const { return note_; }
  /// Share of the focus's surface that the two cameras see, as the candidates nearest to them do; empty until measured.
  std::optional<double> share() const;
  /// The best candidates that differ by 30° at least, best first.
  std::vector<std::size_t> best(std::size_t count) const;
  /// What a candidate's camera sees.
  QImage picture(std::size_t candidate, QSize size);

 Q_SIGNALS:
  /// Settings, what is measured, the answer or the note.
  void changed();
  void progressed(double fraction);
  /// Candidates were rendered.
  void measuredFocus();
  /// The cameras are about to fly because the user asked for it, by place() or goTo().
  void leaving();

 private:
  /// What measurements belong to.
  struct Subject {
    std::shared_ptr<const Volume> volume;
    std::shared_ptr<const LabelMap> labels;
    Focus focus;
    bool operator==(const Subject&) const = default;
  };
  Subject subject() const;
  void focusChanged();
  void measure(bool asked);
  void slice();
  void choose(bool framed, bool asked);
  void follow();
  /// C2 stays when it is told no direction.
  void fly(glm::dvec3 c1, std::optional<glm::dvec3> c2, bool framed, bool asked);
  /// From there, with all that the context shows in the picture.
  Camera framing(glm::dvec3 direction);
  void fail(const std::exception& error);

  Document& document_;
  ViewLink& cameras_;
  std::unique_ptr<PlacementBackend> backend_;
  PlacementSettings settings_;
  placement::Measured measured_;
  std::optional<Subject> measuredSubject_;
  std::shared_ptr<const Volume> volume_;  ///< whose focus was last seen
  std::optional<Grid> visible_;           ///< what a camera frames
  QString note_;
  QTimer chosen_;  ///< runs out a moment after the focus was chosen
  QTimer slice_;
  bool asked_ = false;  ///< what is being measured is for place(), not for a focus just chosen
};

}  // namespace fenestra::viewer
