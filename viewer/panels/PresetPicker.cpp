#include "viewer/panels/PresetPicker.h"

#include <algorithm>

#include <QAbstractItemView>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QInputDialog>
#include <QMessageBox>
#include <QPointer>
#include <QSignalBlocker>
#include <QStandardItemModel>
#include <QStyledItemDelegate>

#include "io/TransferFunctionFile.h"
#include "rendering/settings/LookStyle.h"
#include "viewer/model/Document.h"
#include "viewer/model/Paths.h"
#include "viewer/model/PreviewBackend.h"
#include "viewer/model/Translation.h"
#include "viewer/model/WayOutText.h"
#include "viewer/panels/FileDialog.h"

namespace fenestra::viewer {
namespace {

// Device-independent pixels: in the open list, and beside the name of what is shown.
constexpr QSize pictureSize(64, 56), smallSize(22, 19);

/// A row's choice: the id or path that Document::setPreset takes, or the name of a user's preset.
enum Role : int { Function = Qt::UserRole, Preset, HasPicture };

}  // namespace

void PresetBox::showPopup() {
  Q_EMIT opening();
  QComboBox::showPopup();
}

void PresetBox::keyPressEvent(QKeyEvent* event) {
  enableLast(false);
  QComboBox::keyPressEvent(event);
  enableLast(true);
}

void PresetBox::wheelEvent(QWheelEvent* event) {
  enableLast(false);
  QComboBox::wheelEvent(event);
  enableLast(true);
}

void PresetBox::enableLast(bool enable) {
  if (count() > 0) qobject_cast<QStandardItemModel*>(model())->item(count() - 1)->setEnabled(enable);
}

PresetQuestions presetDialogs(QWidget* parent) {
  const auto ask = [parent](const QString& question) {
    return QMessageBox::question(parent, PresetPicker::tr("Presets"), question) == QMessageBox::Yes;
  };
  return {
      .name =
          [=](const QString& suggested) {
            return QInputDialog::getText(parent, PresetPicker::tr("Presets"), PresetPicker::tr("Name of the preset"),
                                         QLineEdit::Normal, suggested)
                .trimmed();
          },
      .importWhich =
          [=] {
            return askForFile(parent, {PresetPicker::tr("Import a preset"), PresetPicker::tr("Presets (*.json)")});
          },
      .exportWhere = [=](const QString& suggested) -> std::optional<std::filesystem::path> {
        const FileKind kind{PresetPicker::tr("Presets"), QStringLiteral(".json")};
        const auto file = askForNewFile(parent, PresetPicker::tr("Export the preset"), {kind}, suggested + kind.ending);
        return file ? std::optional(file->path) : std::nullopt;
      },
      .mayReplace =
          [=](const QString& name) { return ask(PresetPicker::tr("There is a preset \"%1\". Replace it?").arg(name)); },
      .mayDelete = [=](const QString& name) { return ask(PresetPicker::tr("Delete the preset \"%1\"?").arg(name)); },
      .functionWhich =
          [=] {
            return askForFile(parent, {PresetPicker::tr("Open a transfer function"),
                                       PresetPicker::tr("Transfer functions (*.json)")});
          }};
}

PresetPicker::PresetPicker(Document& document, LookLibrary& library, QWidget* parent)
    : QWidget(parent),
      document_(document),
      library_(library),
      box_(new PresetBox),
      button_(new QToolButton),
      menu_(new QMenu(this)),
      questions_(presetDialogs(this)) {
  box_->setIconSize(smallSize);
  box_->setItemDelegate(new QStyledItemDelegate(box_));  // a menu's delegate draws small icons
  box_->view()->setIconSize(pictureSize);
  box_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  box_->setPlaceholderText(tr("Edited"));
  box_->setToolTip(tr("Transfer functions, and your own presets of the whole look"));
  button_->setText(QStringLiteral("…"));
  button_->setToolTip(tr("Keep, import, export, rename and delete presets"));
  button_->setAccessibleName(button_->toolTip());
  button_->setPopupMode(QToolButton::InstantPopup);
  button_->setFocusPolicy(Qt::StrongFocus);
  button_->setMenu(menu_);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(box_, 1);
  row->addWidget(button_);

  connect(box_, &QComboBox::activated, this, &PresetPicker::choose);
  connect(box_, &PresetBox::opening, this, &PresetPicker::makePictures);
  connect(menu_, &QMenu::aboutToShow, this, &PresetPicker::fillMenu);
  connect(&library, &LookLibrary::changed, this, &PresetPicker::list);
  connect(&document, &Document::volumeChanged, this, &PresetPicker::clearPictures);
  connect(&document, &Document::transferFunctionChanged, this, &PresetPicker::show);
  connect(&document, &Document::sceneChanged, this, &PresetPicker::show);
  list();
}

void PresetPicker::list() {
  const QSignalBlocker quiet(box_);
  const auto presets = io::transferFunctionPresets();
  // A user's preset may have changed since its picture was drawn.
  std::vector<QIcon> pictures(presets.size());
  for (std::size_t row = 0; row < presets.size(); ++row)
    if (box_->itemData(static_cast<int>(row), HasPicture).toBool())
      pictures[row] = box_->itemIcon(static_cast<int>(row));
  box_->clear();
  for (std::size_t row = 0; row < presets.size(); ++row) {
    box_->addItem(pictures[row], translated(presets[row].name), QString::fromStdString(presets[row].id));
    box_->setItemData(static_cast<int>(row), !pictures[row].isNull(), HasPicture);
  }
  for (const LookLibrary::Entry& entry : library_.entries()) {
    box_->addItem(QString::fromStdString(entry.preset.name));
    box_->setItemData(box_->count() - 1, QString::fromStdString(entry.preset.name), Preset);
  }
  box_->addItem(tr("From a file…"));
  show();
}

void PresetPicker::show() {
  int row = -1;
  if (document_.hasVolume()) {
    const QString function = QString::fromStdString(document_.preset());
    // The function's own preset or file, if it is listed; otherwise the user's preset that the whole look equals.
    if (!function.isEmpty()) row = box_->findData(function, Function);
    if (const auto& entries = library_.entries(); row < 0 && !entries.empty()) {
      // Without the names of the function's preset and file, which the user's presets do not hold.
      SetScene nameless = document_.study().scene;
      nameless.look.context = styleOf(nameless.look).context;
      const auto same = std::find_if(entries.begin(), entries.end(), [&](const auto& each) {
        return io::restyled(nameless, each.preset) == nameless.look;
      });
      if (same != entries.end()) row = box_->findData(QString::fromStdString(same->preset.name), Preset);
    }
    if (row < 0 && !function.isEmpty()) {  // a file, which gets an entry with its name
      row = box_->count() - 1;
      box_->insertItem(row, QFileInfo(function).completeBaseName(), function);
    }
  }
  box_->setCurrentIndex(row);
}

void PresetPicker::choose(int row) {
  const QString preset = box_->itemData(row, Preset).toString();
  attempt([&] {
    if (!preset.isEmpty()) {
      if (const LookLibrary::Entry* entry = library_.find(preset)) apply(*entry);
      return;
    }
    QString function = box_->itemData(row, Function).toString();
    if (function.isEmpty()) {
      const auto file = questions_.functionWhich();
      if (file) function = toQString(*file);
    }
    if (function.isEmpty()) return;
    document_.setPreset(toPath(function).string());
    Q_EMIT lookChosen(nullptr);
  });
  show();
}

void PresetPicker::apply(const LookLibrary::Entry& entry) {
  document_.edit(tr("Preset"), io::restyled(document_.study().scene, entry.preset));
  const std::string odd = io::mismatchOf(entry.preset, document_.scene().volume->unit);
  Q_EMIT lookChosen(&entry.preset);
  if (!odd.empty()) Q_EMIT warned(QString::fromStdString(odd));
}

QString PresetPicker::shownPreset() const { return box_->currentData(Preset).toString(); }

void PresetPicker::fillMenu() {
  menu_->clear();
  const auto add = [this](const QString& text, auto does, bool enabled) {
    menu_->addAction(text, this, does)->setEnabled(enabled);
  };
  const bool isOpen = document_.hasVolume(), isOwn = !shownPreset().isEmpty();
  add(tr("Keep this look as a preset…"), &PresetPicker::keepLook, isOpen && library_.canKeep());
  add(tr("Rename…"), &PresetPicker::renamePreset, isOwn);
  add(tr("Delete…"), &PresetPicker::deletePreset, isOwn);
  menu_->addSeparator();
  add(tr("Import a preset…"), &PresetPicker::importPreset, library_.canKeep());
  add(tr("Export this look…"), &PresetPicker::exportPreset, isOpen);
}

void PresetPicker::keepLook() {
  attempt([this] {
    const QString name = questions_.name(shownPreset());
    if (name.isEmpty() || (library_.find(name) && !questions_.mayReplace(name))) return;
    library_.keep(io::presetOf(name.toStdString(), document_.study().scene));
  });
}

void PresetPicker::importPreset() {
  attempt([this] {
    const auto file = questions_.importWhich();
    if (!file) return;
    const QString name = library_.import(*file);
    if (const LookLibrary::Entry* entry = library_.find(name); entry && document_.hasVolume()) apply(*entry);
    show();
  });
}

void PresetPicker::exportPreset() {
  attempt([this] {
    const QString preset = shownPreset();
    const auto file = questions_.exportWhere(preset.isEmpty() ? tr("Look") : preset);
    if (!file) return;
    const LookLibrary::Entry* entry = library_.find(preset);
    io::writeLook(*file, entry ? entry->preset : io::presetOf(file->stem().string(), document_.study().scene));
  });
}

void PresetPicker::renamePreset() {
  attempt([this] {
    const QString name = shownPreset(), to = questions_.name(name);
    if (to.isEmpty() || to == name || (library_.find(to) && !questions_.mayReplace(to))) return;
    library_.rename(name, to);
  });
}

void PresetPicker::deletePreset() {
  attempt([this] {
    const QString name = shownPreset();
    if (questions_.mayDelete(name)) library_.remove(name);
  });
}

void PresetPicker::attempt(const std::function<void()>& work) {
  try {
    work();
  } catch (const std::exception& error) {
    Q_EMIT failed(windowText(error));
  }
}

bool PresetPicker::hasAllPictures() const {
  for (int row = 0; row + 1 < box_->count(); ++row)
    if (!box_->itemData(row, HasPicture).toBool()) return false;
  return true;
}

void PresetPicker::clearPictures() {
  for (int row = 0; row < box_->count(); ++row) {
    box_->setItemIcon(row, {});
    box_->setItemData(row, false, HasPicture);
  }
}

void PresetPicker::makePictures() {
  if (!backend_ || !document_.hasVolume()) return;
  std::vector<PreviewBackend::LookMaker> looks;
  const double ratio = devicePixelRatioF();
  QPixmap empty(pictureSize * ratio);
  empty.setDevicePixelRatio(ratio);
  empty.fill(Qt::black);
  std::vector<QString> names;  // rows move when presets come and go
  for (int row = 0; row + 1 < box_->count(); ++row) {
    if (box_->itemData(row, HasPicture).toBool()) continue;
    box_->setItemIcon(row, empty);  // rows keep their height when the pictures come
    names.push_back(box_->itemText(row));
    const std::string function = toPath(box_->itemData(row, Function).toString()).string();
    if (const LookLibrary::Entry* entry = library_.find(box_->itemData(row, Preset).toString()))
      looks.emplace_back([look = entry->preset.look] { return look; });
    else
      looks.emplace_back([function, look = document_.look(), volume = document_.scene().volume]() mutable {
        look.context = io::loadContextFunction(function, *volume);
        return look;
      });
  }
  if (looks.empty()) return;
  backend_->request(
      document_.scene(), std::move(looks), pictureSize * ratio,
      [self = QPointer(this), names, ratio, of = document_.scene().volume](std::size_t index, QImage picture) {
        if (!self || self->document_.scene().volume != of) return;
        picture.setDevicePixelRatio(ratio);
        const int row = self->box_->findText(names[index], Qt::MatchExactly);
        if (row < 0) return;
        self->box_->setItemIcon(row, QPixmap::fromImage(picture));
        self->box_->setItemData(row, true, HasPicture);
      });
}

}  // namespace fenestra::viewer
