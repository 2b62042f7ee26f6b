#include "viewer/model/PlacementController.h"

#include <algorithm>
#include <cmath>

#include <QtConcurrentRun>

#include "rendering/scene/VisibleFraming.h"
#include "rendering/segmentation/PickedStructure.h"
#include "rendering/viewpoints/LiveSync.h"
#include "rendering/viewpoints/Sphere.h"
#include "viewer/model/Document.h"
#include "viewer/model/Translation.h"

namespace fenestra::viewer {
namespace {

/// Delay before a chosen focus is measured: the second half of a double click may take it back, and dragging a range
/// chooses many.
constexpr int settleMilliseconds = 200;
/// Rest of C1 after which C2 follows it: within a drag the best complement changes from one side to another.
constexpr int followMilliseconds = 150;
/// Least angle between two viewpoints that are offered as different.
constexpr double apart = 30.0;  // degrees

std::size_t nearest(const std::vector<placement::Candidate>& candidates, glm::dvec3 direction) {
  const auto farther = [&](const placement::Candidate& a, const placement::Candidate& b) {
    return glm::dot(a.direction, direction) < glm::dot(b.direction, direction);
  };
  return static_cast<std::size_t>(std::max_element(candidates.begin(), candidates.end(), farther) - candidates.begin());
}

}  // namespace

PlacementController::PlacementController(Document& document, ViewLink& cameras, QObject* parent)
    : QObject(parent), document_(document), cameras_(cameras) {
  chosen_.setSingleShot(true);
  chosen_.setInterval(settleMilliseconds);
  connect(&chosen_, &QTimer::timeout, this, &PlacementController::placeAutomatically);
  connect(&slice_, &QTimer::timeout, this, &PlacementController::slice);
  connect(&document, &Document::focusChanged, this, &PlacementController::focusChanged);
  connect(&document, &Document::volumeChanged, this, [this] {
    visible_.reset();
    stopRating();  // a point of the study before
  });
  connect(&document, &Document::transferFunctionChanged, this, [this] { visible_.reset(); });
  picked_.setSingleShot(true);
  picked_.setInterval(settleMilliseconds);
  connect(&picked_, &QTimer::timeout, this, &PlacementController::rate);
  connect(&rating_, &QFutureWatcherBase::finished, this, &PlacementController::showRated);
  turned_.setSingleShot(true);
  turned_.setInterval(followMilliseconds);
  connect(&turned_, &QTimer::timeout, this, [this] {
    follow();
    Q_EMIT changed();
  });
  connect(&cameras, &ViewLink::turned, this, [this](int view) {
    if (view != 0 || !settings_.follow || !measured()) return;
    const bool waited = turned_.isActive();
    turned_.start();
    if (!waited) Q_EMIT changed();
  });
}

PlacementController::~PlacementController() { stopRating(); }

void PlacementController::setBackend(std::unique_ptr<PlacementBackend> backend) {
  backend_ = std::move(backend);
  Q_EMIT changed();
}

bool PlacementController::canPlace() const {
  return backend_ && document_.hasVolume() && !std::holds_alternative<std::monostate>(document_.scene().look.focus);
}

PlacementController::Subject PlacementController::subject() const {
  const Scene& scene = document_.scene();
  return {shownVolume(scene), scene.labels, scene.look.focus};
}

const placement::Measured* PlacementController::measured() const {
  return measuredSubject_ == subject() ? &measured_ : nullptr;
}

void PlacementController::setSettings(const PlacementSettings& settings) {
  if (settings == settings_) return;
  const PlacementSettings before = std::exchange(settings_, settings);
  const bool needsEndFaces = settings.options.weights.endFace != 0.0 && before.options.weights.endFace == 0.0;
  if ((settings.sampling != before.sampling || needsEndFaces) && (measured() || isMeasuring()))
    placeAutomatically();
  else if (measured() && (settings.options != before.options || settings.joint != before.joint))
    choose(false, false);
  else if (measured() && settings.follow && !before.follow)
    follow();
  Q_EMIT changed();
}

void PlacementController::focusChanged() {
  const bool wasBusy = isBusy();
  slice_.stop();
  chosen_.stop();
  turned_.stop();
  note_.clear();
  // A new study brings its own cameras with its focus.
  const bool arrived = volume_ != document_.scene().volume;
  volume_ = document_.scene().volume;
  // The cameras go to a new region once it shows. Its tolerance and further seeds refine what they look at already.
  const bool waits = document_.awaitsGrowth() || document_.asksToOpen();
  const RegionFocus* region = document_.region();
  const bool refined = region && placedClick_ == region->origin() && !wasBusy;
  if (!waits) placedClick_ = region ? region->origin() : std::nullopt;
  if (!arrived && !waits && !refined && settings_.automatic && !settings_.byPick && canPlace() && !measured())
    chosen_.start();
  Q_EMIT changed();
}

void PlacementController::measure(bool asked) {
  cancel();
  asked_ = asked;
  moves_ = true;
  if (!canPlace()) return;
  note_.clear();
  try {
    backend_->begin(document_.scene(), settings_.sampling, settings_.options);
    slice_.start(0);
  } catch (const std::exception& error) {
    fail(error);
  }
  Q_EMIT changed();
}

void PlacementController::measureAlone() {
  if (measured() || document_.awaitsGrowth() || document_.asksToOpen()) return;
  measure(false);
  moves_ = false;
}

void PlacementController::cancel() {
  // Views wait for cameras that are to be placed, also while that is only due.
  const bool waited = chosen_.isActive() || turned_.isActive() || slice_.isActive();
  chosen_.stop();
  turned_.stop();
  slice_.stop();
  if (waited) Q_EMIT changed();
}

double PlacementController::progress() const { return backend_ ? backend_->progress() : 0.0; }

void PlacementController::slice() {
  try {
    if (!backend_->advance()) {
      Q_EMIT progressed(backend_->progress());
      return;
    }
  } catch (const std::exception& error) {
    slice_.stop();
    fail(error);
    Q_EMIT changed();
    return;
  }
  slice_.stop();
  measured_ = backend_->measured();
  measuredSubject_ = subject();
  Q_EMIT measuredFocus();
  if (moves_) choose(true, asked_);
  Q_EMIT changed();
}

void PlacementController::fail(const std::exception& error) {
  note_ = tr("The focus cannot be measured: %1").arg(QString::fromUtf8(error.what()));
}

void PlacementController::choose(bool framed, bool asked) {
  const placement::Placement answer = placement::choose(measured_, settings_.options, settings_.joint);
  note_ = QString::fromStdString(answer.note);
  if (!note_.isEmpty()) note_[0] = note_[0].toUpper();
  if (!answer.c1) return;
  const auto directionAt = [this](std::size_t candidate) { return measured_.candidates[candidate].direction; };
  fly(directionAt(*answer.c1), answer.c2 ? std::optional(directionAt(*answer.c2)) : std::nullopt, framed, asked);
}

void PlacementController::follow() {
  if (!settings_.follow || !measured() || cameras_.isFlying()) return;
  const auto dual = placement::chooseDual(measured_, directionOf(cameras_.camera(0)), settings_.options);
  if (!dual.c2) return;
  const Camera c2 = facing(cameras_.camera(1), measured_.candidates[*dual.c2].direction);
  cameras_.flyTo({cameras_.camera(0), c2}, cameras_.pose().home);
}

void PlacementController::goTo(glm::dvec3 direction) {
  if (!document_.hasVolume()) return;
  std::optional<glm::dvec3> c2;
  const auto dual = settings_.follow && measured() ? placement::chooseDual(measured_, direction, settings_.options)
                                                   : placement::Placement{};
  if (dual.c2) {
    c2 = measured_.candidates[*dual.c2].direction;
  } else if (cameras_.isLinked()) {
    const Camera::Axes before = cameras_.camera(0).axes(), after = facing(cameras_.camera(0), direction).axes();
    const glm::dmat3 from(before.right, before.up, -before.forward), to(after.right, after.up, -after.forward);
    c2 = to * glm::transpose(from) * directionOf(cameras_.camera(1));
  }
  fly(direction, c2, false, true);
}

void PlacementController::fly(glm::dvec3 c1, std::optional<glm::dvec3> c2, bool framed, bool asked) {
  turned_.stop();  // both cameras have a new aim
  const Camera &first = cameras_.camera(0), &second = cameras_.camera(1);
  const ViewLink::Pair home{framing(c1), framing(c2.value_or(directionOf(second)))};
  const ViewLink::Pair there{framed ? home[0] : facing(first, c1), !c2      ? second
                                                                   : framed ? home[1]
                                                                            : facing(second, *c2)};
  if (asked && there != ViewLink::Pair{first, second}) Q_EMIT leaving();
  cameras_.flyTo(there, home);
}

Camera PlacementController::framing(glm::dvec3 direction) {
  const ShownVolume shown = shownVolume(document_.scene());
  if (!visible_ || visibleOf_ != shown) visible_ = visibleFraming(shown, document_.scene().look.context.shifted());
  visibleOf_ = shown;
  return Camera::fromDirection(direction, *visible_, cameras_.projection());
}

void PlacementController::pick(glm::dvec3 world) {
  if (!settings_.byPick || !document_.hasVolume()) return;
  stopRating();
  pick_ = world;
  picked_.start();
  Q_EMIT changed();
}

void PlacementController::forgetPick() {
  if (!isRating()) return;
  stopRating();
  Q_EMIT changed();
}

void PlacementController::stopRating() {
  picked_.stop();
  if (goesOn_) *goesOn_ = false;
  goesOn_.reset();
  rating_.setFuture({});
}

void PlacementController::rate() {
  if (!document_.hasVolume()) return;
  goesOn_ = std::make_shared<std::atomic<bool>>(true);
  const auto nside = placement::sideOf(settings_.sampling.count);
  const glm::dvec3 last = directionOf(cameras_.pose().cameras[0]);
  rating_.setFuture(QtConcurrent::run([pick = pick_, scene = document_.scene(), settings = settings_, last,
                                       nside = nside.value_or(4), goesOn = goesOn_] {
    PickAnswer answer{.pick = pick, .volume = scene.volume, .c1 = {}, .c2 = {}, .problem = {}};
    try {
      const segmentation::PickedStructure picked =
          segmentation::pickedStructure(scene, pick, [&](double) { return goesOn->load(); });
      answer.problem = picked.problem;
      if (!picked.labels || !*goesOn) return answer;
      const placement::RatedViews views = placement::rateViews(scene, {picked.labels, picked.values}, pick, nside,
                                                               settings.liveSync, settings.options, last);
      if (views.c1) answer.c1 = views.directions[*views.c1];
      if (views.c2) answer.c2 = views.directions[*views.c2];
    } catch (const std::exception& error) {
      answer.problem = error.what();
    }
    return answer;
  }));
}

void PlacementController::showRated() {
  goesOn_.reset();
  if (rating_.future().resultCount() > 0) show(rating_.result());
  Q_EMIT changed();
}

void PlacementController::show(const PickAnswer& answer) {
  if (answer.volume != document_.scene().volume) return;
  note_ = answer.problem.empty() ? QString() : tr("No view of that point: %1").arg(translated(answer.problem));
  if (answer.c1) {
    turned_.stop();
    const ViewLink::Pair home{framing(*answer.c1), framing(answer.c2.value_or(directionOf(cameras_.camera(1))))};
    const auto at = [&](glm::dvec3 direction) {
      return placement::cameraAt(answer.pick, direction, *visible_, cameras_.projection());
    };
    const ViewLink::Pair there{at(*answer.c1), answer.c2 ? at(*answer.c2) : cameras_.camera(1)};
    if (there != cameras_.pose().cameras) Q_EMIT leaving();
    cameras_.flyTo(there, home);
  }
}

std::optional<double> PlacementController::share() const {
  if (!measured() || measured_.surfacePoints == 0) return std::nullopt;
  const auto seen = [this](int view) -> const placement::Candidate& {
    return measured_.candidates[nearest(measured_.candidates, directionOf(cameras_.camera(view)))];
  };
  return placement::seenShare(seen(0), seen(1), measured_.surfacePoints);
}

std::optional<PlacementController::LabelShare> PlacementController::share(std::uint16_t label) const {
  if (!measured()) return std::nullopt;
  const auto seen = [this](int view) -> const std::vector<std::uint64_t>& {
    return measured_.candidates[nearest(measured_.candidates, directionOf(cameras_.camera(view)))].seen;
  };
  const std::vector<std::uint64_t>&first = seen(0), &second = seen(1);
  std::size_t points = 0, c1 = 0, c2 = 0, both = 0;
  for (std::size_t i = 0; i < measured_.pointLabels.size(); ++i) {
    if (measured_.pointLabels[i] != label) continue;
    const bool inFirst = first[i / 64] >> (i % 64) & 1u, inSecond = second[i / 64] >> (i % 64) & 1u;
    ++points;
    c1 += inFirst;
    c2 += inSecond;
    both += inFirst || inSecond;
  }
  if (points == 0) return std::nullopt;
  const auto of = [&](std::size_t count) { return static_cast<double>(count) / static_cast<double>(points); };
  return LabelShare{of(c1), of(c2), of(both)};
}

std::vector<std::size_t> PlacementController::best(std::size_t count) const {
  std::vector<std::size_t> kept;
  if (!measured()) return kept;
  const placement::Options& options = settings_.options;
  const std::vector<bool> admitted = placement::admitted(measured_.candidates, options);
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < measured_.spread; ++i)
    if (admitted[i]) order.push_back(i);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return placement::worth(measured_.candidates[a].descriptors, options) >
           placement::worth(measured_.candidates[b].descriptors, options);
  });
  const double nearestCosine = std::cos(glm::radians(apart));
  for (const std::size_t candidate : order) {
    if (kept.size() == count) break;
    const bool distinct = std::all_of(kept.begin(), kept.end(), [&](std::size_t other) {
      return glm::dot(measured_.candidates[other].direction, measured_.candidates[candidate].direction) <=
             nearestCosine;
    });
    if (distinct) kept.push_back(candidate);
  }
  return kept;
}

QImage PlacementController::picture(std::size_t candidate, QSize size) {
  return backend_->picture(document_.scene(), framing(measured_.candidates.at(candidate).direction), size);
}

}  // namespace fenestra::viewer
