#include "app/options/Options.h"

#include <CLI/CLI.hpp>

#include "app/options/Numbers.h"

namespace fenestra::app {
namespace {

/// Calls `read`; what it throws becomes what CLI11 expects.
template <class Read>
auto translated(const std::string& option, const Read& read) {
  try {
    return read();
  } catch (const WrongValue& wrong) {
    throw CLI::ValidationError(option, wrong.message);
  } catch (const MissingOption& missing) {
    if (missing.needing.empty()) throw CLI::RequiredError(missing.name);
    throw CLI::RequiresError(missing.needing, missing.name);
  } catch (const Finished&) {
    throw CLI::Success();
  }
}

const std::function<bool(const CLI::App*)> allOfThem;

std::vector<OptionText> optionsOf(const CLI::App& command) {
  std::vector<OptionText> options;
  for (const CLI::Option* each : command.get_options()) {
    OptionText option;
    for (const std::string& name : each->get_snames()) option.names.push_back("-" + name);
    for (const std::string& name : each->get_lnames()) option.names.push_back("--" + name);
    if (option.names.empty() || each->get_group().empty()) continue;
    option.description = each->get_description();
    option.takesValue = each->get_items_expected_max() > 0;
    option.repeats = each->get_items_expected_max() > 1;
    if (option.takesValue) option.form = each->get_type_name();
    options.push_back(std::move(option));
  }
  return options;
}

}  // namespace

Option Option::excludes(Option other) const { return Option(option_->excludes(other.option_)); }
Option Option::needs(Option other) const { return Option(option_->needs(other.option_)); }
Option Option::required() const { return Option(option_->required()); }
Option Option::as(const std::string& form) const { return Option(option_->type_name(form)); }
Option Option::orElse(const std::string& otherwise) const {
  return Option(option_->expected(0, 1)->default_str(otherwise));
}
Option Option::within(int low, int high) const { return Option(option_->check(CLI::Range(low, high))); }
Option Option::positive() const { return Option(option_->check(CLI::PositiveNumber)); }
Option Option::refusing(std::function<std::string(const std::string&)> problem) const {
  return Option(option_->check(std::move(problem)));
}
Option Option::oneEach() const { return Option(option_->expected(1)->take_all()); }
bool Option::isGiven() const { return option_->count() > 0; }

const std::string& Command::name() const { return app_->get_name(); }

void Command::group(const std::string& heading) const { app_->option_defaults()->group(heading); }

Option Command::add(const std::string& name, const std::string& form, const std::string& description,
                    std::function<bool(const std::string&)> read) const {
  return Option(app_->add_option_function<std::string>(
                        name,
                        [=, read = std::move(read)](const std::string& text) {
                          if (!translated(name, [&] { return read(text); }))
                            throw CLI::ValidationError(name, "\"" + text + "\" is not " + form);
                        },
                        description)
                    ->type_name(form));
}

Option Command::addRepeated(const std::string& name, const std::string& form, const std::string& description,
                            std::function<void(const std::vector<std::string>&)> read) const {
  return Option(app_->add_option_function<std::vector<std::string>>(
                        name,
                        [=, read = std::move(read)](const std::vector<std::string>& texts) {
                          translated(name, [&] { read(texts); });
                        },
                        description)
                    ->type_name(form)
                    ->allow_extra_args(false));
}

template <class T>
Option Command::addValue(const std::string& name, T& target, const std::string& description) const {
  return Option(app_->add_option(name, target, description));
}
template Option Command::addValue(const std::string&, std::string&, const std::string&) const;
template Option Command::addValue(const std::string&, std::filesystem::path&, const std::string&) const;
template Option Command::addValue(const std::string&, std::vector<std::string>&, const std::string&) const;
template Option Command::addValue(const std::string&, int&, const std::string&) const;
template Option Command::addValue(const std::string&, std::uint64_t&, const std::string&) const;
template Option Command::addValue(const std::string&, std::optional<int>&, const std::string&) const;
template Option Command::addValue(const std::string&, std::optional<double>&, const std::string&) const;

Option Command::addFlag(const std::string& name, bool& target, const std::string& description) const {
  return Option(app_->add_flag(name, target, description));
}

Option Command::option(const std::string& name) const { return Option(app_->get_option(name)); }

void Command::whenRead(std::function<void()> check) const {
  app_->parse_complete_callback([check = std::move(check)] { translated("", check); });
}

void Command::atLast(std::function<void()> check) const {
  app_->final_callback([check = std::move(check)] { translated("", check); });
}

bool Command::isNamed() const { return app_->parsed(); }

Program::Program(const std::string& description, const std::string& name, const std::string& version)
    : app_(std::make_unique<CLI::App>(description, name)) {
  app_->set_version_flag("--version", version);
}

Program::~Program() = default;

Command Program::options() { return *app_; }

Command Program::addCommand(const std::string& name, const std::string& description) {
  app_->require_subcommand(1);
  return *app_->add_subcommand(name, description);
}

void Program::setHelpColumn(std::size_t column) { app_->get_formatter()->column_width(column); }

Program::Parsed Program::parse(int argc, char** argv) {
  try {
    app_->parse(argc, argv);
    return {};
  } catch (const CLI::Success& success) {
    return {app_->exit(success), {}};
  } catch (const CLI::ParseError& error) {
    const auto commands = std::as_const(*app_).get_subcommands(allOfThem);
    const bool isNamed = !app_->get_subcommands().empty() || error.get_name() == "ValidationError";
    if (commands.empty() || isNamed) return {std::nullopt, error.what()};
    std::string expected = "expected ";
    for (std::size_t i = 0; i < commands.size(); ++i)
      expected += (i == 0 ? "" : i + 1 < commands.size() ? ", " : " or ") + commands[i]->get_name();
    return {std::nullopt, expected};
  }
}

std::vector<CommandText> Program::texts() const {
  std::vector<CommandText> all{{app_->get_name(), app_->get_description(), optionsOf(*app_)}};
  for (const CLI::App* command : std::as_const(*app_).get_subcommands(allOfThem))
    all.push_back({command->get_name(), command->get_description(), optionsOf(*command)});
  return all;
}

Option addNumber(Command command, const std::string& name, double low, double high, const std::string& form,
                 const std::string& description, double& target) {
  return command.add(name, form, description, [=, &target](const std::string& text) {
    const std::optional<double> number = parseNumber<double>(text);
    if (!number || *number < low || *number > high) return false;
    target = *number;
    return true;
  });
}

Option addSwitch(Command command, const std::string& name, const std::string& description, bool& target) {
  return command.add(name, "on|off", description, [&target](const std::string& text) {
    target = text == "on";
    return target || text == "off";
  });
}

Option addColour(Command command, const std::string& name, const std::string& description, glm::dvec3& target) {
  return command.add(name, "R,G,B", description, [&target](const std::string& text) {
    const std::optional<glm::dvec3> colour = parseVector(text);
    if (!colour || glm::any(glm::lessThan(*colour, glm::dvec3(0.0))) ||
        glm::any(glm::greaterThan(*colour, glm::dvec3(1.0))))
      return false;
    target = *colour;
    return true;
  });
}

}  // namespace fenestra::app
