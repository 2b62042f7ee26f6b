#include "viewer/panels/ReformatPanel.h"

#include <algorithm>
#include <functional>
#include <initializer_list>
#include <utility>

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>
#include <glm/gtc/constants.hpp>

#include "rendering/reformat/CentreLine.h"
#include "rendering/reformat/Straighten.h"
#include "rendering/volume/Threads.h"
#include "viewer/model/Document.h"
#include "viewer/model/PathCameras.h"
#include "viewer/model/PathMode.h"
#include "viewer/model/PathOpening.h"
#include "viewer/model/ViewOptions.h"
#include "viewer/panels/ReformatPicture.h"

namespace fenestra::viewer {
namespace {

constexpr double sectionReach = 2.0;   ///< mm that a path may lie beside its structure, as in `fenestra-cli reformat`
constexpr double mostPixels = 3000.0;  ///< a side; more than a screen shows

/// The labels that stand for the focus in the scene as it is drawn; empty for other kinds of focus.
std::vector<std::uint16_t> labelsInFocus(const Scene& scene) {
  const auto* focus = std::get_if<LabelFocus>(&scene.look.focus);
  return focus && scene.labels ? focus->labels : std::vector<std::uint16_t>();
}

/// Asks whether to go on at every 64th of the many times: a job's answer takes as long as some hundred voxels.
std::function<bool()> untilCancelled(const io::Progress& progress) {
  return [&progress, times = 0]() mutable { return ++times % 64 != 0 || progress(0.0, {}); };
}

QString decimal(double value, int digits) { return QLocale().toString(value, 'f', digits); }

QDoubleSpinBox* spin(double low, double high, double value, double step, const QString& unit) {
  auto* box = new QDoubleSpinBox;
  box->setRange(low, high);
  box->setDecimals(0);
  box->setSingleStep(step);
  box->setValue(value);
  box->setSuffix(unit);
  box->setKeyboardTracking(false);
  return box;
}

}  // namespace

ReformatPanel::ReformatPanel(const Parts& parts, QWidget* parent)
    : QWidget(parent),
      document_(parts.document),
      mode_(parts.mode),
      opening_(parts.opening),
      draw_(new QToolButton),
      follow_(new QPushButton(tr("Follow the f&ocus"))),
      delete_(new QPushButton(tr("De&lete"))),
      width_(spin(5.0, 500.0, 50.0, 5.0, tr(" mm"))),
      angle_(spin(-180.0, 180.0, 0.0, 15.0, tr("°"))),
      camerasFollow_(new QCheckBox(tr("Cameras follow"))),
      opensAlong_(new QCheckBox(tr("Open along the path"))),
      tubeRadius_(spin(PathOpening::least, PathOpening::most, opening_.radius(), 1.0, tr(" mm"))),
      straight_(new ReformatPicture(document_)),
      across_(new ReformatPicture(document_)),
      says_(new QLabel) {
  // Looks pressed while a path is drawn, which a push button of the style hardly does.
  draw_->setText(tr("Dra&w"));
  draw_->setObjectName(QStringLiteral("choice"));
  draw_->setCheckable(true);
  draw_->setFocusPolicy(Qt::StrongFocus);
  draw_->setToolTip(
      tr("Click points on the slices; Backspace takes the last away, Enter or a double click ends the path"));
  follow_->setToolTip(tr("Finds the centre line of the tubular structure in focus"));
  delete_->setToolTip(tr("Deletes the path"));
  width_->setToolTip(tr("Width of the pictures"));
  angle_->setToolTip(tr("Turns the straightened picture about the path"));
  angle_->setWrapping(true);
  camerasFollow_->setToolTip(
      tr("Both cameras keep the place on the path in the middle of their pictures as you move along it"));
  opensAlong_->setToolTip(tr("The view opens to a tube around the path, which goes along when the path changes"));
  tubeRadius_->setToolTip(tr("Radius of the tube that the view opens to"));
  connectCameras(parts.cameras, parts.options);
  straight_->setAccessibleName(tr("Straightened along the path"));
  across_->setAccessibleName(tr("Across the path"));
  says_->setWordWrap(true);
  says_->setTextFormat(Qt::PlainText);
  says_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  says_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  // The texts change with every place: their room must not, or the pictures would jump.
  says_->setMinimumHeight(6 * fontMetrics().lineSpacing());
  layOut();
  soon_.setSingleShot(true);
  soon_.setInterval(0);
  connectAll();
  say();
}

void ReformatPanel::layOut() {
  auto* buttons = new QHBoxLayout;
  for (QWidget* each : std::initializer_list<QWidget*>{draw_, follow_, delete_}) buttons->addWidget(each);
  buttons->addStretch();
  auto* form = new QFormLayout;
  form->addRow(tr("Width"), width_);
  form->addRow(tr("Turned by"), angle_);
  form->addRow(camerasFollow_);
  form->addRow(opensAlong_);
  form->addRow(tr("Radius"), tubeRadius_);
  auto* side = new QVBoxLayout;
  side->addWidget(across_, 2);
  side->addWidget(says_, 1);
  side->addLayout(form);
  auto* pictures = new QHBoxLayout;
  pictures->addWidget(straight_, 1);
  pictures->addLayout(side, 1);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(4, 4, 4, 4);
  column->addLayout(buttons);
  column->addLayout(pictures, 1);
}

void ReformatPanel::connectCameras(PathCameras& cameras, const ViewOptions& options) {
  connect(camerasFollow_, &QCheckBox::clicked, &cameras, &PathCameras::setFollows);
  const auto showFollows = [this, &options] { camerasFollow_->setChecked(options.followsPath()); };
  connect(&options, &ViewOptions::changed, camerasFollow_, showFollows);
  showFollows();
}

void ReformatPanel::connectOpening() {
  connect(opensAlong_, &QCheckBox::clicked, &opening_, &PathOpening::setOpen);
  connect(tubeRadius_, &QDoubleSpinBox::valueChanged, &opening_, &PathOpening::setRadius);
  const auto show = [this] {
    opensAlong_->setEnabled(mode_.hasPath());
    tubeRadius_->setEnabled(mode_.hasPath());
    opensAlong_->setChecked(opening_.isOpen());
    const QSignalBlocker quiet(tubeRadius_);
    tubeRadius_->setValue(opening_.radius());
  };
  connect(&mode_, &PathMode::changed, opensAlong_, show);
  connect(&document_, &Document::focusChanged, opensAlong_, show);
  show();
}

void ReformatPanel::connectAll() {
  connectOpening();
  connect(&soon_, &QTimer::timeout, this, &ReformatPanel::draw);
  connect(draw_, &QPushButton::clicked, this, [this] {
    mode_.toggle();
    say();
  });
  connect(follow_, &QPushButton::clicked, this, &ReformatPanel::followFocus);
  connect(delete_, &QPushButton::clicked, this, [this] { document_.setPath({}, tr("Delete the path")); });
  connect(width_, &QDoubleSpinBox::valueChanged, this, [this] { show(true); });
  connect(angle_, &QDoubleSpinBox::valueChanged, this, [this] { show(true); });
  connect(&mode_, &PathMode::changed, this, &ReformatPanel::say);
  connect(&mode_, &PathMode::moved, this, [this] { show(false); });
  connect(&document_, &Document::pathChanged, this, [this] {
    problem_.clear();
    show(true);
  });
  connect(&document_, &Document::volumeChanged, this, [this] {
    // At once: nothing of the study before may stay in sight.
    straight_->setPixels({});
    across_->setPixels({});
    forgetRegion();
    show(true);
  });
  connect(&document_, &Document::focusChanged, this, &ReformatPanel::followFocusChange);
  connect(&document_, &Document::labelsChanged, this, &ReformatPanel::forgetRegion);
  connect(&document_, &Document::removalsChanged, this, &ReformatPanel::forgetRegion);
  const auto step = [this](int steps) { mode_.setPlace(mode_.place() + steps * spacing()); };
  connect(straight_, &ReformatPicture::stepped, this, step);
  connect(across_, &ReformatPicture::stepped, this, step);
  connect(straight_, &ReformatPicture::chosen, &mode_, &PathMode::setPlace);
  connect(&job_, &LoadJob::failed, this, [this](const QString& message) {
    problem_ = message;
    say();
  });
  connect(&job_, &LoadJob::started, this, &ReformatPanel::say);
  connect(&job_, &LoadJob::ended, this, &ReformatPanel::say);
}

QString ReformatPanel::text() const { return says_->text(); }

void ReformatPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  show(true);
  if (!region_) readRegion();
}

