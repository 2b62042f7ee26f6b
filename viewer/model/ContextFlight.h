#pragma once
// The parts of an exploded view, or a layer that is peeled off, on their way: out when the method is chosen, back when
// it is left.

#include <QObject>
#include <QVariantAnimation>

#include "rendering/scene/Look.h"

namespace fenestra::viewer {

class Document;
class ViewLink;

class ContextFlight : public QObject {
  Q_OBJECT
 public:
  /// Takes 0.4 s, or no time where the cameras are not animated. An opened study is shown at once.
  ContextFlight(Document& document, const ViewLink& cameras, QObject* parent = nullptr);

  bool isFlying() const { return flight_.state() == QAbstractAnimation::Running; }
  /// The document's look as pictures show it now: on the way, less exploded or peeled, and on the way
  /// back with the method that was left.
  Look shown(Look look) const;

 Q_SIGNALS:
  void moved();

 private:
  void follow();

  Document& document_;
  const ViewLink& cameras_;
  Method moving_;             ///< that it moves by
  bool isMoved_ = false;      ///< in the document's look
  QVariantAnimation flight_;  ///< of how far, from 0 to 1 or back
};

}  // namespace fenestra::viewer
