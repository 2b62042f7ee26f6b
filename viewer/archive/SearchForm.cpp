#include "viewer/archive/SearchForm.h"

#include <algorithm>

#include <QComboBox>
#include <QDateEdit>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QInputDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QRegularExpression>
#include <QToolButton>

#include "viewer/model/Preferences.h"

namespace fenestra::viewer {
namespace {

bool hasWildcard(const QString& text) { return text.contains(QLatin1Char('*')) || text.contains(QLatin1Char('?')); }

QString dicomDate(const QDate& date) { return date.toString(QStringLiteral("yyyyMMdd")); }

QLineEdit* fieldOf(const char* name, const QString& toolTip) {
  auto* field = new QLineEdit;
  field->setObjectName(QLatin1String(name));
  field->setToolTip(toolTip);
  field->setClearButtonEnabled(true);
  constexpr int most = 64;  // characters of a name, an ID or a description (PS3.5 6.2)
  field->setMaxLength(most);
  return field;
}

}  // namespace

std::string nameKey(const QString& typed) {
  QString key = typed.simplified();
  if (key.isEmpty()) return {};
  static const QRegularExpression comma(QStringLiteral(" ?, ?"));
  key.replace(comma, QStringLiteral("^"));
  if (!hasWildcard(key)) key += QLatin1Char('*');
  return key.toStdString();
}

std::string descriptionKey(const QString& typed) {
  const QString key = typed.simplified();
  if (key.isEmpty() || hasWildcard(key)) return key.toStdString();
  return QStringLiteral("*%1*").arg(key).toStdString();
}

SearchForm::SearchForm(Preferences& preferences, QWidget* parent) : QWidget(parent), preferences_(preferences) {
  makeFields();
  makeDates();
  search_ = new QToolButton;
  search_->setObjectName(QStringLiteral("search"));
  search_->setText(tr("Search"));
  search_->setToolTip(tr("Asks the server for the studies that match. Empty fields match all (Return)"));
  connect(search_, &QToolButton::clicked, this, [this] { isSearching_ ? cancelRequested() : searchRequested(); });
  savedButton_ = new QToolButton;
  savedButton_->setText(tr("Saved searches"));
  savedButton_->setPopupMode(QToolButton::InstantPopup);
  savedMenu_ = new QMenu(savedButton_);
  savedButton_->setMenu(savedMenu_);
  savedButton_->setToolTip(tr("Searches under a name. A patient's name, ID and accession number are not saved"));
  connect(savedMenu_, &QMenu::aboutToShow, this, &SearchForm::fillSavedMenu);

  auto* form = new QFormLayout(this);
  form->setContentsMargins(0, 0, 0, 0);
  form->addRow(tr("Name"), name_);
  form->addRow(tr("ID"), id_);
  form->addRow(tr("Accession"), accession_);
  form->addRow(tr("Date"), dates_);
  form->addRow(QString(), range_);
  form->addRow(tr("Type"), type_);
  form->addRow(tr("Description"), description_);
  form->setRowVisible(range_, false);
  connect(dates_, &QComboBox::currentIndexChanged, form,
          [this, form](int index) { form->setRowVisible(range_, static_cast<Dates>(index) == Dates::Range); });
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(search_);
  buttons->addWidget(savedButton_);
  buttons->addStretch();
  form->addRow(buttons);
}

void SearchForm::makeFields() {
  const QString wildcards = tr("An asterisk stands for any text, a question mark for one character");
  name_ = fieldOf("patientName",
                  tr("Family name, or \"Doe, Jane\": all names that begin so. %1, as in *jane*").arg(wildcards));
  id_ = fieldOf("patientId", tr("The patient's ID as it is. %1, as in 47*").arg(wildcards));
  accession_ = fieldOf("accession", tr("The accession number as it is. %1, as in A2024*").arg(wildcards));
  description_ =
      fieldOf("description", tr("All descriptions of studies that hold this text. %1, as in head*").arg(wildcards));
  for (QLineEdit* each : {name_, id_, accession_, description_})
    connect(each, &QLineEdit::returnPressed, this, &SearchForm::searchRequested);
  type_ = new QComboBox;
  type_->setObjectName(QStringLiteral("modality"));
  type_->setToolTip(tr("The kind of images that the study holds"));
  type_->addItem(tr("Any"));
  for (const char* each : {"CT", "MR", "PT", "US", "XA", "MG", "CR", "DX", "NM", "SEG", "RTSTRUCT", "SR"})
    type_->addItem(tr(each), QLatin1String(each));
}

void SearchForm::makeDates() {
  dates_ = new QComboBox;
  dates_->setObjectName(QStringLiteral("dates"));
  dates_->setToolTip(tr("When the study was made"));
  // In the order of Dates.
  dates_->addItems(
      {tr("Any"), tr("Today"), tr("Last 7 days"), tr("Last 30 days"), tr("Last 365 days"), tr("From … to")});
  from_ = new QDateEdit(QDate::currentDate().addYears(-1));
  to_ = new QDateEdit(QDate::currentDate());
  range_ = new QWidget;
  auto* row = new QHBoxLayout(range_);
  row->setContentsMargins(0, 0, 0, 0);
  for (QDateEdit* each : {from_, to_}) {
    each->setCalendarPopup(true);
    each->setDisplayFormat(QStringLiteral("yyyy-MM-dd"));
    row->addWidget(each, 1);
  }
  from_->setToolTip(tr("First day"));
  to_->setToolTip(tr("Last day"));
}

std::string SearchForm::dateKey() const {
  const QDate today = QDate::currentDate();
  const auto since = [&](int days) { return (dicomDate(today.addDays(-days)) + QLatin1Char('-')).toStdString(); };
  switch (static_cast<Dates>(dates_->currentIndex())) {
    case Dates::Any:
      return {};
    case Dates::Today:
      return dicomDate(today).toStdString();
    case Dates::Week:
      return since(7);
    case Dates::Month:
      return since(30);
    case Dates::Year:
      return since(365);
    case Dates::Range:
      break;
  }
  const auto [first, last] = std::minmax(from_->date(), to_->date());
  return QStringLiteral("%1-%2").arg(dicomDate(first), dicomDate(last)).toStdString();
}

io::archive::Attributes SearchForm::keys() const {
  io::archive::Attributes keys{{"PatientName", nameKey(name_->text())},
                               {"PatientID", id_->text().trimmed().toStdString()},
                               {"AccessionNumber", accession_->text().trimmed().toStdString()},
                               {"StudyDate", dateKey()},
                               {"ModalitiesInStudy", type_->currentData().toString().toStdString()},
                               {"StudyDescription", descriptionKey(description_->text())}};
  std::erase_if(keys, [](const auto& key) { return key.second.empty(); });
  return keys;
}

void SearchForm::setHidesPatient(bool hides) {
  for (QLineEdit* each : {name_, id_, accession_, description_})
    each->setEchoMode(hides ? QLineEdit::Password : QLineEdit::Normal);
}

void SearchForm::setSearching(bool searching) {
  isSearching_ = searching;
  search_->setText(searching ? tr("Cancel") : tr("Search"));
}

QVariantMap SearchForm::saved() const {
  return {{QStringLiteral("dates"), dates_->currentIndex()},
          {QStringLiteral("from"), from_->date().toString(Qt::ISODate)},
          {QStringLiteral("to"), to_->date().toString(Qt::ISODate)},
          {QStringLiteral("type"), type_->currentData().toString()},
          {QStringLiteral("description"), description_->text()}};
}

void SearchForm::restore(const QVariantMap& search) {
  for (QLineEdit* each : {name_, id_, accession_}) each->clear();
  dates_->setCurrentIndex(std::clamp(search.value(QStringLiteral("dates")).toInt(), 0, dates_->count() - 1));
  const auto setDate = [&](QDateEdit* edit, const char* key) {
    const QDate date = QDate::fromString(search.value(QLatin1String(key)).toString(), Qt::ISODate);
    if (date.isValid()) edit->setDate(date);
  };
  setDate(from_, "from");
  setDate(to_, "to");
  type_->setCurrentIndex(std::max(0, type_->findData(search.value(QStringLiteral("type")))));
  description_->setText(search.value(QStringLiteral("description")).toString());
}

void SearchForm::save(const QString& name) {
  QVariantList all = preferences_.archiveSearches();
  all.removeIf([&](const QVariant& each) { return each.toMap().value(QStringLiteral("name")).toString() == name; });
  QVariantMap search = saved();
  search.insert(QStringLiteral("name"), name);
  all << search;
  preferences_.setArchiveSearches(all);
}

void SearchForm::fillSavedMenu() {
  savedMenu_->clear();
  const QVariantList all = preferences_.archiveSearches();
  for (const QVariant& each : all) {
    const QVariantMap search = each.toMap();
    connect(savedMenu_->addAction(search.value(QStringLiteral("name")).toString()), &QAction::triggered, this,
            [this, search] {
              restore(search);
              Q_EMIT searchRequested();
            });
  }
  if (!all.isEmpty()) savedMenu_->addSeparator();
  connect(savedMenu_->addAction(tr("Save this search…")), &QAction::triggered, this, [this] {
    bool accepted = false;
    const QString name =
        QInputDialog::getText(this, tr("Save this search"),
                              tr("Its name (date, type and description are saved, nothing of a patient):"),
                              QLineEdit::Normal, {}, &accepted)
            .simplified();
    if (accepted && !name.isEmpty()) save(name);
  });
  if (all.isEmpty()) return;
  QMenu* forget = savedMenu_->addMenu(tr("Forget"));
  for (const QVariant& each : all)
    connect(forget->addAction(each.toMap().value(QStringLiteral("name")).toString()), &QAction::triggered, this,
            [this, each] {
              QVariantList rest = preferences_.archiveSearches();
              rest.removeAll(each);
              preferences_.setArchiveSearches(rest);
            });
}

}  // namespace fenestra::viewer
