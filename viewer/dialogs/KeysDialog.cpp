#include "viewer/dialogs/KeysDialog.h"

#include <QAction>
#include <QDialogButtonBox>
#include <QFile>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSaveFile>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "viewer/dialogs/KeyBindings.h"
#include "viewer/model/Paths.h"
#include "viewer/panels/FileDialog.h"

namespace fenestra::viewer {
namespace {

QString keysText(const QList<QKeySequence>& keys) { return QKeySequence::listToString(keys, QKeySequence::NativeText); }

}  // namespace

KeysDialog::KeysDialog(KeyBindings& bindings, QWidget* parent)
    : QDialog(parent), bindings_(bindings), list_(new QTreeWidget), says_(new QLabel) {
  setWindowTitle(tr("Change keys"));
  auto* filter = new QLineEdit;
  filter->setObjectName(QStringLiteral("keyFilter"));
  filter->setPlaceholderText(tr("Show entries with these words or keys"));
  filter->setClearButtonEnabled(true);
  connect(filter, &QLineEdit::textChanged, this, &KeysDialog::showOnly);
  list_->setObjectName(QStringLiteral("keyList"));
  list_->setRootIsDecorated(false);
  list_->setHeaderLabels({tr("Menu"), tr("Entry"), tr("Keys")});
  list_->setUniformRowHeights(true);
  says_->setWordWrap(true);
  says_->setObjectName(QStringLiteral("keySays"));
  auto* column = new QVBoxLayout(this);
  column->addWidget(filter);
  column->addWidget(list_, 1);
  column->addWidget(makeEditor());
  column->addWidget(says_);
  column->addWidget(makeButtons());
  fill();
  connect(list_, &QTreeWidget::currentItemChanged, this, &KeysDialog::follow);
  connect(&bindings_, &KeyBindings::changed, this, &KeysDialog::fill);
  list_->setCurrentItem(list_->topLevelItem(0));
  // As high as before where the line below the list has two rows, so that nothing moves under the mouse.
  says_->setMinimumHeight(2 * fontMetrics().lineSpacing());
  resize(620, 620);
}

QWidget* KeysDialog::makeEditor() {
  key_ = new QKeySequenceEdit;
  key_->setObjectName(QStringLiteral("key"));
  take_ = new QPushButton(tr("&Take it"));
  take_->setObjectName(QStringLiteral("takeKey"));
  take_->setToolTip(tr("Gives the key to this entry, and the other one loses it"));
  remove_ = new QPushButton(tr("&No key"));
  reset_ = new QPushButton(tr("As it &was"));
  reset_->setToolTip(tr("The key that the entry comes with"));
  for (QPushButton* button : {take_, remove_, reset_}) button->setAutoDefault(false);
  auto* line = new QWidget;
  auto* row = new QHBoxLayout(line);
  row->setContentsMargins(0, 0, 0, 0);
  auto* label = new QLabel(tr("&Key"));
  label->setBuddy(key_);
  row->addWidget(label);
  row->addWidget(key_, 1);
  for (QPushButton* button : {take_, remove_, reset_}) row->addWidget(button);
  connect(key_, &QKeySequenceEdit::editingFinished, this, &KeysDialog::typed);
  connect(take_, &QPushButton::clicked, this, [this] { bindings_.set(*chosen(), {asked_}); });
  connect(remove_, &QPushButton::clicked, this, [this] { bindings_.set(*chosen(), {}); });
  connect(reset_, &QPushButton::clicked, this, [this] { bindings_.reset(*chosen()); });
  return line;
}

QWidget* KeysDialog::makeButtons() {
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  QPushButton* all = buttons->addButton(tr("&All as they were"), QDialogButtonBox::ResetRole);
  all->setObjectName(QStringLiteral("resetKeys"));
  QPushButton* write = buttons->addButton(tr("&Export…"), QDialogButtonBox::ActionRole);
  QPushButton* read = buttons->addButton(tr("&Import…"), QDialogButtonBox::ActionRole);
  connect(all, &QPushButton::clicked, &bindings_, &KeyBindings::resetAll);
  connect(write, &QPushButton::clicked, this, &KeysDialog::exportKeys);
  connect(read, &QPushButton::clicked, this, &KeysDialog::importKeys);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  for (QAbstractButton* each : buttons->buttons()) static_cast<QPushButton*>(each)->setAutoDefault(false);
  return buttons;
}

QAction* KeysDialog::chosen() const {
  const QTreeWidgetItem* row = list_->currentItem();
  return bindings_.entries()[static_cast<std::size_t>(list_->indexOfTopLevelItem(const_cast<QTreeWidgetItem*>(row)))]
      .action;
}

void KeysDialog::fill() {
  for (const KeyBindings::Entry& each : bindings_.entries()) {
    const auto at = static_cast<int>(&each - bindings_.entries().data());
    QTreeWidgetItem* row = list_->topLevelItem(at);
    if (!row) row = new QTreeWidgetItem(list_);
    row->setText(0, each.menu);
    row->setText(1, KeyBindings::nameOf(*each.action));
    row->setText(2, keysText(each.action->shortcuts()));
    QFont font = row->font(2);
    font.setBold(each.action->shortcuts() != each.defaults);
    row->setFont(2, font);
  }
  for (int column = 0; column < 2; ++column) list_->resizeColumnToContents(column);
  if (list_->currentItem()) follow();
}

void KeysDialog::follow() {
  if (!list_->currentItem()) return;
  asked_ = {};
  key_->setKeySequence(chosen()->shortcut());
  take_->setEnabled(false);
  remove_->setEnabled(!chosen()->shortcut().isEmpty());
  says_->setText(tr("Click into the box and press the key. Changed keys are bold."));
}

void KeysDialog::showOnly(const QString& words) {
  for (int i = 0; i < list_->topLevelItemCount(); ++i) {
    QTreeWidgetItem* row = list_->topLevelItem(i);
    const QString text = row->text(0) + QLatin1Char(' ') + row->text(1) + QLatin1Char(' ') + row->text(2);
    row->setHidden(!text.contains(words, Qt::CaseInsensitive));
  }
}

void KeysDialog::typed() {
  if (key_->keySequence().isEmpty() || !list_->currentItem()) return;
  const QKeySequence keys(key_->keySequence()[0]);  // one key, not several one after another
  if (keys == chosen()->shortcut()) return follow();
  key_->setKeySequence(keys);
  const QString text = keys.toString(QKeySequence::NativeText);
  if (KeyBindings::isOfViews(keys)) {
    follow();
    return says_->setText(tr("%1 is a key of the views: no entry can have it.").arg(text));
  }
  const KeyBindings::Entry* other = bindings_.owner(keys);
  if (!other || other->action == chosen()) return bindings_.set(*chosen(), {keys});
  asked_ = keys;
  take_->setEnabled(true);
  says_->setText(tr("%1 is the key of %2 → %3. Take it?").arg(text, other->menu, KeyBindings::nameOf(*other->action)));
}

void KeysDialog::exportKeys() {
  const auto file = askForNewFile(this, tr("Export keys"), {{tr("Keys"), QStringLiteral(".json")}},
                                  QStringLiteral("fenestra-keys.json"));
  if (!file) return;
  QSaveFile out(toQString(file->path));
  const QByteArray json = bindings_.toJson();
  if (out.open(QIODevice::WriteOnly) && out.write(json) == json.size() && out.commit())
    says_->setText(tr("Written to %1.").arg(toQString(file->path.filename())));
  else
    says_->setText(tr("%1 cannot be written: %2. Choose another folder.")
                       .arg(toQString(file->path.filename()), out.errorString()));
}

void KeysDialog::importKeys() {
  const auto path = askForFile(this, {tr("Import keys"), tr("Keys (*.json);;All files (*)")});
  if (!path) return;
  QFile in(toQString(*path));
  constexpr qint64 most = 1 << 20;  // a file of keys has some kilobytes
  if (!in.open(QIODevice::ReadOnly))
    return says_->setText(tr("%1 cannot be read: %2.").arg(toQString(path->filename()), in.errorString()));
  const QString problem = bindings_.fromJson(in.read(most));
  says_->setText(problem.isEmpty() ? tr("Taken over from %1.").arg(toQString(path->filename()))
                                   : QStringLiteral("%1: %2").arg(toQString(path->filename()), problem));
}

}  // namespace fenestra::viewer
