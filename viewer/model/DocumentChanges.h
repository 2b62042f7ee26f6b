#pragma once
// The steps of a document's history: each turns one part of the document into what it was before or after.

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "rendering/segmentation/LabelEdit.h"
#include "viewer/model/DocumentParts.h"
#include "viewer/model/History.h"

namespace fenestra::viewer {

/// From one look to another. Strokes that both looks begin or end with are left out.
class LookChange : public Change {
 public:
  LookChange(DocumentParts& parts, Look before, Look after);

  void undo() override;
  void redo() override;
  bool absorb(const Change& next) override;
  bool isNothing() const override { return before_ == after_; }
  std::size_t bytes() const override;

 private:
  LookChange& operator=(LookChange&& other) noexcept;
  /// `whole`, which is `from` with all its strokes, as `to`.
  Look replaced(const Look& whole, const Look& from, const Look& to) const;

  DocumentParts& parts_;
  Look before_, after_;
  std::size_t firstStroke_ = 0;  ///< place of the first that differs
};

/// From one label map to another, and from one focus to another.
class LabelsChange : public Change {
 public:
  struct State {
    std::uint64_t revision;
    Focus focus;
  };
  LabelsChange(DocumentParts& parts, segmentation::LabelEdit edit, State before, State after);

  void undo() override;
  void redo() override;
  bool absorb(const Change&) override { return false; }
  bool isNothing() const override;
  std::size_t bytes() const override;

 private:
  DocumentParts& parts_;
  segmentation::LabelEdit edit_;
  State before_, after_;
};

/// From one list of measures to another.
class MeasuresChange : public Change {
 public:
  MeasuresChange(DocumentParts& parts, std::vector<Measure> before, std::vector<Measure> after);

  void undo() override;
  void redo() override;
  bool absorb(const Change& next) override;
  bool isNothing() const override { return before_ == after_; }
  std::size_t bytes() const override;

 private:
  DocumentParts& parts_;
  std::vector<Measure> before_, after_;
};

/// From one path of the straightened picture to another, and from one focus to another where that follows the path.
class PathChange : public Change {
 public:
  struct State {
    std::vector<glm::dvec3> path;
    std::optional<Focus> focus{};  ///< empty: it stays as it is
    bool operator==(const State&) const = default;
  };
  PathChange(DocumentParts& parts, State before, State after)
      : parts_(parts), before_(std::move(before)), after_(std::move(after)) {}

  void undo() override { show(before_); }
  void redo() override { show(after_); }
  bool absorb(const Change& next) override;
  bool isNothing() const override { return before_ == after_; }
  std::size_t bytes() const override;

 private:
  void show(const State& state);

  DocumentParts& parts_;
  State before_, after_;
};

/// From one list of key images to another.
class KeyImagesChange : public Change {
 public:
  KeyImagesChange(DocumentParts& parts, std::vector<io::KeyImage> before, std::vector<io::KeyImage> after)
      : parts_(parts), before_(std::move(before)), after_(std::move(after)) {}

  void undo() override { parts_.showKeyImages(before_); }
  void redo() override { parts_.showKeyImages(after_); }
  bool absorb(const Change&) override { return false; }
  bool isNothing() const override { return before_ == after_; }
  std::size_t bytes() const override;

 private:
  DocumentParts& parts_;
  std::vector<io::KeyImage> before_, after_;
};

}  // namespace fenestra::viewer
