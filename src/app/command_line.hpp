// SPDX-License-Identifier: MIT
#pragma once
// The command line as the commands see it. command_line.cpp alone includes CLI11, whose headers take six seconds a
// file.

#include <functional>
#include <string>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): its own name
class App;
class Option;
}  // namespace CLI

namespace talus::app {

/// Threads that a command takes at most: the machine may refuse to start more.
inline constexpr int most_threads = 1024;

/// A value or a flag of a command.
class Argument {
 public:
  explicit Argument(CLI::Option* option) : option_(option) {}
  Argument required() const;
  /// Only numbers from 1 to `most`.
  Argument positive(int most) const;
  Argument one_of(const std::vector<std::string>& words) const;
  /// The two cannot be given together.
  Argument excludes(Argument other) const;
  /// One value each time that it is given: what follows is another argument.
  Argument one_each() const;
  /// `word` stands for the value in the help.
  Argument shown_as(const char* word) const;

 private:
  CLI::Option* option_;
};

/// A command; what its arguments write to must live as long as its action.
class Command {
 public:
  Command(CLI::App& app, const char* name, const char* meaning);
  /// T is one of std::string, std::filesystem::path, std::vector<std::string>, std::optional<double>, int.
  template <class T>
  Argument take(const char* names, T& target, const char* meaning) const;
  Argument flag(const char* names, bool& target, const char* meaning) const;
  /// What is done when the command is given.
  void act(std::function<void()> action) const;

 private:
  CLI::App& command_;
};

/// Runs the command that the arguments name. Throws Error (wrong_input) for a mistake in them; others as the command.
int run_command_line(int argc, char** argv);

}  // namespace talus::app
