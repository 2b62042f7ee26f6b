#include "rendering/gl/ShaderSource.h"

#include <algorithm>
#include <cassert>
#include <cctype>
#include <optional>
#include <set>
#include <sstream>
#include <utility>

#include "fenestra/shaders.h"

namespace fenestra::gl {
namespace {

/// What an include line names: a file, or with `isChoice` an alternative. Nothing for any other line.
struct Include {
  std::string_view name;
  bool isChoice = false;
};
std::optional<Include> includeOf(std::string_view line) {
  constexpr std::string_view include = "#include ";
  if (!line.starts_with(include)) return std::nullopt;
  const std::size_t first = include.size() + 1;
  return Include{line.substr(first, line.find_last_of("\">") - first), line[first - 1] == '<'};
}

/// Puts a shader's source together, by the choices of a variant.
class Expansion {
 public:
  explicit Expansion(const Variant& variant) : variant_(variant) {
    out_ << "#version 450 core\n";
    for (const Define& define : variant.defines) out_ << "#define " << define.name << ' ' << define.value << '\n';
  }

  /// Appends the file with its includes; line directives carry an index into `files`, which errors are translated with.
  void add(std::string_view path) {
    if (std::ranges::find(files_, path) != files_.end()) return;
    const std::string_view source = shaders::find(path);
    if (source.empty()) throw ShaderError("no embedded shader '" + std::string(path) + "'");
    const std::size_t file = files_.size();
    files_.emplace_back(path);
    out_ << "#line 1 " << file << '\n';
    std::istringstream lines{std::string(source)};
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number) {
      if (const std::optional<Include> included = includeOf(line)) {
        add(included->isChoice ? chosenFile(included->name, path) : included->name);
        out_ << "#line " << number + 1 << ' ' << file << '\n';
      } else {
        out_ << line << '\n';
        noteNames(line);
      }
    }
  }

  ShaderSource finish() {
    assert(std::ranges::all_of(variant_.defines,
                               [&](const Define& define) {
                                 return names_.contains(define.name) &&
                                        std::ranges::count(variant_.defines, define.name, &Define::name) == 1;
                               }) &&
           "a define is not used, or given twice");
    assert(usedChoices_.size() == variant_.choices.size() && "a choice is not used, or given twice");
    return {out_.str(), std::move(files_), std::move(names_)};
  }

 private:
  std::string_view chosenFile(std::string_view name, std::string_view path) {
    const auto choice = std::ranges::find(variant_.choices, name, &Choice::name);
    if (choice == variant_.choices.end())
      throw ShaderError("shader " + std::string(path) + " needs a choice of <" + std::string(name) + ">");
    usedChoices_.insert(choice->name);
    return choice->file;
  }

  void noteNames([[maybe_unused]] std::string_view line) {
#ifndef NDEBUG
    const auto isPart = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
    std::string_view rest = line.substr(0, line.find("//"));
    while (!rest.empty()) {
      const auto length = static_cast<std::size_t>(std::ranges::find_if_not(rest, isPart) - rest.begin());
      if (length > 0) names_.emplace(rest.substr(0, length));
      rest.remove_prefix(std::min(length + 1, rest.size()));
    }
#endif
  }

  const Variant& variant_;
  std::ostringstream out_;
  std::vector<std::string> files_;
  Names names_;                             ///< to be asserted
  std::set<std::string_view> usedChoices_;  ///< to be asserted
};

}  // namespace

Variant& Variant::operator+=(const Variant& more) {
  defines.insert(defines.end(), more.defines.begin(), more.defines.end());
  choices.insert(choices.end(), more.choices.begin(), more.choices.end());
  return *this;
}

Variant operator+(Variant first, const Variant& more) { return std::move(first += more); }

ShaderSource sourceOf(std::string_view path, const Variant& variant) {
  Expansion expansion(variant);
  expansion.add(path);
  return expansion.finish();
}

}  // namespace fenestra::gl
