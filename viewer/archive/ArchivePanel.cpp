#include "viewer/archive/ArchivePanel.h"

#include <algorithm>

#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QShortcut>
#include <QSignalBlocker>
#include <QSplitter>
#include <QToolButton>
#include <QTreeView>
#include <QVBoxLayout>

#include "viewer/archive/ArchiveModel.h"
#include "viewer/archive/ArchivePictures.h"
#include "viewer/archive/Conversation.h"
#include "viewer/archive/RetrievalList.h"
#include "viewer/archive/Retrievals.h"
#include "viewer/archive/SearchForm.h"
#include "viewer/archive/ServerDialog.h"

namespace fenestra::viewer {
namespace {

/// Studies of a first answer, and how many times as many "more" asks for.
constexpr std::size_t firstAnswers = 500, moreFactor = 8;

/// How a search ended, made by the worker.
struct FoundStudies {
  std::shared_ptr<ArchiveNode> tree;
  std::size_t count = 0;
  bool complete = true, ignoresKeys = false;
};

/// Gives the column of names what the others leave, and in a narrow dock as much as shows how a name begins, behind its
/// picture; the list then scrolls to the side.
class NameRoom : public QObject {
 public:
  explicit NameRoom(QTreeView& view) : QObject(&view), view_(view) {
    view.viewport()->installEventFilter(this);
    connect(view.header(), &QHeaderView::sectionResized, this, [this](int column) {
      if (column != ArchiveModel::Name) fit();
    });
    connect(view.model(), &QAbstractItemModel::modelReset, this, &NameRoom::fit);
    connect(view.model(), &QAbstractItemModel::rowsInserted, this, &NameRoom::fit);
  }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() == QEvent::Resize) fit();
    return QObject::eventFilter(watched, event);
  }

 private:
  void fit() {
    // A series is at this depth and called "12: T2 FLAIR…". Only rows that differ in height have a picture.
    constexpr int depth = 3, letters = 16;
    const int picture = view_.uniformRowHeights() ? 0 : view_.iconSize().width();
    const int least = depth * view_.indentation() + picture + letters * view_.fontMetrics().averageCharWidth();
    const int others = view_.header()->length() - view_.columnWidth(ArchiveModel::Name);
    view_.setColumnWidth(ArchiveModel::Name, std::max(view_.viewport()->width() - others, least));
  }

  QTreeView& view_;
};

}  // namespace

ArchivePanel::ArchivePanel(Archives& archives, Retrievals& retrievals, QWidget* parent)
    : QWidget(parent), archives_(archives), retrievals_(retrievals) {
  form_ = new SearchForm(archives_.preferences());
  off_ =
      new QLabel(tr("No server is entered, so nothing goes over the network. Add the archive server (PACS) that "
                    "holds your studies; its administrator knows what to enter."));
  off_->setWordWrap(true);
  list_ = new RetrievalList(retrievals_);
  auto* split = new QSplitter(Qt::Vertical);
  split->setChildrenCollapsible(false);
  split->addWidget(makeResults());
  split->addWidget(list_);
  split->setStretchFactor(0, 1);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(8, 6, 8, 6);
  column->addWidget(makeServerRow());
  column->addWidget(off_);
  column->addWidget(form_);
  column->addWidget(status_);
  column->addWidget(keyRing_);
  column->addWidget(split, 1);

  connect(form_, &SearchForm::searchRequested, this, [this] { search(firstAnswers); });
  connect(form_, &SearchForm::cancelRequested, this, [this] { job_.cancel(); });
  connect(list_, &RetrievalList::openRequested, this, &ArchivePanel::openRequested);
  connect(&archives_, &Archives::serversChanged, this, &ArchivePanel::fillServers);
  connect(model_, &ArchiveModel::seriesWanted, this, &ArchivePanel::fetchSeries);
  connect(&job_, &LoadJob::failed, this, &ArchivePanel::say);
  connect(&job_, &LoadJob::ended, this, [this] {
    if (job_.isRunning()) return;
    form_->setSearching(false);
    if (isSearch_ && status_->text() == tr("Searching…")) say(tr("Cancelled."));
    isSearch_ = false;
  });
  connect(&seriesJob_, &LoadJob::failed, this, [this](const QString& message) {
    model_->forgetFetch(fetching_);
    say(message);
  });
  connect(&seriesJob_, &LoadJob::ended, this, &ArchivePanel::fetchNext, Qt::QueuedConnection);
  fillServers();
}

