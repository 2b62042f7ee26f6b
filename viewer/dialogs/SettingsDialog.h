#pragma once
// What Fenestra remembers about its user: a row for each entry of preferenceTable(). Changes take effect at once.

#include <functional>
#include <vector>

#include <QDialog>

class QFormLayout;

namespace fenestra::viewer {

class Preferences;
struct PreferenceEntry;

class SettingsDialog : public QDialog {
  Q_OBJECT
 public:
  /// `preferences` outlives this.
  explicit SettingsDialog(Preferences& preferences, QWidget* parent = nullptr);

  /// A row below those of the table; the dialog owns its control.
  void addRow(const QString& name, QWidget* control);

 private:
  QWidget* controlFor(const PreferenceEntry& entry);

  Preferences& preferences_;
  QFormLayout* form_;
  std::vector<std::function<void()>> shows_;  ///< bring the controls up to date
};

}  // namespace fenestra::viewer
