#include "viewer/bars/LoadingBar.h"

#include <utility>

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>

#include "viewer/jobs/LoadJob.h"

namespace fenestra::viewer {

LoadingBar::LoadingBar(LoadJob& job, const QString& title, std::function<void()> cancel, QWidget* parent)
    : QWidget(parent) {
  auto* text = new QLabel;
  auto* progress = new QProgressBar;
  progress->setRange(0, 100);
  progress->setTextVisible(false);
  progress->setMinimumWidth(60);
  auto* button = new QPushButton(tr("Cancel"));
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(10, 5, 6, 5);
  row->addWidget(text, 1);
  row->addWidget(progress, 2);
  row->addWidget(button);
  text->setText(title);
  setVisible(job.isRunning());

  if (cancel)
    connect(button, &QPushButton::clicked, this, std::move(cancel));
  else
    connect(button, &QPushButton::clicked, &job, &LoadJob::cancel);
  connect(&job, &LoadJob::started, this, [this, text, progress, title] {
    text->setText(title);
    progress->setValue(0);
    show();
  });
  connect(&job, &LoadJob::progressed, this, [text, progress](double fraction, const QString& doing) {
    if (!doing.isEmpty()) text->setText(doing);
    progress->setValue(static_cast<int>(100.0 * fraction));
  });
  connect(&job, &LoadJob::ended, this, [this, &job] { setVisible(job.isRunning()); });
}

}  // namespace fenestra::viewer