ArchivePanel::~ArchivePanel() {
  job_.disconnect(this);
  seriesJob_.disconnect(this);
  pictures_.reset();  // before the tree that it looks at
}

QWidget* ArchivePanel::makeServerRow() {
  servers_ = new QComboBox;
  servers_->setObjectName(QStringLiteral("archiveServers"));
  servers_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  servers_->setToolTip(tr("The archive server that is asked"));
  test_ = new QToolButton;
  test_->setObjectName(QStringLiteral("archiveTest"));
  test_->setText(tr("Test"));
  test_->setToolTip(tr("Asks the server whether it answers (echo), and says what is wrong"));
  connect(test_, &QToolButton::clicked, this, &ArchivePanel::test);
  serverMenu_ = new QToolButton;
  serverMenu_->setText(tr("Servers"));
  serverMenu_->setToolTip(tr("Add, edit and remove servers"));
  serverMenu_->setPopupMode(QToolButton::InstantPopup);
  auto* menu = new QMenu(serverMenu_);
  serverMenu_->setMenu(menu);
  connect(menu->addAction(tr("Add a server…")), &QAction::triggered, this, [this] { editServer(newServerEntry()); });
  edit_ = menu->addAction(tr("Edit…"));
  connect(edit_, &QAction::triggered, this, [this] {
    if (const ServerEntry* entry = server()) editServer(ServerEntry(*entry));
  });
  remove_ = menu->addAction(tr("Remove"));
  connect(remove_, &QAction::triggered, this, [this] {
    const ServerEntry* entry = server();
    if (entry &&
        QMessageBox::question(this, tr("Remove the server"), tr("Remove %1?").arg(entry->name)) == QMessageBox::Yes)
      archives_.remove(QString(entry->id));
  });
  connect(servers_, &QComboBox::currentIndexChanged, this, [this] { say({}); });
  auto* row = new QWidget;
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(servers_, 1);
  layout->addWidget(test_);
  layout->addWidget(serverMenu_);
  return row;
}

QWidget* ArchivePanel::makeResults() {
  status_ = new QLabel;
  status_->setObjectName(QStringLiteral("archiveStatus"));
  status_->setTextFormat(Qt::PlainText);
  status_->setWordWrap(true);
  keyRing_ = new QLabel;
  keyRing_->setObjectName(QStringLiteral("archiveKeyRing"));
  keyRing_->setTextFormat(Qt::PlainText);
  keyRing_->setWordWrap(true);
  keyRing_->hide();
  connect(&archives_, &Archives::keyRingFailed, this, [this](const QString& problem) {
    keyRing_->setText(problem);
    keyRing_->show();
  });
  model_ = new ArchiveModel(this);
  results_ = new QTreeView;
  results_->setObjectName(QStringLiteral("archiveResults"));
  results_->setModel(model_);
  results_->setUniformRowHeights(true);
  results_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  results_->setDragEnabled(true);
  results_->setDragDropMode(QAbstractItemView::DragOnly);
  results_->setExpandsOnDoubleClick(false);
  results_->setIndentation(14);
  QHeaderView* header = results_->header();
  header->setStretchLastSection(false);
  header->setMinimumSectionSize(30);
  header->setSectionResizeMode(QHeaderView::Interactive);
  const QFontMetrics metrics(font());
  header->resizeSection(ArchiveModel::Date, metrics.horizontalAdvance(QStringLiteral("2000-00-00")) + 10);
  header->resizeSection(ArchiveModel::Type, metrics.horizontalAdvance(QStringLiteral("CT, MR")) + 10);
  header->resizeSection(ArchiveModel::Images, metrics.horizontalAdvance(tr("Images")) + 12);
  new NameRoom(*results_);
  const auto activate = [this](const QModelIndex& index) {
    const ArchiveNode* node = model_->nodeAt(index);
    if (node && node->kind == ArchiveNode::Kind::Patient)
      results_->setExpanded(index.siblingAtColumn(0), !results_->isExpanded(index.siblingAtColumn(0)));
    else if (node)
      retrieve(*node, true);
  };
  // Not activated(), which some desktops emit for a single click.
  connect(results_, &QTreeView::doubleClicked, this, activate);
  auto* enter = new QShortcut(Qt::Key_Return, results_, nullptr, nullptr, Qt::WidgetShortcut);
  connect(enter, &QShortcut::activated, this, [this, activate] { activate(results_->currentIndex()); });
  connect(results_->selectionModel(), &QItemSelectionModel::selectionChanged, this, &ArchivePanel::enableButtons);
  connect(model_, &ArchiveModel::modelReset, this, &ArchivePanel::enableButtons);

  pictures_ = std::make_unique<ArchivePictures>(archives_, *results_, *model_);

  QHBoxLayout* buttons = makeResultButtons();
  resultsPart_ = new QWidget;
  auto* column = new QVBoxLayout(resultsPart_);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(results_, 1);
  column->addLayout(buttons);
  enableButtons();
  return resultsPart_;
}

