#include "app/options/Completion.h"

#include <algorithm>
#include <cctype>
#include <iostream>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "io/base/Text.h"

namespace fenestra::app {
namespace {

/// What may follow an option.
struct Value {
  std::string form;  ///< as --help has it
  std::vector<std::string> words;
  bool files = false, folders = false;
};

/// The program itself comes first, then its commands.
using Table = std::vector<CommandText>;

bool isWord(std::string_view text) {
  return !text.empty() &&
         std::all_of(text.begin(), text.end(), [](unsigned char c) { return std::isalnum(c) || c == '-'; });
}

Value valueOf(const OptionText& option) {
  Value value;
  if (!option.takesValue) return value;
  value.form = option.form;
  const std::vector<std::string> alternatives = io::split(option.form, '|');
  for (const std::string& each : alternatives) {
    const auto says = [&](std::string_view what) { return each.find(what) != std::string::npos; };
    value.folders = value.folders || says("FOLDER");
    if (says("FILE") || says("PATH") || says(".png"))
      value.files = true;
    else if (alternatives.size() > 1 && isWord(each))
      value.words.push_back(each);
  }
  return value;
}

std::string joined(const std::vector<std::string>& parts, const std::string& separator) {
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : separator) + part;
  return text;
}

std::vector<std::string> commandNames(const Table& table) {
  std::vector<std::string> names;
  for (std::size_t i = 1; i < table.size(); ++i) names.push_back(table[i].name);
  return names;
}

std::string replaced(std::string_view text, std::string_view special, std::string_view before) {
  std::string result;
  for (const char c : text) {
    if (special.find(c) != std::string_view::npos) result += before;
    result += c;
  }
  return result;
}

std::string bashScript(const Table& table) {
  const std::string& program = table[0].name;
  const std::vector<std::string> commands = commandNames(table);
  std::ostringstream script;
  script << "# Completion for bash, made by `" << program << " --completion bash`.\n"
         << "_" << program << "() {\n"
         << "  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]} word command=" << program
         << "\n  local options='' words='" << joined(commands, " ") << "' paths='" << (commands.empty() ? "-f" : "")
         << "'\n";
  if (!commands.empty())
    script << "  for word in \"${COMP_WORDS[@]:1:COMP_CWORD - 1}\"; do\n"
           << "    case $word in " << joined(commands, "|") << ") command=$word words='' paths=-f; break ;; esac\n"
           << "  done\n";
  script << "  case $command in\n";
  for (const CommandText& command : table) {
    std::vector<std::string> names;
    for (const OptionText& option : command.options)
      names.insert(names.end(), option.names.begin(), option.names.end());
    script << "    " << command.name << ") options='" << joined(names, " ") << "' ;;\n";
  }
  script << "  esac\n  case $command:$previous in\n";
  for (const CommandText& command : table)
    for (const OptionText& option : command.options) {
      if (!option.takesValue) continue;
      std::vector<std::string> patterns;
      for (const std::string& name : option.names) patterns.push_back(command.name + ":" + name);
      const Value value = valueOf(option);
      script << "    " << joined(patterns, "|") << ") options='' words='" << joined(value.words, " ") << "' paths='"
             << (value.files     ? "-f"
                 : value.folders ? "-d"
                                 : "")
             << "' ;;\n";
    }
  script << "    *) [[ $current != -* ]] || words=$options paths='' ;;\n"
         << "  esac\n"
         << "  mapfile -t COMPREPLY < <(compgen $paths -W \"$words\" -- \"$current\")\n"
         << "}\n"
         << "complete -o filenames -F _" << program << " " << program << "\n";
  return script.str();
}

std::string shellQuoted(std::string_view text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + "'";
}

std::string parenthesised(const std::vector<std::string>& words) {
  return std::string("(").append(joined(words, " ")).append(")");
}

/// What _arguments of zsh takes for one option, one a name.
std::string zshSpecs(const OptionText& option) {
  std::string action;
  if (option.takesValue) {
    const Value value = valueOf(option);
    action.append(":").append(replaced(value.form, ":\\", "\\")).append(":");
    if (value.files)
      action += " _fenestra_words_or_files " + joined(value.words, " ");
    else if (value.folders)
      action += "_files -/";
    else
      action += value.words.empty() ? " " : parenthesised(value.words);
  }
  const std::string before = option.repeats ? "*" : parenthesised(option.names);
  std::string specs;
  for (const std::string& name : option.names)
    specs +=
        " \\\n      " + shellQuoted(before + name + "[" + replaced(option.description, "[]:\\", "\\") + "]" + action);
  return specs;
}

std::string zshScript(const Table& table) {
  const std::string& program = table[0].name;
  const std::vector<std::string> commands = commandNames(table);
  std::ostringstream script;
  script << "#compdef " << program << "\n# Completion for zsh, made by `" << program << " --completion zsh`.\n"
         << "_fenestra_words_or_files() {\n  (( $# )) && compadd -- \"$@\"\n  _files\n}\n"
         << "_" << program << "() {\n"
         << "  local command=" << program << "\n";
  if (!commands.empty())
    script << "  local named=${words[(r)(" << joined(commands, "|") << ")]}\n"
           << "  [[ -z $named || $named == $words[CURRENT] ]] || command=$named\n";
  script << "  case $command in\n";
  for (const CommandText& command : table) {
    script << "    " << command.name << ") _arguments";
    for (const OptionText& option : command.options) script << zshSpecs(option);
    if (&command != &table[0] || commands.empty()) {
      script << " \\\n      '*:file:_files' ;;\n";
      continue;
    }
    std::string described;
    for (std::size_t i = 1; i < table.size(); ++i)
      described += table[i].name + "\\:\"" + replaced(table[i].description, ":()\\\"", "\\") + "\" ";
    script << " \\\n      " << shellQuoted("1:command:((" + described + "))") << " ;;\n";
  }
  script << "  esac\n}\n"
         << "if [[ $funcstack[1] == _" << program << " ]]; then\n  _" << program << " \"$@\"\nelse\n  compdef _"
         << program << " " << program << "\nfi\n";
  return script.str();
}

std::string fishQuoted(std::string_view text) { return replaced(text, "'\\", "\\").insert(0, 1, '\'') + "'"; }

std::string fishScript(const Table& table) {
  const std::string& program = table[0].name;
  const bool hasCommands = table.size() > 1;
  std::ostringstream script;
  script << "# Completion for fish, made by `" << program << " --completion fish`.\n";
  if (hasCommands) script << "complete -c " << program << " -n __fish_use_subcommand -f\n";
  for (const CommandText& command : table) {
    const bool isProgram = &command == &table[0];
    std::string line = "complete -c " + program;
    if (!isProgram)
      script << line << " -n __fish_use_subcommand -a " << command.name << " -d " << fishQuoted(command.description)
             << "\n";
    if (hasCommands)
      line += isProgram ? " -n __fish_use_subcommand" : " -n '__fish_seen_subcommand_from " + command.name + "'";
    for (const OptionText& option : command.options) {
      script << line;
      for (const std::string& name : option.names)
        script << (name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1));
      const Value value = valueOf(option);
      if (option.takesValue) script << (value.files ? " -r -F" : " -x");
      if (!value.words.empty()) script << " -a " << fishQuoted(joined(value.words, " "));
      if (value.folders) script << " -a '(__fish_complete_directories)'";
      script << " -d " << fishQuoted(option.description) << "\n";
    }
  }
  return script.str();
}

}  // namespace

void addCompletionOption(Program& program) {
  program.options().add("--completion", "bash|zsh|fish", "print a script that completes the options in this shell",
                        [&program](const std::string& shell) {
                          const Table table = program.texts();
                          if (shell == "bash")
                            std::cout << bashScript(table);
                          else if (shell == "zsh")
                            std::cout << zshScript(table);
                          else if (shell == "fish")
                            std::cout << fishScript(table);
                          else
                            return false;
                          throw Finished();
                        });
}

}  // namespace fenestra::app
