#pragma once
// Grows the region in the document's focus in the background: at once around the click, then in the whole volume.

#include <memory>
#include <optional>

#include "rendering/segmentation/RegionGrowing.h"
#include "rendering/settings/Focus.h"
#include "viewer/jobs/LoadJob.h"
#include "viewer/model/Document.h"

namespace fenestra::viewer {

class RegionGrower : public QObject {
  Q_OBJECT
 public:
  /// Follows the document's focus from now on. `document` outlives this.
  explicit RegionGrower(Document& document, QObject* parent = nullptr);

  bool isGrowing() const { return wanted_.has_value(); }
  /// What is kept for corrections, while a region is in the focus; to be asked while none grows.
  const segmentation::GrowthMemory& memory() const { return memory_; }
  /// Gives up the region that is being grown, or that Document::asksToOpen() about: the focus becomes what it was
  /// before.
  void cancel();

  /// Its progress, and cancelling it from a button; failures become failed().
  LoadJob& job() { return job_; }

 Q_SIGNALS:
  /// There is no region; the focus is what it was before. The message is one line.
  void failed(const QString& message);

 private:
  void follow();
  void start();
  /// What start() needs to know on another thread.
  struct Task {
    std::shared_ptr<const Volume> volume;
    RegionFocus seeds;
    bool showsPart = false;  ///< a first part is of use
    segmentation::GrowthMemory memory;
    std::optional<std::pair<RegionFocus, std::shared_ptr<const segmentation::Growth>>> before;
  };
  /// Off the GUI thread.
  Document::Growing grow(const Task& task, const io::Progress& progress);
  void showPart(const Task& task, const segmentation::Progress& progress);
  /// The whole region is there.
  void finish(const Task& task, Document::Growing grown);
  /// Why a grown region is none; empty where it is one.
  QString problemOf(const Task& task, const segmentation::Growth& growth) const;
  void takeBack();

  Document& document_;
  std::optional<RegionFocus> wanted_;  ///< being grown, or about to be
  Focus before_;                       ///< the last focus that was complete
  int step_ = 0;                       ///< of the history at which wanted_ was asked for
  bool starts_ = false;                ///< once the job before it has ended: two would take twice the memory
  segmentation::GrowthMemory memory_;  ///< of the volume, while a region is in the focus
  LoadJob job_;
};

}  // namespace fenestra::viewer
