#include "viewer/archive/ServerDialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QInputDialog>
#include <QLabel>
#include <QLineEdit>
#include <QSpinBox>
#include <QToolButton>

#include "viewer/model/Paths.h"
#include "viewer/panels/FileDialog.h"

namespace fenestra::viewer {
namespace {

QLineEdit* lineOf(const QString& text, const char* name, const QString& toolTip) {
  auto* line = new QLineEdit(text);
  line->setObjectName(QLatin1String(name));
  line->setToolTip(toolTip);
  return line;
}

QSpinBox* portBox(int port, const char* name, const QString& toolTip) {
  auto* box = new QSpinBox;
  box->setObjectName(QLatin1String(name));
  box->setRange(1, 65535);
  box->setValue(port);
  box->setToolTip(toolTip);
  return box;
}

}  // namespace

ServerDialog::ServerDialog(const ServerEntry& entry, QWidget* parent) : QDialog(parent), before_(entry) {
  setWindowTitle(tr("Archive server"));
  form_ = new QFormLayout(this);
  name_ = lineOf(entry.name, "serverName", tr("As you call it"));
  kind_ = new QComboBox;
  kind_->setObjectName(QStringLiteral("serverKind"));
  kind_->addItems({tr("DICOM"), tr("DICOM over TLS"), tr("DICOMweb")});  // in the order of Kind
  kind_->setCurrentIndex(static_cast<int>(entry.kind));
  kind_->setToolTip(tr("What the server speaks; its administrator knows"));
  form_->addRow(tr("Name"), name_);
  form_->addRow(tr("Speaks"), kind_);
  addDicomRows();
  addWebRows();
  addTlsRows();
  problem_ = new QLabel;
  problem_->setObjectName(QStringLiteral("serverProblem"));
  problem_->setWordWrap(true);
  form_->addRow(problem_);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
  connect(buttons, &QDialogButtonBox::accepted, this, &ServerDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  form_->addRow(buttons);
  for (QComboBox* each : {kind_, login_, way_})
    connect(each, &QComboBox::currentIndexChanged, this, &ServerDialog::showRows);
  connect(kind_, &QComboBox::currentIndexChanged, this, [this](int kind) {
    // The well-known ports (PS3.8 9.1.1), unless the user has set another.
    constexpr int plain = 104, secure = 2762;
    const bool isSecure = static_cast<ServerEntry::Kind>(kind) == ServerEntry::Kind::DicomTls;
    if (port_->value() == (isSecure ? plain : secure)) port_->setValue(isSecure ? secure : plain);
  });
  showRows();
}

void ServerDialog::addDicomRows() {
  host_ = lineOf(before_.host, "serverHost", tr("Its name or address in the network"));
  host_->setPlaceholderText(QStringLiteral("192.168.1.5"));
  port_ = portBox(before_.port, "serverPort", tr("The port that it listens on"));
  title_ = lineOf(before_.title, "serverTitle", tr("Its AE title, at most 16 letters and digits"));
  ownTitle_ = lineOf(before_.ownTitle, "ownTitle", tr("Our AE title: its administrator enters it at the server"));
  way_ = new QComboBox;
  way_->setObjectName(QStringLiteral("serverWay"));
  way_->addItem(tr("C-GET, over our connection"));
  way_->addItem(tr("C-MOVE, the server connects to us"));
  way_->setCurrentIndex(before_.moves ? 1 : 0);
  way_->setToolTip(
      tr("How objects come. C-GET needs nothing more; with C-MOVE our address and port are entered at the "
         "server, and the port is open while objects come"));
  interface_ = lineOf(
      before_.interface, "ownAddress",
      tr("Address of this machine that the server sends to: objects by C-MOVE, and whether it keeps what it was sent"));
  ownPort_ = portBox(before_.ownPort, "ownPort",
                     tr("Port of this machine that the server sends to; it is open while that is waited for"));
  form_->addRow(tr("Host"), host_);
  form_->addRow(tr("Port"), port_);
  form_->addRow(tr("Its AE title"), title_);
  form_->addRow(tr("Our AE title"), ownTitle_);
  form_->addRow(tr("Retrieve by"), way_);
  form_->addRow(tr("Our address"), interface_);
  form_->addRow(tr("Our port"), ownPort_);
}

void ServerDialog::addWebRows() {
  url_ = lineOf(before_.url, "serverUrl", tr("The address of DICOMweb's root. A login goes out over https alone"));
  url_->setPlaceholderText(QStringLiteral("https://…"));
  login_ = new QComboBox;
  login_->setObjectName(QStringLiteral("serverLogin"));
  login_->addItems({tr("None"), tr("User and password"), tr("Token")});  // in the order of Login
  login_->setCurrentIndex(static_cast<int>(before_.login));
  login_->setToolTip(tr("The password or token is asked for when it is needed"));
  keeps_ = new QCheckBox(tr("Keep the password or token in the key ring"));
  keeps_->setObjectName(QStringLiteral("serverKeeps"));
  keeps_->setChecked(before_.keepsSecret);
  keeps_->setToolTip(
      tr("The password or token is kept where the desktop keeps those of other programs, encrypted, and nowhere else. "
         "Otherwise it is forgotten when the program ends"));
  user_ = lineOf(before_.user, "serverUser", tr("Who you are to the server"));
  form_->addRow(tr("Address"), url_);
  form_->addRow(tr("Login"), login_);
  form_->addRow(tr("User"), user_);
  form_->addRow(keeps_);
}

void ServerDialog::addTlsRows() {
  authoritiesRow_ = fileRow(authorities_, tr("Certificates that may sign the server's"),
                            tr("Certificates in PEM that may sign the server's, or its own"));
  authorities_->setText(before_.authorities);
  certificateRow_ = fileRow(certificate_, tr("Our certificate"), tr("In PEM, where the server asks for one"));
  certificate_->setText(before_.certificate);
  keyRow_ = fileRow(key_, tr("The key of our certificate"), tr("In PEM, without a passphrase"));
  key_->setText(before_.key);
  form_->addRow(tr("Trusted certificates"), authoritiesRow_);
  form_->addRow(tr("Our certificate"), certificateRow_);
  form_->addRow(tr("Its key"), keyRow_);
}

QWidget* ServerDialog::fileRow(QLineEdit*& field, const QString& title, const QString& toolTip) {
  auto* row = new QWidget;
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  field = lineOf({}, "", toolTip);
  auto* browse = new QToolButton;
  browse->setText(QStringLiteral("…"));
  browse->setToolTip(tr("Choose the file"));
  connect(browse, &QToolButton::clicked, this, [this, line = field, title] {
    const QString kinds = tr("Certificates and keys (*.pem *.crt *.cer *.key);;All files (*)");
    if (const auto file = askForFile(this, {title, kinds})) line->setText(toQString(*file));
  });
  layout->addWidget(field, 1);
  layout->addWidget(browse);
  return row;
}

void ServerDialog::showRows() {
  const auto kind = static_cast<ServerEntry::Kind>(kind_->currentIndex());
  const bool isWeb = kind == ServerEntry::Kind::Web, isTls = kind == ServerEntry::Kind::DicomTls;
  for (QWidget* each : {static_cast<QWidget*>(host_), static_cast<QWidget*>(port_), static_cast<QWidget*>(title_),
                        static_cast<QWidget*>(ownTitle_), static_cast<QWidget*>(way_),
                        static_cast<QWidget*>(interface_), static_cast<QWidget*>(ownPort_)})
    form_->setRowVisible(each, !isWeb);
  form_->setRowVisible(url_, isWeb);
  form_->setRowVisible(login_, isWeb);
  form_->setRowVisible(
      user_, isWeb && static_cast<ServerEntry::Login>(login_->currentIndex()) == ServerEntry::Login::Password);
  form_->setRowVisible(keeps_,
                       isWeb && static_cast<ServerEntry::Login>(login_->currentIndex()) != ServerEntry::Login::None);
  form_->setRowVisible(authoritiesRow_, isWeb || isTls);
  form_->setRowVisible(certificateRow_, isTls);
  form_->setRowVisible(keyRow_, isTls);
  problem_->clear();
  adjustSize();
}

ServerEntry ServerDialog::entry() const {
  ServerEntry entry = before_;
  entry.kind = static_cast<ServerEntry::Kind>(kind_->currentIndex());
  entry.host = host_->text().trimmed();
  entry.port = port_->value();
  entry.title = title_->text().trimmed();
  entry.ownTitle = ownTitle_->text().trimmed();
  entry.moves = entry.kind != ServerEntry::Kind::Web && way_->currentIndex() == 1;
  entry.interface = interface_->text().trimmed();
  entry.ownPort = ownPort_->value();
  entry.url = url_->text().trimmed();
  entry.login = static_cast<ServerEntry::Login>(login_->currentIndex());
  entry.user = user_->text().trimmed();
  entry.keepsSecret =
      entry.kind == ServerEntry::Kind::Web && entry.login != ServerEntry::Login::None && keeps_->isChecked();
  entry.authorities = authorities_->text().trimmed();
  entry.certificate = certificate_->text().trimmed();
  entry.key = key_->text().trimmed();
  entry.name = name_->text().simplified();
  if (entry.name.isEmpty()) entry.name = entry.kind == ServerEntry::Kind::Web ? entry.url : entry.title;
  return entry;
}

void ServerDialog::accept() {
  const QString problem = problemOf(entry());
  problem_->setText(problem);
  adjustSize();
  if (problem.isEmpty()) QDialog::accept();
}

std::optional<QString> askForSecret(const ServerEntry& entry, QWidget* parent) {
  const bool isToken = entry.login == ServerEntry::Login::Token;
  const QString question = isToken ? ServerDialog::tr("Token for %1:").arg(entry.name)
                                   : ServerDialog::tr("Password of %1 for %2:").arg(entry.user, entry.name);
  bool accepted = false;
  const QString text = QInputDialog::getText(parent, ServerDialog::tr("Login"), question, QLineEdit::Password, {},
                                             &accepted, {}, Qt::ImhHiddenText | Qt::ImhSensitiveData);
  return accepted ? std::optional(text) : std::nullopt;
}

}  // namespace fenestra::viewer
