#include "viewer/bars/StatusBar.h"

#include <cmath>

#include <QLabel>
#include <QLayout>

#include "viewer/model/Document.h"
#include "viewer/model/LabelName.h"
#include "viewer/model/MeasureText.h"
#include "viewer/model/NumberText.h"
#include "viewer/model/ViewOptions.h"
#include "viewer/views/GlSupport.h"
#include "viewer/views/ViewArea.h"

namespace fenestra::viewer {
namespace {

/// Milliseconds that a text stays, so that it can be read. For a new text Qt also paints and uploads widgets, which
/// slows moving pictures on software OpenGL.
constexpr qint64 readable = 500;

/// "L 12.3  P 45.0  S 101.2 mm": the patient's own directions instead of signs.
QString patientCoordinates(glm::dvec3 world) {
  const auto one = [](double value, char positive, char negative) {
    return QStringLiteral("%1 %L2").arg(QLatin1Char(value < 0.0 ? negative : positive)).arg(std::abs(value), 0, 'f', 1);
  };
  return QStringLiteral("%1   %2   %3 mm").arg(one(world.x, 'L', 'R'), one(world.y, 'P', 'A'), one(world.z, 'S', 'I'));
}

}  // namespace

StatusBar::StatusBar(const Document& document, const ViewOptions& options, const ViewArea& views, const GlSupport& gl,
                     QWidget* parent)
    : QStatusBar(parent), document_(document), views_(views), pointer_(new QLabel), frame_(new QLabel) {
  pointer_->setTextFormat(Qt::PlainText);
  addWidget(pointer_, 1);
  if (gl.software) {
    auto* software = new QLabel(tr("Software OpenGL"));
    software->setToolTip(tr("Pictures are smaller while something moves: %1 draws them").arg(gl.renderer));
    addPermanentWidget(software);
  } else if (!gl.available) {
    addPermanentWidget(new QLabel(tr("No OpenGL: slices only")));
  }
  frame_->setToolTip(tr("Time until the last picture was on screen, and its sampling"));
  addPermanentWidget(frame_);
  auto* convention = new QLabel;
  addPermanentWidget(convention);
  const auto nameConvention = [convention, &options] {
    convention->setText(options.isNeurological() ? tr("Neurological convention") : tr("Radiological convention"));
  };
  connect(&options, &ViewOptions::changed, convention, nameConvention);
  nameConvention();

  // A long message has the room of what the slices say, too, and of one that is longer still the tooltip has the end.
  connect(this, &QStatusBar::messageChanged, this, [this, convention](const QString& message) {
    convention->setVisible(message.isEmpty());
    setToolTip(message);
  });
  connect(&document, &Document::volumeChanged, this, [this] {
    pointer_->clear();
    frame_->clear();
  });
  connect(&views, &ViewArea::pointed, this, &StatusBar::pointAt);
  connect(&views, &ViewArea::left, pointer_, &QLabel::clear);
  connect(&views, &ViewArea::drawn, this, [this] {
    if (views_.isSettled() || !sinceFrame_.isValid() || sinceFrame_.hasExpired(readable)) showFrame();
  });
}

void StatusBar::pointAt(glm::dvec3 world) {
  const std::optional<glm::ivec3> voxel = document_.voxelAt(world);
  if (!voxel) {
    pointer_->clear();
    return;
  }
  const Volume& volume = *document_.scene().volume;
  QStringList parts{
      QStringLiteral("%1 %2").arg(valueText(volume.value(*voxel), volume.range)).arg(unitText(volume.unit)).trimmed(),
      patientCoordinates(world)};
  if (const Label* label = document_.labelAt(world)) parts << nameOf(*label);
  pointer_->setText(parts.join(QStringLiteral("     ")));
}

void StatusBar::showFrame() {
  const std::optional<FramePacer::Measured>& last = views_.pacer().last();
  if (!last) return;
  // At rest the views show refined pictures; the last measured frame may be one in which another view still moved.
  const Effort effort = views_.isSettled() ? views_.pacer().atRest() : last->effort;
  const double milliseconds = last->milliseconds;
  QString text = milliseconds < 1000.0 ? tr("%1 ms").arg(milliseconds, 0, 'f', milliseconds < 10.0 ? 1 : 0)
                                       : tr("%1 s").arg(milliseconds / 1000.0, 0, 'f', 1);
  if (effort.scale < 1.0)
    text += tr(", %1 % size").arg(100.0 * effort.scale, 0, 'f', 0);
  else
    text += QStringLiteral(", ") + nameOf(effort);
  frame_->setText(text);
  sinceFrame_.start();
  layout()->activate();  // a picture of the window may be taken before the next event
}

}  // namespace fenestra::viewer
