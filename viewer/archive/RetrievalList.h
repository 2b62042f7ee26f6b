#pragma once
// The retrievals as rows: what comes, how much of it is here, and buttons to pause, go on, try again and leave.

#include <QScrollArea>

class QLabel;
class QProgressBar;
class QToolButton;
class QVBoxLayout;

namespace fenestra::viewer {

class RetrievalRow;
class Retrievals;

class RetrievalList : public QScrollArea {
  Q_OBJECT
 public:
  /// `retrievals` outlives this.
  explicit RetrievalList(Retrievals& retrievals, QWidget* parent = nullptr);

  void setHidesPatient(bool hides);
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 Q_SIGNALS:
  /// What is whole is to be opened again.
  void openRequested(int id);

 private:
  void fill();
  void follow(int id);

  Retrievals& retrievals_;
  QVBoxLayout* column_;
  QList<RetrievalRow*> rows_;
  bool hidesPatient_ = false;
};

/// A row of the list.
class RetrievalRow : public QWidget {
  Q_OBJECT
 public:
  RetrievalRow(Retrievals& retrievals, int id, QWidget* parent = nullptr);

  int id() const { return id_; }
  /// Shows how it stands.
  void follow(bool hidesPatient);

 Q_SIGNALS:
  void openRequested(int id);

 private:
  void act();

  Retrievals& retrievals_;
  int id_;
  QLabel *title_, *state_;
  QProgressBar* progress_;
  QToolButton *act_, *remove_;
};

}  // namespace fenestra::viewer
