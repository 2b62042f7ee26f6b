#pragma once
// The Archive dock's contents: the servers, a search, what it found, and what is being retrieved. Nothing goes over the
// network but what the user asks for here; all of it on other threads, with cancel.

#include <deque>
#include <memory>
#include <optional>

#include <QWidget>

#include "io/archive/Records.h"
#include "viewer/archive/Archives.h"
#include "viewer/jobs/LoadJob.h"

class QComboBox;
class QHBoxLayout;
class QLabel;
class QPushButton;
class QToolButton;
class QTreeView;

namespace fenestra::viewer {

class ArchiveModel;
class ArchivePictures;
struct ArchiveNode;
class RetrievalList;
class Retrievals;
class SearchForm;

class ArchivePanel : public QWidget {
  Q_OBJECT
 public:
  /// All outlive this.
  ArchivePanel(Archives& archives, Retrievals& retrievals, QWidget* parent = nullptr);
  ~ArchivePanel() override;

  void setHidesPatient(bool hides);
  /// Retrieves what is selected in the results; with `opens`, the first of it is opened once it is whole.
  void retrieveSelected(bool opens);

  SearchForm& form() { return *form_; }
  ArchiveModel& model() { return *model_; }
  QTreeView& results() { return *results_; }
  /// The server that the model's tree is from, by its entry's id.
  void setFoundAt(const QString& id);
  ArchivePictures& pictures() { return *pictures_; }
  /// Shows what a search found, and says what is to be known of it: `count` studies, whether these are all, and whether
  /// the server does not match by some of the keys.
  void showStudies(std::shared_ptr<ArchiveNode> tree, std::size_t count, bool complete, bool ignoresKeys);
  /// What the panel says of the last search or test.
  QString status() const;
  bool isBusy() const { return job_.isRunning() || seriesJob_.isRunning(); }
  /// The entry of the server that is chosen; null: there is none.
  const ServerEntry* server() const;

 Q_SIGNALS:
  void openRequested(int retrieval);

 private:
  QWidget* makeServerRow();
  QWidget* makeResults();
  QHBoxLayout* makeResultButtons();
  void fillServers();
  void editServer(const ServerEntry& entry);
  void test();
  void search(std::size_t most);
  void fetchSeries(const QString& study);
  void fetchNext();
  void say(const QString& text);
  void enableButtons();
  void retrieve(const ArchiveNode& node, bool opens);

  Archives& archives_;
  Retrievals& retrievals_;
  LoadJob job_{archiveThreads()};         ///< a test or a search
  LoadJob seriesJob_{archiveThreads()};   ///< the series of one study
  std::deque<std::string> wantedSeries_;  ///< studies whose series are to be fetched
  std::string fetching_;                  ///< the study whose series are being fetched
  QString found_;                         ///< the server whose answers are shown, by its entry's id
  io::archive::Attributes keys_;
  std::size_t most_ = 0;  ///< answers that were asked for
  bool isSearch_ = false;

  QComboBox* servers_;
  QToolButton *test_, *serverMenu_;
  QAction *edit_, *remove_;
  SearchForm* form_;
  QLabel *off_, *status_, *keyRing_;
  QToolButton* more_;
  QWidget* resultsPart_;
  QTreeView* results_;
  ArchiveModel* model_;
  QPushButton *retrieve_, *open_;
  RetrievalList* list_;
  std::unique_ptr<ArchivePictures> pictures_;  ///< in the tree
};

}  // namespace fenestra::viewer
