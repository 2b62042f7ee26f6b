#include "viewer/archive/CacheRow.h"

#include <QDir>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QMessageBox>
#include <QToolButton>
#include <QVBoxLayout>

#include "io/archive/Cache.h"
#include "viewer/archive/Retrievals.h"
#include "viewer/model/Paths.h"
#include "viewer/model/Preferences.h"
#include "viewer/panels/FileDialog.h"

namespace fenestra::viewer {
namespace {

constexpr int textWidth = 320;  // px; a longer path is shortened in its middle, and whole in the tool tip

}  // namespace

CacheRow::CacheRow(Archives& archives, const Retrievals& retrievals, QWidget* parent)
    : QWidget(parent), archives_(archives), retrievals_(retrievals) {
  text_ = new QLabel;
  text_->setObjectName(QStringLiteral("archiveCache"));
  text_->setTextFormat(Qt::PlainText);
  text_->setMinimumWidth(textWidth);
  auto* choose = new QToolButton;
  choose->setText(tr("Move…"));
  choose->setToolTip(tr("Chooses where objects are kept from now on; those of before stay where they are"));
  connect(choose, &QToolButton::clicked, this, [this] {
    if (const auto folder = askForFolder(this, {tr("Keep objects of archives in")})) this->choose(*folder);
  });
  clear_ = new QToolButton;
  clear_->setObjectName(QStringLiteral("archiveClear"));
  clear_->setText(tr("Clear"));
  clear_->setToolTip(tr("Removes all objects that were retrieved; not while some come in"));
  connect(clear_, &QToolButton::clicked, this, [this] {
    const QString question =
        tr("Remove all objects that were retrieved? The servers still have them, but sessions that refer to "
           "them find their data no more.");
    if (QMessageBox::question(this, tr("Clear"), question) == QMessageBox::Yes) clear();
  });
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(choose);
  buttons->addWidget(clear_);
  buttons->addStretch();
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(text_);
  column->addLayout(buttons);
  connect(&job_, &LoadJob::failed, text_, &QLabel::setText);
  connect(&retrievals_, &Retrievals::changed, this, [this] { clear_->setEnabled(!retrievals_.isBusy()); });
  clear_->setEnabled(!retrievals_.isBusy());
  measure();
}

void CacheRow::choose(const std::filesystem::path& folder) {
  constexpr const char* own = "fenestra-archive";
  archives_.preferences().setArchiveFolder(folder.filename() == own ? folder : folder / own);
  measure();
}

void CacheRow::clear() {
  if (retrievals_.isBusy()) return;
  text_->setText(tr("Clears…"));
  job_.start([this, root = archives_.cacheFolder()](const io::Progress&) -> LoadJob::Show {
    std::error_code unknown;
    if (std::filesystem::exists(root, unknown)) io::archive::Cache(root).clear();
    return [this] { measure(); };
  });
}

void CacheRow::measure() {
  text_->setText(tr("Counts…"));
  job_.start([this, root = archives_.cacheFolder()](const io::Progress&) -> LoadJob::Show {
    std::error_code unknown;
    // It is made with the first retrieval.
    const std::uint64_t bytes =
        std::filesystem::exists(root, unknown) ? io::archive::Cache(root).bytes() : std::uint64_t{0};
    return [this, bytes] { show(bytes); };
  });
}

void CacheRow::show(std::uint64_t bytes) {
  const QString size = QLocale().formattedDataSize(static_cast<qint64>(bytes), 1, QLocale::DataSizeSIFormat);
  const QString text = tr("%1 in %2").arg(size, QDir::toNativeSeparators(toQString(archives_.cacheFolder())));
  text_->setText(fontMetrics().elidedText(text, Qt::ElideMiddle, textWidth));
  text_->setToolTip(text);
}

}  // namespace fenestra::viewer
