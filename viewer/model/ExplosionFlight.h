#pragma once
// The parts of an exploded view on their way: out when the method is chosen, back when it is left.

#include <QObject>
#include <QVariantAnimation>

#include "rendering/scene/Look.h"

namespace fenestra::viewer {

class Document;
class ViewLink;

class ExplosionFlight : public QObject {
  Q_OBJECT
 public:
  /// Takes 0.4 s, or no time where the cameras are not animated. An opened study is shown at once.
  ExplosionFlight(Document& document, const ViewLink& cameras, QObject* parent = nullptr);

  bool isFlying() const { return flight_.state() == QAbstractAnimation::Running; }
  /// The document's look as pictures show it now: on the way, with fewer of the explosion's degrees, and on the way
  /// back with the method that was left.
  Look shown(Look look) const;

 Q_SIGNALS:
  void moved();

 private:
  void follow();

  Document& document_;
  const ViewLink& cameras_;
  Method exploded_;           ///< that the parts move by
  bool explodes_ = false;     ///< the document's look does
  QVariantAnimation flight_;  ///< of the degree, from 0 to 1 or back
};

}  // namespace fenestra::viewer
