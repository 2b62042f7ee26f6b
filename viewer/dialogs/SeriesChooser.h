#pragma once
// The series of a study in a list, with small pictures that appear as they are made.

#include <optional>
#include <string>

#include <QDialog>
#include <QTreeWidget>

#include "viewer/jobs/Thumbnails.h"
#include "viewer/model/Document.h"

namespace fenestra::viewer {

class SeriesChooser : public QDialog {
  Q_OBJECT
 public:
  enum Column { Picture, Patient, Number, Type, Date, Description, Part, Thickness, Kernel, Size, Images, Columns };

  /// With hidden names, patients are told apart by numbers, and only where there are several.
  explicit SeriesChooser(const io::Study& study, bool hidesPatient = false, QWidget* parent = nullptr);

  QTreeWidget* list() const { return list_; }
  /// The id of the series that is selected; empty when it is the one that is open.
  std::optional<std::string> chosen() const;

 private:
  std::string open_;
  QTreeWidget* list_;
  Thumbnails* thumbnails_;
};

}  // namespace fenestra::viewer