void ReformatPanel::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  soon_.stop();
  job_.cancel();
  if (!opening_.isOpen()) region_.reset();  // else the focus no longer tells it
  section_.reset();
  straight_->setPixels({});
  across_->setPixels({});
}

void ReformatPanel::followFocusChange() {
  if (opening_.isOpen()) return say();
  forgetRegion();
}

void ReformatPanel::forgetRegion() {
  region_.reset();
  section_.reset();
  problem_.clear();
  job_.cancel();
  readRegion();
}

void ReformatPanel::readRegion() {
  say();
  if (!isVisible() || !mode_.hasPath() || opening_.isOpen()) return;
  const Scene scene = document_.scene();
  const std::vector<std::uint16_t> values = labelsInFocus(scene);
  if (values.empty()) return show(false);
  job_.start([this, values, labels = scene.labels](const io::Progress& progress) -> LoadJob::Show {
    const Interruptible work(untilCancelled(progress));
    auto region = std::make_shared<const reformat::VoxelRegion>(reformat::regionOf(*labels, values));
    return [this, region] {
      region_ = region;
      show(false);
    };
  });
}

void ReformatPanel::followFocus() {
  const Scene scene = document_.scene();
  const std::vector<std::uint16_t> values = labelsInFocus(scene);
  problem_.clear();
  if (opening_.isOpen()) {
    problem_ = tr("The tube around the path is in focus: untick Open along the path, and bring a vessel into focus.");
    return say();
  }
  if (values.empty()) {
    problem_ = tr("Bring a label or a region into focus first: a vessel, or another tube.");
    return say();
  }
  mode_.stop();
  job_.start([this, values, labels = scene.labels](const io::Progress& progress) -> LoadJob::Show {
    const Interruptible work(untilCancelled(progress));
    auto region = std::make_shared<const reformat::VoxelRegion>(reformat::regionOf(*labels, values));
    std::vector<glm::dvec3> points = reformat::centreLineOf(*region).points;
    return [this, region, points = std::move(points)] {
      region_ = region;
      if (points.size() > 1) return document_.setPath(points, tr("Path along the focus"));
      problem_ = tr("The structure in focus is no tube: it is hardly longer than thick. Draw a path instead.");
      say();
    };
  });
}

