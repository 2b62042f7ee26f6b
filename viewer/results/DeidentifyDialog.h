#pragma once
// Writes de-identified copies of the open series and its labels, to a new folder, to an archive server, or both, and
// shows beforehand which attributes change.

#include <filesystem>
#include <vector>

#include <QDialog>

#include "io/deidentify/Deidentify.h"
#include "viewer/archive/Archives.h"
#include "viewer/archive/SentAnswers.h"
#include "viewer/jobs/LoadJob.h"

class QCheckBox;
class QComboBox;
class QGridLayout;
class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QTreeWidget;
class QVBoxLayout;

namespace fenestra::viewer {

class Document;

class DeidentifyDialog : public QDialog {
  Q_OBJECT
 public:
  /// Both outlive this.
  DeidentifyDialog(Archives& archives, const Document& document, QWidget* parent = nullptr);

  void save();
  bool isBusy() const { return job_.isRunning(); }
  bool isPreviewing() const { return preview_.isRunning(); }
  /// Where the folder of the copies will be made.
  void setFolder(const QString& folder);
  /// The file of old and new UIDs.
  void setMap(const QString& file);

  void reject() override;

 private:
  /// What is to be done, for another thread.
  struct Order {
    std::vector<std::filesystem::path> series;
    std::shared_ptr<const LabelMap> labels;  ///< may be null
    io::deidentify::Options options;
    std::filesystem::path folder, map;  ///< empty: none
  };
  struct Outcome {
    io::deidentify::Outcome copies;
    std::filesystem::path folder;
    std::vector<io::archive::Sent> sent;
    bool isSent = false;
  };

  QCheckBox* addBox(const char* name, const QString& text, const QString& toolTip);
  void addWhat(QVBoxLayout& column);
  void addTable(QVBoxLayout& column);
  void addPlaces(QVBoxLayout& column);
  QPushButton* addPlace(QGridLayout& grid, QCheckBox* box, QLineEdit*& edit, const QString& name);
  void addOutcome(QVBoxLayout& column);
  void chooseFolder();
  void chooseMap();
  io::deidentify::Options options() const;
  /// Copies in `place`, which does not exist.
  static io::deidentify::Outcome copy(const Order& order, const std::filesystem::path& place,
                                      const io::Progress& progress);
  void showPreview();
  void fill(const io::deidentify::Changes& changes);
  void tell(const Outcome& outcome);
  void enable();

  Archives& archives_;
  const Document& document_;
  LoadJob preview_, job_{archiveThreads()};
  QCheckBox *labels_ = nullptr, *dates_ = nullptr, *uids_ = nullptr, *descriptors_ = nullptr, *graphics_ = nullptr,
            *face_ = nullptr, *toFolder_ = nullptr, *toMap_ = nullptr, *toArchive_ = nullptr;
  QLineEdit *folder_ = nullptr, *map_ = nullptr;
  QComboBox* servers_ = nullptr;
  QTreeWidget* table_ = nullptr;
  SentAnswers* answers_ = nullptr;
  QLabel* status_ = nullptr;
  QProgressBar* progress_ = nullptr;
  QPushButton* save_ = nullptr;
};

}  // namespace fenestra::viewer
