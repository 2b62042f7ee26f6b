#pragma once
// Keeps the region in the focus as a label, and edits labels, in the background. Each is a step of the history.

#include <functional>

#include "rendering/segmentation/LabelEdit.h"
#include "viewer/jobs/LoadJob.h"
#include "viewer/model/LabelOperation.h"

namespace fenestra::viewer {

class Document;

class LabelEditor : public QObject {
  Q_OBJECT
 public:
  /// `document` outlives this.
  explicit LabelEditor(Document& document, QObject* parent = nullptr);

  /// The region becomes a label, which becomes the focus. Where it lies over other labels, it takes their voxels.
  void keepRegion(const QString& name, glm::dvec3 colour);
  /// Changes one label. It takes no voxels from others.
  void edit(std::uint16_t label, LabelOperation operation, double number);

  /// Its progress and failures.
  LoadJob& job() { return job_; }

 Q_SIGNALS:
  /// A region was kept and took so much from other labels, in ml.
  void tookFromOthers(const QString& label, double ml);

 private:
  using MakeMask = std::function<segmentation::Mask()>;
  void start(const QString& step, const Label& label, segmentation::Overlap overlap, MakeMask mask);

  Document& document_;
  LoadJob job_;
};

}  // namespace fenestra::viewer
