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

void SentAnswers::fill(const QStringList& names, const std::vector<io::archive::Sent>& sent) {
  QList<QTreeWidgetItem*> rows;
  for (std::size_t i = 0; i < sent.size(); ++i) {
    const QString text = QString::fromStdString(sent[i].text);
    const QString verdict = sent[i].accepted ? tr("accepted") : tr("refused");
    rows << new QTreeWidgetItem({names.value(static_cast<qsizetype>(i)),
                                 text.isEmpty() ? verdict : QStringLiteral("%1: %2").arg(verdict, text)});
  }
  addTopLevelItems(rows);
}

QString SentAnswers::summaryOf(const std::vector<io::archive::Sent>& sent) {
  const auto accepted = std::count_if(sent.begin(), sent.end(), [](const auto& each) { return each.accepted; });
  return tr("Accepted: %1 of %2.").arg(accepted).arg(sent.size());
}

}  // namespace fenestra::viewer
