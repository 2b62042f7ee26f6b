#pragma once
// Options of the programs. CLI11, which takes seconds to compile, stays in Options.cpp.
//
// Options are read in the order in which they are declared, and read while the command line is parsed: a mistake is
// reported with the option's name. Whatever an option writes to must outlive its program.

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <glm/glm.hpp>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace fenestra::app {

/// Thrown by what reads an option's value, where more can be said than that its form is wrong.
struct WrongValue {
  std::string message;
};
/// Thrown by what checks a whole command line: an option is missing, on the whole or for `needing`.
struct MissingOption {
  std::string name;
  std::string needing = {};
};
/// Thrown by what reads an option's value to end the program at once, with success.
struct Finished {};

/// An option that a command has.
class Option {
 public:
  explicit Option(CLI::Option* option) : option_(option) {}

  Option excludes(Option other) const;
  Option needs(Option other) const;
  Option required() const;
  /// The form of its value in --help.
  Option as(const std::string& form) const;
  /// Its value may be left out and is `otherwise` then.
  Option orElse(const std::string& otherwise) const;
  Option within(int low, int high) const;
  Option positive() const;
  /// `problem` says what is wrong with a value; empty: nothing.
  Option refusing(std::function<std::string(const std::string&)> problem) const;
  /// Where it is given several times, each takes one text.
  Option oneEach() const;
  bool isGiven() const;

 private:
  CLI::Option* option_;
};

/// The options of a program or of one of its commands.
class Command {
 public:
  Command(CLI::App& app) : app_(&app) {}  // NOLINT(google-explicit-constructor): of programs that use CLI11 themselves

  const std::string& name() const;
  /// From here on options stand under this heading of --help.
  void group(const std::string& heading) const;

  /// An option whose text `read` takes; false: it is not of that form.
  Option add(const std::string& name, const std::string& form, const std::string& description,
             std::function<bool(const std::string&)> read) const;
  /// One that may be given several times; `read` takes all its texts, or throws WrongValue.
  Option addRepeated(const std::string& name, const std::string& form, const std::string& description,
                     std::function<void(const std::vector<std::string>&)> read) const;
  /// A text, path, number or list of texts as it stands.
  template <class T>
  Option addValue(const std::string& name, T& target, const std::string& description) const;
  /// On where it is given; with "!" before the name, off.
  Option addFlag(const std::string& name, bool& target, const std::string& description) const;

  Option option(const std::string& name) const;
  bool isGiven(const std::string& name) const { return option(name).isGiven(); }

  /// Called once this command's options are read, and once the whole line is.
  void whenRead(std::function<void()> check) const;
  void atLast(std::function<void()> check) const;
  /// Whether the command line names this command.
  bool isNamed() const;

 private:
  CLI::App* app_;
};

/// An option and a command as --help shows them.
struct OptionText {
  std::vector<std::string> names;  ///< with their dashes
  std::string description;
  bool takesValue = false, repeats = false;
  std::string form;
};
struct CommandText {
  std::string name, description;
  std::vector<OptionText> options;
};

/// A program's command line: --help and --version, its own options, and commands.
class Program {
 public:
  Program(const std::string& description, const std::string& name, const std::string& version);
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  Command options();
  /// A command line has to name one of them then.
  Command addCommand(const std::string& name, const std::string& description);
  /// Where descriptions begin in --help.
  void setHelpColumn(std::size_t column);

  struct Parsed {
    std::optional<int> exitCode;  ///< the program ends: help or the like was printed
    std::string mistake;          ///< in the usage, for a message; empty: none
  };
  /// Exceptions other than those above pass through.
  Parsed parse(int argc, char** argv);

  /// The program itself, then its commands.
  std::vector<CommandText> texts() const;

 private:
  std::unique_ptr<CLI::App> app_;
};

Option addNumber(Command command, const std::string& name, double low, double high, const std::string& form,
                 const std::string& description, double& target);
/// on|off
Option addSwitch(Command command, const std::string& name, const std::string& description, bool& target);
/// Display RGB, 0..1 each.
Option addColour(Command command, const std::string& name, const std::string& description, glm::dvec3& target);

/// An option that takes one of a few words.
template <class T, class Target>
Option addChoice(Command command, const std::string& name, const std::string& description,
                 std::vector<std::pair<std::string, T>> choices, Target& target) {
  std::string form;
  for (const auto& [word, value] : choices) form += (form.empty() ? "" : "|") + word;
  return command.add(name, form, description, [&target, choices](const std::string& text) {
    const auto at =
        std::find_if(choices.begin(), choices.end(), [&](const auto& choice) { return choice.first == text; });
    if (at == choices.end()) return false;
    target = at->second;
    return true;
  });
}

}  // namespace fenestra::app
