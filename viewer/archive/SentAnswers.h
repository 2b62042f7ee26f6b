#pragma once
// What an archive server answered to each object that was sent, as rows.

#include <QTreeWidget>

#include "io/archive/Send.h"

namespace fenestra::viewer {

class SentAnswers : public QTreeWidget {
  Q_OBJECT
 public:
  explicit SentAnswers(QWidget* parent = nullptr);

  /// `names` are those of the objects, as many as `sent`; never the names of files, which may name the patient.
  void fill(const QStringList& names, const std::vector<io::archive::Sent>& sent);
  /// "Accepted: 3 of 4."
  static QString summaryOf(const std::vector<io::archive::Sent>& sent);
};

}  // namespace fenestra::viewer
