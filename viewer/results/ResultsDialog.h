#pragma once
// Saves results of the open study as DICOM objects: measures and the table of labels, segmentations, a picture, key
// images; to a folder, to an archive server, or both. It says of each why it cannot be written.

#include <vector>

#include <QDialog>

#include "viewer/archive/Archives.h"
#include "viewer/dialogs/PictureDialog.h"
#include "viewer/jobs/LoadJob.h"
#include "viewer/results/ResultsWriter.h"
#include "viewer/views/PictureMaker.h"

class QCheckBox;
class QComboBox;
class QGridLayout;
class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QVBoxLayout;

namespace fenestra::viewer {

class Document;
class SentAnswers;
class ViewArea;
class ViewOptions;

class ResultsDialog : public QDialog {
  Q_OBJECT
 public:
  struct Parts {
    const Document& document;
    const ViewOptions& options;
    ViewArea& views;
    Archives& archives;
  };
  /// All outlive this.
  explicit ResultsDialog(const Parts& parts, QWidget* parent = nullptr);

  void save();
  bool isBusy() const { return maker_.isMaking() || job_.isRunning(); }
  /// The folder that the files go to.
  void setFolder(const QString& folder);

  void reject() override;

 private:
  /// A thing that may be chosen, and why not.
  struct Choice {
    QCheckBox* box;
    QLabel* reason;
  };
  Choice addChoice(QVBoxLayout& column, const char* name, const QString& text, const QString& toolTip);
  static void offer(const Choice& choice, const QString& problem);
  void addKinds(QVBoxLayout& column);
  void addPlaces(QVBoxLayout& column);
  void addOutcome(QVBoxLayout& column);
  /// Whether each can be written now.
  void refresh();
  void enable();
  void chooseFolder();

  QString problemOfDicom() const;
  QString problemOfFocus() const;
  QString problemOfKeys() const;
  /// The slices as scanned that the key images show, ascending, each once.
  std::vector<int> keySlices() const;
  QString keyText() const;
  bool picturesPatient(const PictureMaker::Request& request) const;

  PictureMaker::Request pictureRequest() const;
  ResultsOrder order() const;
  void start(ResultsOrder order);
  void tell(const ResultsOutcome& outcome);

  Parts parts_;
  std::vector<PictureDialog::Choice> pictures_;
  PictureMaker maker_;
  LoadJob job_{archiveThreads()};
  ResultsOrder waiting_;  ///< until its picture is made
  bool isTold_ = false;   ///< the last run has said how it ended
  Choice measures_{}, labels_{}, focus_{}, picture_{}, keys_{}, folder_{}, archive_{};
  QCheckBox* commits_ = nullptr;
  QComboBox *views_ = nullptr, *servers_ = nullptr;
  QLineEdit *description_ = nullptr, *path_ = nullptr;
  QLabel* status_ = nullptr;
  QProgressBar* progress_ = nullptr;
  SentAnswers* answers_ = nullptr;
  QPushButton *save_ = nullptr, *browse_ = nullptr;
};

}  // namespace fenestra::viewer
