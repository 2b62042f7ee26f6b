#pragma once
// The line below the pictures: what is under the mouse, how the last picture was drawn, and what this machine can draw.

#include <glm/glm.hpp>

#include <QElapsedTimer>
#include <QStatusBar>

class QLabel;

namespace fenestra::viewer {

class Document;
struct GlSupport;
class ViewArea;
class ViewOptions;

class StatusBar : public QStatusBar {
  Q_OBJECT
 public:
  StatusBar(const Document& document, const ViewOptions& options, const ViewArea& views, const GlSupport& gl,
            QWidget* parent = nullptr);

  /// Shows time and sampling of the last picture. It does so itself once that is on screen, in a motion twice a second.
  void showFrame();

 private:
  /// Value, coordinates and label of a world position.
  void pointAt(glm::dvec3 world);

  const Document& document_;
  const ViewArea& views_;
  QLabel *pointer_, *frame_;
  QElapsedTimer sinceFrame_;  ///< since the text of frame_ last changed
};

}  // namespace fenestra::viewer
