#pragma once
// What an archive server answered to each object that was sent, as rows.

#include <map>
#include <string>
#include <vector>

#include <QTreeWidget>

#include "io/archive/Commitment.h"
#include "io/archive/Send.h"

namespace fenestra::viewer {

class SentAnswers : public QTreeWidget {
  Q_OBJECT
 public:
  explicit SentAnswers(QWidget* parent = nullptr);

  using Commitments = std::map<std::string, io::archive::Commitment>;  ///< by SOP Instance UID; empty: not asked for

  /// `names` are those of the objects, as many as `sent`; never the names of files, which may name the patient.
  void fill(const QStringList& names, const std::vector<io::archive::Sent>& sent, const Commitments& commitments = {});
  /// "Accepted: 3 of 4."
  static QString summaryOf(const std::vector<io::archive::Sent>& sent);
  /// "Confirmed to be kept: 3 of 4."
  static QString summaryOf(const std::vector<io::archive::Sent>& sent, const Commitments& commitments);
};

}  // namespace fenestra::viewer
