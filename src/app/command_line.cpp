// SPDX-License-Identifier: MIT
#include "app/command_line.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/error.hpp"
#include "base/lane.hpp"
#include "base/text.hpp"
#include "base/user_file.hpp"

namespace talus::app {
namespace {

/// Throws Error (wrong_input) for an unknown command, for which CLI11 would only report that a command is required.
void refuse_unknown_command(const CLI::App& app, int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') return;
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(command->get_name());
  if (std::find(names.begin(), names.end(), argv[1]) != names.end()) return;
  const std::string near = find_nearest(argv[1], names);
  fail_input("there is no command '{}'; {}", argv[1],
             near.empty() ? "see talus --help" : fmt::format("did you mean '{}'?", near));
}

/// Describes an option with its names, such as "-o,--out"; a positional argument has one without dashes.
nlohmann::ordered_json describe_option(const CLI::Option& option) {
  nlohmann::ordered_json names = nlohmann::ordered_json::array();
  for (const std::string& name : option.get_snames()) names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
  if (names.empty()) names.push_back(option.get_name(true));
  const bool takes_value = option.get_items_expected_max() > 0;
  return {{"names", names},
          {"value", takes_value ? option.get_type_name() : ""},
          {"is_required", option.get_required()},
          {"meaning", option.get_description()}};
}

/// Lists all commands with their options as JSON, the source of shell completions and of the manual page.
std::string list_commands(const CLI::App& app) {
  nlohmann::ordered_json commands = nlohmann::ordered_json::array();
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    nlohmann::ordered_json options = nlohmann::ordered_json::array();
    for (const CLI::Option* option : command->get_options()) options.push_back(describe_option(*option));
    commands.push_back({{"name", command->get_name()}, {"meaning", command->get_description()}, {"options", options}});
  }
  return nlohmann::ordered_json{{"name", app.get_name()}, {"meaning", app.get_description()}, {"commands", commands}}
      .dump(1);
}

}  // namespace

Argument Argument::required() const {
  return Argument(option_->required());
}

Argument Argument::positive(int most) const {
  const auto refuse = [most](const std::string& text) {
    int number = 0;
    const char* end = text.data() + text.size();
    const auto [last, failure] = std::from_chars(text.data(), end, number);
    if (failure == std::errc{} && last == end && number > 0 && number <= most) return std::string();
    if (last == end && (number > most || failure == std::errc::result_out_of_range) && text.front() != '-')
      return fmt::format("'{}' must be a whole number of at most {}", text, most);
    return fmt::format("'{}' must be a whole number of at least 1; leave the option out for its default", text);
  };
  return Argument(option_->check(CLI::Validator(refuse, "POSITIVE")));
}

Argument Argument::one_of(const std::vector<std::string>& words) const {
  return Argument(option_->check(CLI::IsMember(words)));
}

Argument Argument::excludes(Argument other) const {
  return Argument(option_->excludes(other.option_));
}

Argument Argument::one_each() const {
  return Argument(option_->type_size(1)->allow_extra_args(false));
}

Argument Argument::shown_as(const char* word) const {
  return Argument(option_->type_name(word));
}

Command::Command(CLI::App& app, const char* name, const char* meaning) : command_(*app.add_subcommand(name, meaning)) {}

template <class T>
Argument Command::take(const char* names, T& target, const char* meaning) const {
  return Argument(command_.add_option(names, target, meaning));
}

template Argument Command::take(const char*, int&, const char*) const;
template Argument Command::take(const char*, std::string&, const char*) const;
template Argument Command::take(const char*, std::vector<std::string>&, const char*) const;
template Argument Command::take(const char*, std::filesystem::path&, const char*) const;
template Argument Command::take(const char*, std::optional<double>&, const char*) const;

Argument Command::flag(const char* names, bool& target, const char* meaning) const {
  return Argument(command_.add_flag(names, target, meaning));
}

void Command::act(std::function<void()> action) const {
  command_.callback(std::move(action));
}

int run_command_line(int argc, char** argv) {
  check_asked_level();
  require_open_files();
  CLI::App app{
      "Talus: slope stability and runout by limit equilibrium (LEM), finite elements (FEM), limit analysis and "
      "material points (MPM)",
      "talus"};
  app.require_subcommand(1);
  app.set_version_flag("--version", write_version(), "Print the version, as `talus version`");
  app.add_flag_callback(
      "--level",
      [] {
        fmt::print("{}\n", instruction_level);
        throw CLI::Success();
      },
      "Print the instruction set level that is used on this machine");
  app.footer("`talus COMMAND --help` lists the options of a command, `talus manual` every key of a case file.");
  for (const auto add :
       {add_run, add_study, add_find, add_collect, add_point, add_calibrate, add_plot, add_report, add_check,
        add_import, add_export, add_studio, add_manual, add_template, add_schema, add_version})
    add(app);
  Command(app, "commands", "List all commands and their options as JSON, for completions and manual pages").act([&app] {
    fmt::print("{}\n", list_commands(app));
  });
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    // CLI11 throws an error with code 0 for --help; every other one is a mistake in the command line.
    if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) return app.exit(error);
    refuse_unknown_command(app, argc, argv);
    const auto used = app.get_subcommands();
    const std::string command = used.empty() ? "" : " " + used.front()->get_name();
    fail_input("{}; see talus{} --help", error.what(), command);
  }
  return static_cast<int>(ExitCode::success);
}

}  // namespace talus::app
