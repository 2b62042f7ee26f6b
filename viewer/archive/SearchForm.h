#pragma once
// What to search an archive for. Searches can be saved under a name; a patient's name, ID and accession number are not
// saved with them.

#include <QVariantMap>
#include <QWidget>

#include "io/archive/Records.h"

class QComboBox;
class QDateEdit;
class QLineEdit;
class QMenu;
class QToolButton;

namespace fenestra::viewer {

class Preferences;

class SearchForm : public QWidget {
  Q_OBJECT
 public:
  /// `preferences` outlives this.
  explicit SearchForm(Preferences& preferences, QWidget* parent = nullptr);

  /// The keys of a search for studies.
  io::archive::Attributes keys() const;
  /// What was typed of the patient is masked.
  void setHidesPatient(bool hides);
  /// While a search runs, its button cancels.
  void setSearching(bool searching);

  /// What a saved search holds.
  QVariantMap saved() const;
  void restore(const QVariantMap& search);
  /// Replaces the search of that name.
  void save(const QString& name);

 Q_SIGNALS:
  void searchRequested();
  void cancelRequested();

 private:
  enum class Dates : int { Any, Today, Week, Month, Year, Range };

  void makeFields();
  void makeDates();
  void fillSavedMenu();
  std::string dateKey() const;

  Preferences& preferences_;
  QLineEdit *name_, *id_, *accession_, *description_;
  QComboBox *type_, *dates_;
  QDateEdit *from_, *to_;
  QWidget* range_;
  QToolButton *search_, *savedButton_;
  QMenu* savedMenu_;
  bool isSearching_ = false;
};

/// A key of DICOM for a name as users type it: "Smith, Anna" is "Smith^Anna*". Names and descriptions that hold no
/// wildcard match whatever begins with a name, and whatever holds a description.
std::string nameKey(const QString& typed);
std::string descriptionKey(const QString& typed);

}  // namespace fenestra::viewer