double ReformatPanel::spacing() const {
  if (!document_.hasVolume()) return 1.0;
  const glm::dvec3 voxel = document_.scene().volume->grid.spacing;
  return std::max(
      {std::min({voxel.x, voxel.y, voxel.z}), mode_.curve().length() / mostPixels, width_->value() / mostPixels});
}

void ReformatPanel::show(bool straight) {
  isStraightOld_ |= straight;
  if (isVisible()) soon_.start();
}

void ReformatPanel::draw() {
  if (!document_.hasVolume() || !mode_.hasPath()) {
    straight_->setPixels({});
    across_->setPixels({});
    section_.reset();
    return say();
  }
  if (!region_ && !job_.isRunning() && problem_.isEmpty() && !opening_.isOpen() &&
      !labelsInFocus(document_.scene()).empty())
    readRegion();
  if (std::exchange(isStraightOld_, false)) drawStraight();
  straight_->setLine(mode_.place() / spacing() + 0.5);
  drawAcross();
  say();
}

void ReformatPanel::drawStraight() {
  const double mm = spacing();
  reformat::StraightPicture picture = reformat::straightened(*document_.scene().volume, mode_.curve(), mm,
                                                             width_->value(), glm::radians(angle_->value()));
  straight_->setPixels({picture.width, picture.height, picture.spacing, std::move(picture.values)});
}

void ReformatPanel::drawAcross() {
  const double mm = spacing();
  const SliceGeometry geometry =
      reformat::crossSection(mode_.curve(), mode_.place(), mm, width_->value(), glm::radians(angle_->value()));
  across_->setPixels({geometry.width, geometry.height, mm, sliceValues(*document_.scene().volume, geometry, 0)});
  section_.reset();
  if (region_ && !region_->isEmpty())
    section_ = reformat::sectionOf(*region_, mode_.curve().place(mode_.place()), sectionReach);
}

void ReformatPanel::say() {
  const bool hasVolume = document_.hasVolume(), works = job_.isRunning();
  draw_->setEnabled(hasVolume);
  draw_->setChecked(mode_.isDrawing());
  follow_->setEnabled(hasVolume && !works);
  delete_->setEnabled(mode_.hasPath());
  QStringList lines;
  if (mode_.isDrawing()) {
    lines << tr("%n points; Enter ends the path", nullptr, static_cast<int>(mode_.draft().size()));
  } else if (!problem_.isEmpty()) {
    lines << problem_;
  } else if (!mode_.hasPath()) {
    lines << (works ? tr("Finding the centre line…")
                    : tr("Draw a path on the slices, or follow the vessel that is in focus."));
  } else {
    lines << tr("At %1 of %2 mm").arg(decimal(mode_.place(), 1), decimal(mode_.curve().length(), 1));
    if (section_)
      lines << tr("Area %1 mm²").arg(decimal(section_->area, 1))
            << tr("Radius %1 mm").arg(decimal(section_->radius(), 2));
    else if (works)
      lines << tr("Reading the structure in focus…");
    else
      lines << tr("No structure in focus here: no area");
  }
  says_->setText(lines.join(QLatin1Char('\n')));
}

}  // namespace fenestra::viewer
