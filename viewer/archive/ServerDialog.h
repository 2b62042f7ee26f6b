#pragma once
// Asks for an archive server: where it is, who we are to it, and how objects come.

#include <QDialog>

#include "viewer/archive/ServerEntry.h"

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QSpinBox;

namespace fenestra::viewer {

class ServerDialog : public QDialog {
  Q_OBJECT
 public:
  explicit ServerDialog(const ServerEntry& entry, QWidget* parent = nullptr);

  /// As the fields say.
  ServerEntry entry() const;

 protected:
  /// Says what is wrong instead, while something is.
  void accept() override;

 private:
  void addDicomRows();
  void addWebRows();
  void addTlsRows();
  QWidget* fileRow(QLineEdit*& field, const QString& title, const QString& toolTip);
  /// Only the fields that the kind of server has.
  void showRows();

  const ServerEntry before_;
  QFormLayout* form_;
  QComboBox *kind_, *login_, *way_;
  QCheckBox* keeps_;
  QLineEdit *name_, *host_, *title_, *ownTitle_, *interface_, *url_, *user_;
  QLineEdit *authorities_, *certificate_, *key_;
  QSpinBox *port_, *ownPort_;
  QWidget *authoritiesRow_, *certificateRow_, *keyRow_;
  QLabel* problem_;
};

/// The password or token of a server, typed by the user; empty when cancelled.
std::optional<QString> askForSecret(const ServerEntry& entry, QWidget* parent);

}  // namespace fenestra::viewer
