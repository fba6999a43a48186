// SPDX-License-Identifier: MIT
#pragma once
// Interface of the commands to the command line. Only command_line.cpp includes CLI11, whose headers take six seconds
// to compile.

#include <functional>
#include <string>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): its own name
class App;
class Option;
}  // namespace CLI

namespace talus::app {

/// Largest number of threads of a command: the machine may refuse to start more.
inline constexpr int most_threads = 1024;

/// A value or a flag of a command.
class Argument {
 public:
  explicit Argument(CLI::Option* option) : option_(option) {}
  Argument required() const;
  /// Restricts the value to numbers from 1 to `most`.
  Argument positive(int most) const;
  Argument one_of(const std::vector<std::string>& words) const;
  /// Excludes the combination of both arguments.
  Argument excludes(Argument other) const;
  /// Takes one value for each occurrence: what follows is another argument.
  Argument one_each() const;
  /// Shows `word` for the value in the help.
  Argument shown_as(const char* word) const;

 private:
  CLI::Option* option_;
};

/// A command; the targets of its arguments must outlive its action.
class Command {
 public:
  Command(CLI::App& app, const char* name, const char* meaning);
  /// T is one of std::string, std::filesystem::path, std::vector<std::string>, std::optional<double>, int.
  template <class T>
  Argument take(const char* names, T& target, const char* meaning) const;
  Argument flag(const char* names, bool& target, const char* meaning) const;
  /// Sets the action of the command.
  void act(std::function<void()> action) const;

 private:
  CLI::App& command_;
};

/// Runs the command of the arguments. Throws Error (wrong_input) for a mistake in them, and what the command throws.
int run_command_line(int argc, char** argv);

// The commands of the program. Every function adds its command to the command line.

/// "talus 0.2.0 (source …)".
std::string write_version();
/// Throws Error if the environment requests a level of the instruction set other than that of this program.
void check_asked_level();

void add_run(CLI::App& app);
void add_study(CLI::App& app);
void add_find(CLI::App& app);
void add_collect(CLI::App& app);
void add_point(CLI::App& app);
void add_calibrate(CLI::App& app);
void add_plot(CLI::App& app);
void add_report(CLI::App& app);
void add_check(CLI::App& app);
void add_import(CLI::App& app);
void add_export(CLI::App& app);
void add_studio(CLI::App& app);
void add_manual(CLI::App& app);
void add_template(CLI::App& app);
void add_schema(CLI::App& app);
void add_version(CLI::App& app);

}  // namespace talus::app
