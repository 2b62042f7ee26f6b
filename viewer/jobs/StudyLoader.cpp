#include "viewer/jobs/StudyLoader.h"

#include <QTimer>

#include "io/LabelReader.h"

namespace fenestra::viewer {

StudyLoader::StudyLoader(Document& document, Prepare prepare, QObject* parent)
    : QObject(parent), document_(document), prepare_(std::move(prepare)) {}

void StudyLoader::open(Reader read, Missing missing, Unsized unsized) {
  job_.start([this, read = std::move(read), missing = std::move(missing),
              unsized = std::move(unsized)](const io::Progress& progress) -> LoadJob::Show {
    try {
      // A shared pointer, because std::function needs a copyable capture.
      auto study = std::make_shared<io::Study>(read(progress));
      if (prepare_) prepare_(*study);
      return [this, study] {
        document_.open(std::move(*study));
        Q_EMIT opened();
      };
    } catch (const io::DataMissing& error) {
      if (!missing) throw;
      // A dialog shown from here would keep the job from ending, so it is shown from the event loop.
      return [this, missing, error] { QTimer::singleShot(0, this, [missing, error] { missing(error); }); };
    } catch (const io::SpacingMissing& error) {
      if (!unsized) throw;
      return [this, unsized, error] { QTimer::singleShot(0, this, [unsized, error] { unsized(error); }); };
    }
  });
}

void StudyLoader::openLabels(const std::filesystem::path& path, const std::filesystem::path& table) {
  if (mayReplaceLabels_ && !mayReplaceLabels_()) return;
  job_.start([this, path, table, volume = document_.scene().volume](const io::Progress& progress) -> LoadJob::Show {
    const io::OpenedLabels read = io::openLabels(path, volume->grid, progress, false, table);
    return [this, read, from = io::sessionLabels(path, table)] {
      document_.setLabels(read.labels, from);
      Q_EMIT labelsOpened(read.warnings);
    };
  });
}

}  // namespace fenestra::viewer
