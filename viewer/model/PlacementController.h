#pragma once
// Places the two cameras for the focus: measures candidates through a PlacementBackend, chooses two, flies the cameras
// there, and lets C2 follow C1. ViewLink holds the cameras; this holds the measurements and how to choose.

#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <QFutureWatcher>
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
  bool joint = placement::jointByDefault;  ///< choose both cameras at once, by what the pair sees together
  bool follow = true;                      ///< C2 goes to the best of its region when C1 is turned
  bool automatic = true;                   ///< place when a focus is chosen, unless byPick
  bool byPick = false;                     ///< a click on a slice places the cameras for what is there, by LiveSync
  placement::LiveSyncOptions liveSync;
  bool operator==(const PlacementSettings&) const = default;
};

/// The part of placing that needs OpenGL. Every call may throw std::runtime_error with a message for the user.
class PlacementBackend {
 public:
  virtual ~PlacementBackend() = default;
  /// Placer's begin(). advance() measures one slice, of a few hundredths of a second where possible; true when all is
  /// measured.
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

  /// Without a backend, cameras cannot be placed.
  void setBackend(std::unique_ptr<PlacementBackend> backend);

  const PlacementSettings& settings() const { return settings_; }
  /// Another weight, region or search takes effect at once, from the present measurements. Another number of candidates
  /// is measured first.
  void setSettings(const PlacementSettings& settings);

  bool hasBackend() const { return backend_ != nullptr; }
  /// There are a backend, a volume and a focus.
  bool canPlace() const;
  /// Measures the focus, unless it is measured already, and flies both cameras to the answer.
  void place() { measure(true); }
  /// As place(), but not asked for by the user: after a focus was chosen, or because a study says so. Does not emit
  /// leaving().
  void placeAutomatically() { measure(false); }
  /// Measures the focus without moving a camera.
  void measureAlone();
  void cancel();
  bool isMeasuring() const { return slice_.isActive(); }
  /// Measuring, or about to measure.
  bool isBusy() const { return slice_.isActive() || chosen_.isActive() || turned_.isActive() || isRating(); }
  double progress() const;

  /// Turns C1 to look from a direction (a unit vector towards the eye). C2 follows, or turns along with a linked C1.
  void goTo(glm::dvec3 direction);

  /// A click on a slice at a world position. With `byPick`, both cameras fly to the best views of the structure there,
  /// which is rated on another thread after a moment; of several clicks the last counts. Where that fails, note() says
  /// why and no camera moves. Needs no backend.
  void pick(glm::dvec3 world);
  /// Takes the last pick back: its click was the first half of a double click.
  void forgetPick();
  bool isRating() const { return picked_.isActive() || goesOn_; }

  /// The measurements of the present focus; null until it is measured.
  const placement::Measured* measured() const;
  /// Why the cameras cannot be placed, or why no answer stands out; empty otherwise.
  const QString& note() const { return note_; }
  /// Share of the focus's surface that the two cameras see, taken from the candidates nearest to them; empty until
  /// measured.
  std::optional<double> share() const;
  /// The shares of one focus label's surface that C1, C2 and the two together see.
  struct LabelShare {
    double c1 = 0.0, c2 = 0.0, both = 0.0;
  };
  std::optional<LabelShare> share(std::uint16_t label) const;
  /// The best candidates at least 30° apart, best first.
  std::vector<std::size_t> best(std::size_t count) const;
  /// The picture of a candidate's camera.
  QImage picture(std::size_t candidate, QSize size);

 Q_SIGNALS:
  /// The settings, the measurements, the answer or the note have changed.
  void changed();
  void progressed(double fraction);
  /// Candidates were rendered.
  void measuredFocus();
  /// The cameras are about to fly because the user asked for it, by place() or goTo().
  void leaving();

 private:
  /// The data that the measurements are of.
  struct Subject {
    ShownVolume volume;
    std::shared_ptr<const LabelMap> labels;
    Focus focus;
    bool operator==(const Subject&) const = default;
  };
  Subject subject() const;
  void focusChanged();
  void measure(bool asked);
  void slice();
  void choose(bool framed, bool asked);
  /// Flies C2 to the best complement of C1's direction.
  void follow();
  /// Without a direction C2 stays.
  void fly(glm::dvec3 c1, std::optional<glm::dvec3> c2, bool framed, bool asked);
  /// The camera that looks from a direction and has all visible voxels in its picture.
  Camera framing(glm::dvec3 direction);
  void fail(const std::exception& error);

  /// The answer to a pick: two directions, or why there are none.
  struct PickAnswer {
    glm::dvec3 pick{0.0};
    std::shared_ptr<const Volume> volume;  ///< the volume that was picked in
    std::optional<glm::dvec3> c1, c2;
    std::string problem;
  };
  void rate();
  void stopRating();
  void showRated();
  void show(const PickAnswer& answer);

  Document& document_;
  ViewLink& cameras_;
  std::unique_ptr<PlacementBackend> backend_;
  PlacementSettings settings_;
  placement::Measured measured_;
  std::optional<Subject> measuredSubject_;
  std::shared_ptr<const Volume> volume_;   ///< the volume at the last change of focus
  std::optional<Framing> visible_;         ///< the visible voxels, which a camera frames
  std::optional<glm::dvec3> placedClick_;  ///< where the last grown region in focus began
  ShownVolume visibleOf_;
  QString note_;
  QTimer chosen_;  ///< fires a moment after a focus was chosen
  QTimer turned_;  ///< fires a moment after C1 was last turned
  QTimer slice_;
  QTimer picked_;  ///< fires a moment after a pick
  glm::dvec3 pick_{0.0};
  QFutureWatcher<PickAnswer> rating_;
  std::shared_ptr<std::atomic<bool>> goesOn_;  ///< false stops the rating; null once its answer is shown
  bool moves_ = true;                          ///< the cameras fly to the answer of the measurement under way
  bool asked_ = false;                         ///< the measurement under way was asked for by place()
};

}  // namespace fenestra::viewer
