#include "viewer/archive/SentAnswers.h"

#include <algorithm>

#include <QHeaderView>

namespace fenestra::viewer {

SentAnswers::SentAnswers(QWidget* parent) : QTreeWidget(parent) {
  setRootIsDecorated(false);
  setUniformRowHeights(true);
  setHeaderLabels({tr("Object"), tr("Answer of the server")});
  header()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
}

void SentAnswers::fill(const QStringList& names, const std::vector<io::archive::Sent>& sent,
                       const Commitments& commitments) {
  using Verdict = io::archive::Commitment::Verdict;
  QList<QTreeWidgetItem*> rows;
  for (std::size_t i = 0; i < sent.size(); ++i) {
    const QString text = QString::fromStdString(sent[i].text);
    const QString verdict = sent[i].accepted ? tr("accepted") : tr("refused");
    rows << new QTreeWidgetItem({names.value(static_cast<qsizetype>(i)),
                                 text.isEmpty() ? verdict : QStringLiteral("%1: %2").arg(verdict, text)});
    const auto commitment = commitments.find(sent[i].object);
    if (commitment == commitments.end()) continue;
    const auto& [said, why] = commitment->second;
    const QString kept = said == Verdict::Kept      ? tr("kept")
                         : said == Verdict::NotKept ? tr("not kept: %1").arg(QString::fromStdString(why))
                                                    : tr("not confirmed to be kept");
    rows.back()->setText(1, QStringLiteral("%1, %2").arg(rows.back()->text(1), kept));
  }
  addTopLevelItems(rows);
}

QString SentAnswers::summaryOf(const std::vector<io::archive::Sent>& sent) {
  const auto accepted = std::count_if(sent.begin(), sent.end(), [](const auto& each) { return each.accepted; });
  return tr("Accepted: %1 of %2.").arg(accepted).arg(sent.size());
}

QString SentAnswers::summaryOf(const std::vector<io::archive::Sent>& sent, const Commitments& commitments) {
  const auto kept = std::count_if(sent.begin(), sent.end(), [&](const auto& each) {
    const auto at = commitments.find(each.object);
    return at != commitments.end() && at->second.verdict == io::archive::Commitment::Verdict::Kept;
  });
  return tr("Confirmed to be kept: %1 of %2.").arg(kept).arg(sent.size());
}

}  // namespace fenestra::viewer