QHBoxLayout* ArchivePanel::makeResultButtons() {
  open_ = new QPushButton(tr("Open"));
  open_->setObjectName(QStringLiteral("archiveOpen"));
  open_->setToolTip(
      tr("Retrieves the study or series, and opens it once it is whole (double-click, or drag onto a view)"));
  connect(open_, &QPushButton::clicked, this, [this] { retrieveSelected(true); });
  retrieve_ = new QPushButton(tr("Retrieve"));
  retrieve_->setObjectName(QStringLiteral("archiveRetrieve"));
  retrieve_->setToolTip(tr("Fetches what is selected into the cache, to be opened later"));
  connect(retrieve_, &QPushButton::clicked, this, [this] { retrieveSelected(false); });
  more_ = new QToolButton;
  more_->setObjectName(QStringLiteral("archiveMore"));
  more_->setText(tr("More…"));
  more_->setToolTip(tr("Asks for more of the studies that match"));
  more_->hide();
  connect(more_, &QToolButton::clicked, this, [this] { search(most_ * moreFactor); });
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(open_);
  buttons->addWidget(retrieve_);
  buttons->addStretch();
  buttons->addWidget(more_);
  return buttons;
}

QString ArchivePanel::status() const { return status_->text(); }

const ServerEntry* ArchivePanel::server() const { return archives_.find(servers_->currentData().toString()); }

void ArchivePanel::fillServers() {
  const QString chosen = servers_->currentData().toString();
  {
    const QSignalBlocker quiet(servers_);
    servers_->clear();
    for (const ServerEntry& each : archives_.servers()) servers_->addItem(each.name, each.id);
    if (const int at = servers_->findData(chosen); at >= 0) servers_->setCurrentIndex(at);
  }
  const bool isOn = servers_->count() > 0;
  for (QWidget* each : {static_cast<QWidget*>(servers_), static_cast<QWidget*>(test_), static_cast<QWidget*>(form_),
                        static_cast<QWidget*>(status_), resultsPart_})
    each->setVisible(isOn);
  off_->setVisible(!isOn);
  edit_->setEnabled(isOn);
  remove_->setEnabled(isOn);
  say({});
}

void ArchivePanel::editServer(const ServerEntry& entry) {
  ServerDialog dialog(entry, this);
  if (dialog.exec() != QDialog::Accepted) return;
  archives_.put(dialog.entry());
  servers_->setCurrentIndex(servers_->findData(entry.id));
}

void ArchivePanel::test() {
  const ServerEntry* entry = server();
  const std::optional<AnyServer> reached = entry ? archives_.reach(*entry) : std::nullopt;
  if (!reached) return;
  say(tr("Asking %1…").arg(entry->name));
  isSearch_ = false;
  form_->setSearching(true);
  job_.start([this, name = entry->name,
              talk = Conversation(archives_, entry->id, *reached)](const io::Progress& progress) -> LoadJob::Show {
    const auto taken = talk.run([&](const auto& each) { return io::archive::echo(each, progress); });
    return [this, name, taken] { say(tr("%1 answers, in %2 ms.").arg(name).arg(taken.count())); };
  });
}

void ArchivePanel::setFoundAt(const QString& id) {
  found_ = id;
  pictures_->setServer(id);
}

void ArchivePanel::search(std::size_t most) {
  const ServerEntry* entry = server();
  std::optional<AnyServer> reached = entry ? archives_.reach(*entry) : std::nullopt;
  if (!reached) return;
  const io::archive::Attributes keys = most > firstAnswers ? keys_ : form_->keys();
  // More of what was found is found at the same server.
  if (most > firstAnswers && found_ != entry->id) return;
  std::visit([&](auto& each) { each.limits.answers = std::min(most, each.limits.answers); }, *reached);
  keys_ = keys;
  most_ = most;
  more_->hide();
  wantedSeries_.clear();
  seriesJob_.cancel();
  setFoundAt(entry->id);
  model_->setTree(std::make_shared<ArchiveNode>());
  say(tr("Searching…"));
  isSearch_ = true;
  form_->setSearching(true);
  job_.start(
      [this, keys, talk = Conversation(archives_, entry->id, *reached)](const io::Progress& progress) -> LoadJob::Show {
        const io::archive::Answers answers = talk.run([&](const auto& each) {
          return io::archive::find(each, {io::archive::Level::Study, keys}, progress);
        });
        const FoundStudies found{treeOfStudies(answers.records), answers.records.size(), answers.complete,
                                 answers.ignoresKeys};
        return [this, found] { showStudies(found.tree, found.count, found.complete, found.ignoresKeys); };
      });
}

