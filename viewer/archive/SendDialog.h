#pragma once
// Sends the open series and its labels to an archive server, and shows the server's answer to each object.

#include <vector>

#include <QDialog>

#include "io/archive/Send.h"
#include "viewer/archive/Archives.h"
#include "viewer/archive/SentAnswers.h"
#include "viewer/jobs/LoadJob.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;

namespace fenestra::viewer {

class Document;

class SendDialog : public QDialog {
  Q_OBJECT
 public:
  /// Both outlive this.
  SendDialog(Archives& archives, const Document& document, QWidget* parent = nullptr);

  /// Why nothing of a study can be sent; empty: something can.
  static QString problemOf(const Document& document);

  void send();
  bool isBusy() const { return job_.isRunning(); }

 private:
  void addChoices(class QFormLayout& form);
  /// What became of the objects; without commitments, `problem` says why there are none.
  struct Outcome {
    std::vector<io::archive::Sent> sent;
    SentAnswers::Commitments commitments;
    bool isCommitmentAsked = false;
    QString problem;
  };
  void show(const Outcome& outcome, std::size_t images);
  void enable();

  Archives& archives_;
  const Document& document_;
  LoadJob job_{archiveThreads()};
  QComboBox* servers_;
  QCheckBox *series_, *labels_, *commits_;
  QLabel* status_;
  QProgressBar* progress_;
  SentAnswers* answers_;
  QPushButton* send_;
};

}  // namespace fenestra::viewer
