#pragma once
// Shows a colour; a click chooses another.

#include <QToolButton>

#include <glm/glm.hpp>

namespace fenestra::viewer {

class ColourButton : public QToolButton {
  Q_OBJECT
 public:
  /// `title` is that of the colour dialog.
  explicit ColourButton(const QString& title, QWidget* parent = nullptr);

  /// Display RGB 0..1.
  void setColour(glm::dvec3 colour);

 Q_SIGNALS:
  /// The user chose a colour.
  void edited(glm::dvec3 colour);

 private:
  glm::dvec3 colour_{0.0};
};

}  // namespace fenestra::viewer
