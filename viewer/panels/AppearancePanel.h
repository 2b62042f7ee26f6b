#pragma once
// How the context looks: transfer-function preset, and a shift that moves it along the values.

#include <QComboBox>
#include <QWidget>

namespace fenestra::viewer {

class Document;
class SliderSpin;

class AppearancePanel : public QWidget {
  Q_OBJECT
 public:
  explicit AppearancePanel(Document& document, QWidget* parent = nullptr);

  QComboBox* presets() const { return presets_; }
  SliderSpin* shift() const { return shift_; }

 Q_SIGNALS:
  void failed(const QString& message);

 private:
  void show();
  void choose(int row);

  Document& document_;
  QComboBox* presets_;
  SliderSpin* shift_;
};

}  // namespace fenestra::viewer
