#pragma once
// Animates context that a method moves, the parts of an exploded view or a peeled layer: out when the method is chosen,
// back when it is left.

#include <QObject>
#include <QVariantAnimation>

#include "rendering/settings/Look.h"

namespace fenestra::viewer {

class Document;
class ViewLink;

class ContextAnimation : public QObject {
  Q_OBJECT
 public:
  /// Takes 0.4 s, or no time where the cameras are not animated. An opened study is shown at once.
  ContextAnimation(Document& document, const ViewLink& cameras, QObject* parent = nullptr);

  bool isRunning() const { return animation_.state() == QAbstractAnimation::Running; }
  /// The document's look as pictures show it now. While the animation runs, it is less exploded or peeled; on the way
  /// back it still has the method that was left.
  Look shown(Look look) const;

 Q_SIGNALS:
  void moved();

 private:
  void follow();

  Document& document_;
  const ViewLink& cameras_;
  Method moving_;                ///< the last method that moved context
  bool isMoved_ = false;         ///< the document's look moves context
  QVariantAnimation animation_;  ///< share of the way, from 0 to 1 or back
};

}  // namespace fenestra::viewer
