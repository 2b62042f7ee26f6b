#pragma once
// Edits the label that is the focus: grow and shrink by a distance, fill holes, remove islands. Hidden unless the focus
// is one label.

#include <array>

#include <QDoubleSpinBox>
#include <QToolButton>
#include <QWidget>

#include "viewer/model/LabelOperation.h"

namespace fenestra::viewer {

class Document;

class LabelEditPanel : public QWidget {
  Q_OBJECT
 public:
  explicit LabelEditPanel(Document& document, QWidget* parent = nullptr);

  QDoubleSpinBox* distance() const { return distance_; }  ///< mm
  QDoubleSpinBox* island() const { return island_; }      ///< mm³
  QToolButton* button(LabelOperation operation) const { return buttons_[static_cast<std::size_t>(operation)]; }

 Q_SIGNALS:
  /// See LabelEditor::edit.
  void edited(std::uint16_t label, LabelOperation operation, double number);

 private:
  void showFocus();

  Document& document_;
  QDoubleSpinBox *distance_, *island_;
  std::array<QToolButton*, 4> buttons_{};
};

}  // namespace fenestra::viewer
