#include "viewer/archive/ArchiveModel.h"

#include <algorithm>
#include <charconv>
#include <map>

#include <QMimeData>

#include "viewer/model/PatientLines.h"

namespace fenestra::viewer {
namespace {

using Kind = ArchiveNode::Kind;

/// As PatientLines.h has it, with the groups of other writings (PS3.5 6.2.1.2) behind the first: "Yamada, Tarou (山田,
/// 太郎)".
QString personText(const std::string& name) {
  QStringList groups;
  for (const QString& group : QString::fromStdString(name).split(QLatin1Char('=')).mid(0, 2))
    if (const QString text = patientTitle({.name = group.toStdString(), .id = {}, .sex = {}, .birthDate = {}});
        !text.isEmpty())
      groups << text;
  if (groups.size() < 2) return groups.value(0);
  return QStringLiteral("%1 (%2)").arg(groups[0], groups[1]);
}

QString textAt(const ArchiveNode& node, const char* keyword) {
  return QString::fromStdString(node.value(keyword)).simplified();
}

int numberOf(const io::archive::Attributes& record, const char* keyword) {
  const std::string text = io::archive::valueOf(record, keyword);
  int number = 0;
  std::from_chars(text.data(), text.data() + text.size(), number);
  return number;
}

/// Several kinds stand between backslashes.
QString kindsOf(const ArchiveNode& node) {
  return textAt(node, node.kind == Kind::Series ? "Modality" : "ModalitiesInStudy")
      .replace(QLatin1Char('\\'), QStringLiteral(", "));
}

}  // namespace

const char* const ArchiveModel::dragType = "application/x-fenestra-archive";

ArchiveNode& ArchiveNode::add(Kind childKind, const io::archive::Attributes& childRecord) {
  children.push_back(std::make_unique<ArchiveNode>());
  ArchiveNode& child = *children.back();
  child.kind = childKind;
  child.record = childRecord;
  child.parent = this;
  child.row = static_cast<int>(children.size()) - 1;
  return child;
}

std::shared_ptr<ArchiveNode> treeOfStudies(const std::vector<io::archive::Attributes>& studies) {
  using io::archive::valueOf;
  // An ID alone may be another patient's elsewhere.
  std::map<std::vector<std::string>, std::vector<const io::archive::Attributes*>> byPatient;
  for (const io::archive::Attributes& study : studies)
    if (!valueOf(study, "StudyInstanceUID").empty())
      byPatient[{valueOf(study, "PatientName"), valueOf(study, "PatientID"), valueOf(study, "IssuerOfPatientID")}]
          .push_back(&study);
  auto root = std::make_shared<ArchiveNode>();
  for (auto& [patient, list] : byPatient) {
    std::stable_sort(list.begin(), list.end(), [](const auto* a, const auto* b) {
      return valueOf(*a, "StudyDate") + valueOf(*a, "StudyTime") > valueOf(*b, "StudyDate") + valueOf(*b, "StudyTime");
    });
    ArchiveNode& node = root->add(Kind::Patient, *list.front());
    for (const io::archive::Attributes* study : list) node.add(Kind::Study, *study);
  }
  return root;
}

void ArchiveModel::setTree(std::shared_ptr<ArchiveNode> tree) {
  beginResetModel();
  root_ = std::move(tree);
  endResetModel();
}

void ArchiveModel::setHidesPatient(bool hides) {
  if (hidesPatient_ == hides) return;
  hidesPatient_ = hides;
  Q_EMIT layoutAboutToBeChanged();
  Q_EMIT layoutChanged();
}

ArchiveNode* ArchiveModel::node(const QModelIndex& index) const {
  return index.isValid() ? static_cast<ArchiveNode*>(index.internalPointer()) : root_.get();
}

const ArchiveNode* ArchiveModel::nodeAt(const QModelIndex& index) const {
  return index.isValid() ? node(index) : nullptr;
}

QModelIndex ArchiveModel::indexOf(const ArchiveNode& of) const {
  return of.parent ? createIndex(of.row, 0, const_cast<ArchiveNode*>(&of)) : QModelIndex();
}

ArchiveNode* ArchiveModel::findStudy(const std::string& study) const {
  for (const auto& patient : root_->children)
    for (const auto& each : patient->children)
      if (each->value("StudyInstanceUID") == study) return each.get();
  return nullptr;
}

void ArchiveModel::setSeries(const std::string& study, std::vector<io::archive::Attributes> series) {
  ArchiveNode* of = findStudy(study);
  if (!of || !of->children.empty()) return;
  of->isFetched = true;
  std::stable_sort(series.begin(), series.end(), [](const auto& a, const auto& b) {
    return numberOf(a, "SeriesNumber") < numberOf(b, "SeriesNumber");
  });
  const QModelIndex at = indexOf(*of);
  if (series.empty()) {
    Q_EMIT dataChanged(at, at);  // there is nothing to unfold
    return;
  }
  beginInsertRows(at, 0, static_cast<int>(series.size()) - 1);
  for (const io::archive::Attributes& each : series) of->add(Kind::Series, each);
  endInsertRows();
}

void ArchiveModel::forgetFetch(const std::string& study) {
  if (ArchiveNode* of = findStudy(study); of && of->children.empty()) of->isFetched = false;
}

void ArchiveModel::showPicture(const std::string& series) {
  for (const auto& patient : root_->children)
    for (const auto& study : patient->children)
      for (const auto& each : study->children)
        if (each->value("SeriesInstanceUID") == series)
          Q_EMIT dataChanged(indexOf(*each), indexOf(*each), {Qt::DecorationRole});
}

QModelIndex ArchiveModel::index(int row, int column, const QModelIndex& parent) const {
  const ArchiveNode& of = *node(parent);
  if (row < 0 || column < 0 || column >= ColumnCount || row >= static_cast<int>(of.children.size())) return {};
  return createIndex(row, column, of.children[static_cast<std::size_t>(row)].get());
}

QModelIndex ArchiveModel::parent(const QModelIndex& child) const {
  return child.isValid() ? indexOf(*node(child)->parent) : QModelIndex();
}

int ArchiveModel::rowCount(const QModelIndex& parent) const {
  return parent.column() > 0 ? 0 : static_cast<int>(node(parent)->children.size());
}

int ArchiveModel::columnCount(const QModelIndex&) const { return ColumnCount; }

bool ArchiveModel::hasChildren(const QModelIndex& parent) const {
  return !node(parent)->children.empty() || canFetchMore(parent);
}

bool ArchiveModel::canFetchMore(const QModelIndex& parent) const {
  const ArchiveNode& of = *node(parent);
  return of.kind == Kind::Study && !of.isFetched;
}

void ArchiveModel::fetchMore(const QModelIndex& parent) {
  if (!canFetchMore(parent)) return;
  node(parent)->isFetched = true;
  Q_EMIT seriesWanted(QString::fromStdString(node(parent)->value("StudyInstanceUID")));
}

QString ArchiveModel::nameOf(const ArchiveNode& of, bool hidesPatient) {
  if (of.kind == Kind::Patient) {
    if (hidesPatient) return tr("Patient %1").arg(of.row + 1);
    const QString name = personText(of.value("PatientName")), id = textAt(of, "PatientID");
    if (name.isEmpty()) return id.isEmpty() ? tr("No name") : id;
    return id.isEmpty() ? name : QStringLiteral("%1 · %2").arg(name, id);
  }
  // A description may hold anything that was typed.
  if (of.kind == Kind::Study) {
    const QString text = hidesPatient ? QString() : textAt(of, "StudyDescription");
    return text.isEmpty() ? tr("Study %1").arg(of.row + 1) : text;
  }
  const QString text = hidesPatient ? QString() : textAt(of, "SeriesDescription"), number = textAt(of, "SeriesNumber");
  if (text.isEmpty()) return tr("Series %1").arg(number.isEmpty() ? QString::number(of.row + 1) : number);
  return number.isEmpty() ? text : QStringLiteral("%1: %2").arg(number, text);
}

QString ArchiveModel::titleOf(const ArchiveNode& of) {
  QStringList parts;
  for (const ArchiveNode* each = &of; each && each->kind != Kind::Root; each = each->parent)
    parts.prepend(nameOf(*each, false));
  return parts.join(QStringLiteral(" · "));
}

QString ArchiveModel::toolTipOf(const ArchiveNode& of) const {
  if (hidesPatient_) return {};
  QStringList lines{nameOf(of, false)};
  const auto add = [&](const QString& line, const QString& value) {
    if (!value.isEmpty()) lines << line.arg(value);
  };
  if (of.kind == Kind::Patient) {
    add(tr("Born %1"), dateText(of.value("PatientBirthDate")));
    add(tr("Sex %1"), textAt(of, "PatientSex"));
  }
  if (of.kind == Kind::Study) {
    add(tr("Accession number %1"), textAt(of, "AccessionNumber"));
    add(tr("Study ID %1"), textAt(of, "StudyID"));
  }
  if (of.kind == Kind::Series) {
    add(tr("Part of the body: %1"), textAt(of, "BodyPartExamined"));
    add(tr("Protocol: %1"), textAt(of, "ProtocolName"));
  }
  return lines.join(QLatin1Char('\n'));
}

QVariant ArchiveModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const ArchiveNode& of = *node(index);
  if (role == Qt::ToolTipRole) return toolTipOf(of);
  if (role == Qt::DecorationRole && index.column() == Name && of.kind == Kind::Series && pictureOf_) {
    const QPixmap picture = pictureOf_(of, hidesPatient_);
    return picture.isNull() ? QVariant() : QVariant(picture);
  }
  if (role == Qt::TextAlignmentRole && index.column() == Images) return int(Qt::AlignRight | Qt::AlignVCenter);
  if (role != Qt::DisplayRole) return {};
  if (index.column() == Name) return nameOf(of, hidesPatient_);
  if (of.kind == Kind::Patient) return {};
  const bool isSeries = of.kind == Kind::Series;
  if (index.column() == Type) return kindsOf(of);
  if (index.column() == Images)
    return textAt(of, isSeries ? "NumberOfSeriesRelatedInstances" : "NumberOfStudyRelatedInstances");
  if (hidesPatient_) return {};
  return dateText(of.value(isSeries ? "SeriesDate" : "StudyDate"));
}

QVariant ArchiveModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  switch (section) {
    case Name:
      return tr("Patient, study");
    case Date:
      return tr("Date");
    case Type:
      return tr("Type");
    case Images:
      return tr("Images");
    default:
      return {};
  }
}

Qt::ItemFlags ArchiveModel::flags(const QModelIndex& index) const {
  const Qt::ItemFlags flags = QAbstractItemModel::flags(index);
  const ArchiveNode* of = nodeAt(index);
  return of && of->kind != Kind::Patient ? flags | Qt::ItemIsDragEnabled : flags;
}

QStringList ArchiveModel::mimeTypes() const { return {QLatin1String(dragType)}; }

QMimeData* ArchiveModel::mimeData(const QModelIndexList&) const {
  // Another program could read it: nothing of the patient is in it.
  auto* data = new QMimeData;
  data->setData(QLatin1String(dragType), "1");
  return data;
}

}  // namespace fenestra::viewer