void ArchivePanel::showStudies(std::shared_ptr<ArchiveNode> tree, std::size_t count, bool complete, bool ignoresKeys) {
  const std::size_t patients = tree->children.size();
  model_->setTree(std::move(tree));
  // A few are unfolded; of many, the patients are looked through first.
  constexpr std::size_t few = 50;
  if (count <= few) results_->expandToDepth(0);
  // Patients have nothing but a name, which needs the width. The view keeps a list of such rows.
  constexpr std::size_t most = 2000;
  for (std::size_t row = 0; row < std::min(patients, most); ++row)
    results_->setFirstColumnSpanned(static_cast<int>(row), {}, true);
  QString text = count == 0 ? tr("Nothing matches. Check the spelling; an asterisk stands for any text, as in *jane*.")
                            : tr("Studies: %1, of patients: %2.").arg(count).arg(patients);
  if (!complete) text += QLatin1Char(' ') + tr("There are more: narrow the search, or ask for more.");
  if (ignoresKeys) text += QLatin1Char(' ') + tr("The server does not match by some of the fields.");
  more_->setVisible(!complete && most_ < io::archive::Limits{}.answers);
  say(text);
}

void ArchivePanel::fetchSeries(const QString& study) {
  wantedSeries_.push_back(study.toStdString());
  // Not while the tree asks: rows must not come in the middle of that.
  if (!seriesJob_.isRunning()) QMetaObject::invokeMethod(this, &ArchivePanel::fetchNext, Qt::QueuedConnection);
}

void ArchivePanel::fetchNext() {
  if (wantedSeries_.empty() || seriesJob_.isRunning()) return;
  const ServerEntry* entry = archives_.find(found_);
  const std::optional<AnyServer> reached = entry ? archives_.reach(*entry) : std::nullopt;
  if (!reached) {
    for (const std::string& each : wantedSeries_) model_->forgetFetch(each);
    wantedSeries_.clear();
    return;
  }
  fetching_ = wantedSeries_.front();
  wantedSeries_.pop_front();
  seriesJob_.start([this, study = fetching_, talk = Conversation(archives_, entry->id, *reached)](
                       const io::Progress& progress) -> LoadJob::Show {
    const io::archive::Query query{io::archive::Level::Series, {{"StudyInstanceUID", study}}};
    const auto answers = std::make_shared<io::archive::Answers>(
        talk.run([&](const auto& each) { return io::archive::find(each, query, progress); }));
    return [this, study, answers] { model_->setSeries(study, std::move(answers->records)); };
  });
}

void ArchivePanel::say(const QString& text) { status_->setText(text); }

void ArchivePanel::enableButtons() {
  bool some = false;
  for (const QModelIndex& index : results_->selectionModel()->selectedRows()) some |= model_->nodeAt(index) != nullptr;
  open_->setEnabled(some);
  retrieve_->setEnabled(some);
}

void ArchivePanel::retrieve(const ArchiveNode& node, bool opens) {
  if (node.kind == ArchiveNode::Kind::Patient) {
    for (const auto& study : node.children) retrieve(*study, opens && study->row == 0);
    return;
  }
  const bool isSeries = node.kind == ArchiveNode::Kind::Series;
  const ArchiveNode& study = isSeries ? *node.parent : node;
  RetrievalOrder order{found_, study.value("StudyInstanceUID"), {}, model_->titleOf(node), opens};
  if (isSeries) order.series = node.value("SeriesInstanceUID");
  retrievals_.add(order);
}

void ArchivePanel::retrieveSelected(bool opens) {
  for (const QModelIndex& index : results_->selectionModel()->selectedRows()) {
    const ArchiveNode* node = model_->nodeAt(index);
    if (node) retrieve(*node, std::exchange(opens, false));
  }
}

void ArchivePanel::setHidesPatient(bool hides) {
  form_->setHidesPatient(hides);
  model_->setHidesPatient(hides);
  list_->setHidesPatient(hides);
}

}  // namespace fenestra::viewer
