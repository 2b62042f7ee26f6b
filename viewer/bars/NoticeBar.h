#pragma once
// Errors, warnings about the data and offers, in a bar above the pictures. A notice never blocks the window. The worst
// stand on top, and of one kind the newest; errors always show, of the others the first few, and a button unfolds the
// rest. A notice goes when the user dismisses it, when the study that it is about is closed, or when what it is about
// has come to a good end.

#include <functional>
#include <vector>

#include <QWidget>

#include "io/VolumeReader.h"

class QPushButton;
class QVBoxLayout;

namespace fenestra::viewer {

class NoticeBar : public QWidget {
  Q_OBJECT
 public:
  /// From the least to the worst.
  enum class Kind : std::uint8_t { Offer, Warning, Error };
  /// What a notice is about; end() takes those of a subject away.
  enum class Subject : std::uint8_t {
    Study,          ///< the data that are open
    Opening,        ///< opening data, a session or labels
    Segmentations,  ///< segmentations that can be opened
    Saving,         ///< a session
    Writing,        ///< pictures, labels, surfaces, measures
    Verifying,
    Views,    ///< drawing the 3-D views
    Region,   ///< growing a region
    Labels,   ///< editing labels
    Linking,  ///< two studies that are open side by side
    Looks,    ///< presets, transfer functions and strokes of the user; they outlive the study
    Offered   ///< data that was named at the start; it outlives the study
  };

  explicit NoticeBar(QWidget* parent = nullptr);

  /// A button of a notice.
  struct Action {
    QString name;
    std::function<void()> run;
    bool takes = false;  ///< an offer is taken: the notice goes
  };
  /// Adds a notice. One of the same text moves up to the place of a new one. `withoutNames` stands for a text that may
  /// name the patient while names are hidden.
  void add(Kind kind, Subject subject, const QString& text, const std::vector<Action>& actions = {},
           const QString& withoutNames = {});
  void addError(Subject subject, const QString& text) { add(Kind::Error, subject, text); }
  /// What the subject's errors are about has succeeded, or its offers were taken.
  void end(Subject subject);
  /// Another study is open: what was about the one before goes.
  void forgetStudy();
  void hideNames(bool hide);
  /// A reader's warnings, the first on top, each with the files that it concerns.
  void addWarnings(const std::vector<io::Warning>& warnings);
  /// What is odd about a series' slices and where they are shown, with a button for the whole report and one for each
  /// other way to place them.
  void addGeometry(const io::GeometryReport& report, const std::function<void(io::Regularise)>& choose);
  /// The texts, from the top, those that are folded away included.
  QStringList texts() const;

 private:
  QWidget* rowAt(int index) const;
  /// Takes away the notices of which `goes` is true.
  void remove(const std::function<bool(const QWidget& row)>& goes);
  void fold();

  QVBoxLayout* rows_;
  QPushButton* unfold_;
  bool unfolded_ = false, hidesNames_ = false;
};

}  // namespace fenestra::viewer
