#pragma once
// Grows the region in the document's focus in the background: at once around the click, then in the whole volume.

#include <optional>

#include "rendering/settings/Focus.h"
#include "viewer/jobs/LoadJob.h"

namespace fenestra::viewer {

class Document;

class RegionGrower : public QObject {
  Q_OBJECT
 public:
  /// Follows the document's focus from now on. `document` outlives this.
  explicit RegionGrower(Document& document, QObject* parent = nullptr);

  bool isGrowing() const { return wanted_.has_value(); }
  /// Gives up the region that is being grown: the focus becomes what it was before.
  void cancel();

  /// Its progress, and cancelling it from a button; failures become failed().
  LoadJob& job() { return job_; }

 Q_SIGNALS:
  /// There is no region; the focus is what it was before. The message is one line.
  void failed(const QString& message);

 private:
  void follow();
  void start();
  void takeBack();

  Document& document_;
  std::optional<RegionFocus> wanted_;  ///< being grown, or about to be
  Focus before_;                       ///< the last focus that was complete
  int step_ = 0;                       ///< of the history at which wanted_ was asked for
  bool starts_ = false;                ///< once the job before it has ended: two would take twice the memory
  LoadJob job_;
};

}  // namespace fenestra::viewer
