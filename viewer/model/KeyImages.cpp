#include "viewer/model/KeyImages.h"

#include <algorithm>
#include <memory>
#include <utility>

#include <QBuffer>
#include <QImageReader>

#include "viewer/model/CamerasChange.h"
#include "viewer/model/Document.h"
#include "viewer/model/PlacementController.h"
#include "viewer/model/SliceCursor.h"
#include "viewer/model/SlicePlanes.h"

namespace fenestra::viewer {
namespace {

constexpr QSize keyPictureSize(192, 128);  // pixels, at most: large enough to be told apart, some 20 kB each

/// Empty where it cannot be made small enough.
std::string pngOf(const QImage& picture) {
  if (picture.isNull()) return {};
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  picture.scaled(keyPictureSize, Qt::KeepAspectRatio, Qt::SmoothTransformation)
      .convertToFormat(QImage::Format_RGB888)
      .save(&buffer, "PNG");
  const std::string text = bytes.toBase64().toStdString();
  return text.size() <= io::KeyImage::largestPicture ? text : std::string();
}

/// Cut between characters to so many bytes as a session may hold.
std::string boundedName(QString name) {
  name = name.simplified();
  while (name.toUtf8().size() > static_cast<qsizetype>(io::KeyImage::longestName)) name.chop(1);
  if (!name.isEmpty() && name.back().isHighSurrogate()) name.chop(1);
  return name.toStdString();
}

}  // namespace

KeyImages::KeyImages(const Parts& parts) : parts_(parts) {
  connect(&parts_.document, &Document::volumeChanged, this, [this] { awaited_.reset(); });
  connect(&parts_.cameras, &ViewLink::turned, this, [this] { awaited_.reset(); });
  // After the placement, which was made before and so hears of a focus first.
  connect(&parts_.document, &Document::focusChanged, this, &KeyImages::keepCameras);
}

io::KeyImage KeyImages::present() const {
  const Document& document = parts_.document;
  io::KeyImage image;
  image.look = document.look();
  const ViewLink::Pose pose = parts_.cameras.pose();
  for (std::size_t view = 0; view < image.views.size(); ++view)
    image.views[view] = {pose.cameras[view], parts_.cameras.frozen()[view]};
  image.window = document.window();
  image.inverted = document.isInverted();
  image.crosshair = parts_.cursor.position();
  image.planes = parts_.planes.poses();
  return image;
}

bool KeyImages::add(const QImage& picture) {
  std::vector<io::KeyImage> images = parts_.document.keyImages();
  if (images.size() >= io::KeyImage::most) return false;
  const auto isTaken = [&](const std::string& name) {
    return std::any_of(images.begin(), images.end(), [&](const io::KeyImage& each) { return each.name == name; });
  };
  io::KeyImage image = present();
  for (std::size_t number = images.size() + 1; image.name.empty() || isTaken(image.name); ++number)
    image.name = tr("Key image %1").arg(number).toStdString();
  image.picture = pngOf(picture);
  images.push_back(std::move(image));
  parts_.document.setKeyImages(std::move(images), tr("Keep a key image"));
  return true;
}

void KeyImages::show(std::size_t index) {
  const io::KeyImage image = parts_.document.keyImages().at(index);
  Document& document = parts_.document;
  Look look = image.look;
  if (auto* labels = std::get_if<LabelFocus>(&look.focus)) {
    const LabelMap* map = document.labels().get();
    std::erase_if(labels->labels, [map](std::uint16_t label) { return !map || !map->find(label); });
    if (labels->labels.empty()) look.focus = std::monostate{};
  }
  {
    const History::Group step(document.history(), tr("Return to a key image"));
    document.edit(tr("Return to a key image"), std::move(look));
    showCameras(image);
  }
  document.setWindow(image.window);
  document.setInverted(image.inverted);
  parts_.cursor.moveTo(image.crosshair);
  // Last: planes that follow a camera or the crosshair lie where the state had them.
  parts_.planes.setPoses(image.planes);
}

void KeyImages::showCameras(const io::KeyImage& image) {
  ViewLink& cameras = parts_.cameras;
  parts_.placement.cancel();
  ViewLink::Pose pose = cameras.pose();
  for (std::size_t view = 0; view < pose.cameras.size(); ++view) pose.cameras[view] = image.views[view].camera;
  awaited_.reset();
  if (pose != cameras.pose()) {
    auto change = std::make_shared<CamerasChange>(cameras);
    cameras.setPose(pose);
    parts_.document.history().push(tr("Return to a key image"), std::move(change));
  }
  cameras.setFrozen({image.views[0].frozen, image.views[1].frozen});
  if (parts_.document.awaitsGrowth() || parts_.document.asksToOpen()) awaited_ = pose;
}

void KeyImages::keepCameras() {
  if (!awaited_) return;
  const auto& images = parts_.document.keyImages();
  const bool isStillShown = std::any_of(images.begin(), images.end(), [this](const io::KeyImage& image) {
    return image.look.focus == parts_.document.focus() && image.views[0].camera == awaited_->cameras[0] &&
           image.views[1].camera == awaited_->cameras[1];
  });
  if (!isStillShown) return awaited_.reset();  // the user has chosen another focus meanwhile
  if (parts_.document.awaitsGrowth() || parts_.document.asksToOpen()) return;
  parts_.placement.cancel();
  parts_.cameras.setPose(*std::exchange(awaited_, std::nullopt));
}

void KeyImages::rename(std::size_t index, const QString& name) {
  std::vector<io::KeyImage> images = parts_.document.keyImages();
  std::string bounded = boundedName(name);
  if (bounded.empty() || bounded == images.at(index).name) return;
  images[index].name = std::move(bounded);
  parts_.document.setKeyImages(std::move(images), tr("Rename a key image"));
}

void KeyImages::remove(std::size_t index) {
  std::vector<io::KeyImage> images = parts_.document.keyImages();
  images.erase(images.begin() + static_cast<std::ptrdiff_t>(index));
  parts_.document.setKeyImages(std::move(images), tr("Delete a key image"));
}

void KeyImages::move(std::size_t from, std::size_t to) {
  std::vector<io::KeyImage> images = parts_.document.keyImages();
  if (from == to || from >= images.size() || to >= images.size()) return;
  io::KeyImage moved = std::move(images[from]);
  images.erase(images.begin() + static_cast<std::ptrdiff_t>(from));
  images.insert(images.begin() + static_cast<std::ptrdiff_t>(to), std::move(moved));
  parts_.document.setKeyImages(std::move(images), tr("Move a key image"));
}

QImage KeyImages::pictureOf(const io::KeyImage& image) {
  QByteArray bytes = QByteArray::fromBase64(QByteArray::fromStdString(image.picture));
  QBuffer buffer(&bytes);
  QImageReader reader(&buffer, "PNG");
  // Another format, or a size out of proportion, is none of ours; a few bytes may claim gigabytes of pixels.
  const QSize size = reader.size();
  if (size.isEmpty() || size.width() > keyPictureSize.width() || size.height() > keyPictureSize.height()) return {};
  return reader.read();
}

}  // namespace fenestra::viewer
