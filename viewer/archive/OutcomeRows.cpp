#include "viewer/archive/OutcomeRows.h"

#include <QDialog>
#include <QDialogButtonBox>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

#include "viewer/archive/SentAnswers.h"

namespace fenestra::viewer {

OutcomeRows addOutcomeRows(QVBoxLayout& column, QDialog& dialog, const QString& start, const QString& name) {
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  const OutcomeRows rows{new QProgressBar, new QLabel, new SentAnswers,
                         buttons->addButton(start, QDialogButtonBox::ActionRole), buttons};
  rows.progress->setRange(0, 1000);
  rows.progress->setTextVisible(false);
  rows.progress->hide();
  rows.status->setObjectName(name + QStringLiteral("Status"));
  rows.status->setTextFormat(Qt::PlainText);
  rows.status->setWordWrap(true);
  rows.answers->setObjectName(name + QStringLiteral("Answers"));
  QObject::connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
  column.addWidget(rows.progress);
  column.addWidget(rows.status);
  column.addWidget(rows.answers, 1);
  column.addWidget(buttons);
  return rows;
}

}  // namespace fenestra::viewer
