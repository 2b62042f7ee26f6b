#include "viewer/WelcomePage.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "viewer/FileOpener.h"
#include "viewer/style/Style.h"

namespace fenestra::viewer {

WelcomePage::WelcomePage(FileOpener& files, QWidget* parent) : QFrame(parent) {
  setObjectName(QStringLiteral("welcome"));
  auto* title = new QLabel(QStringLiteral("Fenestra"));
  QFont large = title->font();
  large.setPointSizeF(large.pointSizeF() * 2.2);
  title->setFont(large);
  auto* text = new QLabel(tr("Drop a DICOM folder, NIfTI, NRRD or MetaImage file here."));
  auto* folder = new QPushButton(icon("folder"), tr("Open a folder…"));
  auto* file = new QPushButton(icon("file"), tr("Open a file…"));
  connect(folder, &QPushButton::clicked, &files, &FileOpener::chooseFolder);
  connect(file, &QPushButton::clicked, &files, &FileOpener::chooseFile);
  auto* buttons = new QHBoxLayout;
  buttons->addStretch();
  buttons->addWidget(folder);
  buttons->addWidget(file);
  buttons->addStretch();
  auto* column = new QVBoxLayout(this);
  column->setSpacing(16);
  column->addStretch();
  column->addWidget(title, 0, Qt::AlignHCenter);
  column->addWidget(text, 0, Qt::AlignHCenter);
  column->addLayout(buttons);
  column->addStretch();
}

}  // namespace fenestra::viewer
