#pragma once
// Asks how large voxels are, of a file that does not say it.

#include <array>

#include <QDialog>
#include <QDoubleSpinBox>

#include <glm/glm.hpp>

namespace fenestra::viewer {

class SpacingDialog : public QDialog {
  Q_OBJECT
 public:
  /// `why` is the text above the fields; `now` is what they begin with, mm.
  explicit SpacingDialog(const QString& why, QWidget* parent = nullptr, const glm::dvec3& now = glm::dvec3(0.0));

  /// Across, down and from slice to slice, mm; the dialog is accepted only with three positive numbers.
  glm::dvec3 spacing() const;
  const std::array<QDoubleSpinBox*, 3>& fields() const { return fields_; }

 private:
  std::array<QDoubleSpinBox*, 3> fields_{};
};

}  // namespace fenestra::viewer
