// SPDX-License-Identifier: MIT
#include "output/plots/gnuplot.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <memory>

#include "base/atomic_file.hpp"
#include "base/error.hpp"
#include "base/file_list.hpp"
#include "base/foreign_code.hpp"
#include "base/text.hpp"
#include "output/files/history.hpp"

namespace talus::output {
namespace {

namespace fs = std::filesystem;

using TemporaryFile = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

/// Makes an unnamed file that vanishes when it is closed. A pipe could fill up and block either process.
TemporaryFile make_temporary_file() {
  TemporaryFile file(std::tmpfile(), &std::fclose);
  if (!file) throw_cannot_write(fs::temp_directory_path(), errno);
  return file;
}

std::string read_start(std::FILE* file) {
  std::rewind(file);
  std::string text(2000, '\0');
  text.resize(std::fread(text.data(), 1, text.size(), file));
  return text;
}

/// Extracts the reason from the output of gnuplot, which repeats the faulty line, marks the place with '^', and ends
/// with the reason.
std::string find_reason(const std::string& said) {
  std::string reason;
  for (std::size_t begin = 0; begin < said.size();) {
    const std::size_t end = std::min(said.find('\n', begin), said.size());
    const std::string line = said.substr(begin, end - begin);
    if (line.find("line ") != std::string::npos && line.find(':') != std::string::npos) reason = line;
    begin = end + 1;
  }
  return reason.empty() ? said.substr(0, 200) : reason;
}

/// A program that draws pictures.
struct Drawer {
  const char* name;
  std::vector<std::string> arguments;
  const char* if_missing;  ///< the end of a sentence
};

/// Runs the program with `script` as its input, to write the temporary file of `picture`.
void run(const fs::path& picture, const std::string& script, const Drawer& drawer) {
  const TemporaryFile input = make_temporary_file(), errors = make_temporary_file();
  if (std::fwrite(script.data(), 1, script.size(), input.get()) != script.size() || std::fflush(input.get()) != 0)
    throw_cannot_write(fs::temp_directory_path(), errno);
  std::rewind(input.get());

  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, fileno(input.get()), STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, fileno(errors.get()), STDERR_FILENO);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  std::vector<std::string> words{drawer.name};
  words.insert(words.end(), drawer.arguments.begin(), drawer.arguments.end());
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  pid_t child = 0;
  const int failure = spawn_program(child, drawer.name, &actions, arguments.data());
  posix_spawn_file_actions_destroy(&actions);
  if (failure == ENOENT) {
    clear_temporary(picture);
    throw Error(ExitCode::cannot_write, "cannot draw '{}': {} is not installed {}", picture.string(), drawer.name,
                drawer.if_missing);
  }
  if (failure != 0)
    throw Error(ExitCode::cannot_write, "cannot draw '{}': {} cannot be started: {}", picture.string(), drawer.name,
                std::strerror(failure));
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
  std::error_code none;
  const bool drawn = fs::file_size(temporary_name(picture), none) > 0 && !none;
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0 || !drawn) {
    clear_temporary(picture);
    throw Error(ExitCode::cannot_write, "cannot draw '{}': {} failed: {}", picture.string(), drawer.name,
                find_reason(read_start(errors.get())));
  }
}

std::string quote_path(const std::string& path) {
  std::string text;
  if (make_printable(path) != path) {  // control characters such as line breaks are written as octal codes
    for (const char c : path) text += fmt::format("\\{:03o}", static_cast<unsigned char>(c));
    return "\"" + text + "\"";
  }
  text = "'";
  for (const char c : path) text += c == '\'' ? "''" : std::string(1, c);
  return text + "'";
}

}  // namespace

double estimate_width(const std::string& text) {
  std::size_t characters = 0;
  for (const char c : text) characters += (c & 0xC0) != 0x80;  // UTF-8: continuation bytes are not counted
  return 7.0 * static_cast<double>(characters);
}

void run_gnuplot(const fs::path& picture, const std::string& body, int width, int height) {
  std::string terminal;
  if (picture.extension() == ".svg")
    terminal = fmt::format(
        "set terminal svg enhanced size {},{} font 'sans-serif,12' background 'white'\n"
        "title_font = ',14'\n",
        width, height);
  else if (picture.extension() == ".png")
    terminal = fmt::format(
        "set terminal pngcairo enhanced size {},{} font 'Sans,9' fontscale 2 linewidth 2 pointscale 2 background "
        "'white'\ntitle_font = ',10.5'\n",
        2 * width, 2 * height);
  else
    fail_input("'{}' cannot be drawn: its name ends neither with .svg nor with .png", picture.string());
  const std::string common = "set encoding utf8\n" + body;
  const fs::path script = fs::path(picture).replace_extension(".gp");
  const auto files = FileList::find(picture);
  write_atomically(script, "# Redraw with: gnuplot " + make_printable(script.filename().string()) + "\n" + terminal +
                               "set output " + quote_path(picture.filename().string()) + "\n" + common);
  run(picture, terminal + "set output " + quote_path(begin_file(picture).string()) + "\n" + common + "\nunset output\n",
      {"gnuplot", {"-"}, "(Debian: apt install gnuplot-nox); the script for it stands beside it"});
  publish(picture);
}

void draw_png(const fs::path& picture, const std::string& svg) {
  run(picture, svg,
      {"rsvg-convert",
       {"--zoom", "2", "--background-color", "white", "--output=" + begin_file(picture).string()},
       "(Debian: apt install librsvg2-bin); a picture whose name ends with .svg needs no other program"});
  publish(picture);
}

std::string quote(const std::string& text) {
  std::string result = "'";
  for (const char c : make_printable(text)) {
    if (c == '\'') result += '\'';
    if (c == '>' && result.ends_with("]]")) result += ' ';  // "]]>" would end a text in the SVG of gnuplot
    if (std::strchr("_^{}@&~\\", c) != nullptr) result += '\\';
    result += c;
  }
  return result + "'";
}

std::string to_words(const std::string& name) {
  std::string words = name;
  for (char& c : words)
    if (c == '_') c = ' ';
  return words;
}

std::string make_label(const std::string& words, const std::string& unit) {
  if (unit.empty() || unit == "-") return words;
  std::string text = unit;
  for (const auto& [plain, raised] : {std::pair{"^2", "²"}, std::pair{"^3", "³"}})
    for (std::size_t at = text.find(plain); at != std::string::npos; at = text.find(plain)) text.replace(at, 2, raised);
  return words.empty() ? "[" + text + "]" : words + " [" + text + "]";
}

std::string make_data(const std::string& name, const std::vector<std::span<const double>>& columns) {
  std::string text = "$" + name + " << END\n";
  const std::size_t rows = columns.empty() ? 0 : columns[0].size();
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t c = 0; c < columns.size(); ++c) {
      if (c > 0) text += ' ';
      text += write_shortest(columns[c][i]);
    }
    text += '\n';
  }
  return text + "END\n";
}

std::string make_tics(const char* axis, double length, double most) {
  const double step = find_tic_step(length, most);
  const int decimals = std::max(0, -static_cast<int>(std::floor(std::log10(step) + 1e-9)));
  const std::string format = decimals > 4 || step >= 1e6 ? "%.3g" : fmt::format("%.{}f", decimals);
  return fmt::format("set {0}tics {1:.10g}\nset format {0} '{2}'\n", axis, step, format);
}

double find_tic_step(double length, double most) {
  if (!(length > 0) || !(most >= 1)) return 1;
  const double power = std::pow(10, std::floor(std::log10(length / most)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (length / (factor * power) <= most) return factor * power;
  return 10 * power;
}

}  // namespace talus::output
