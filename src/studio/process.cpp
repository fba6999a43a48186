// SPDX-License-Identifier: MIT
#include "studio/process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <fstream>
#include <sstream>
#include <thread>

#include "studio/workspace.hpp"

namespace talus::studio {

namespace fs = std::filesystem;

int start_process(const fs::path& program, std::vector<std::string> arguments, const ProcessFiles& outputs,
                  std::string& why) {
  std::vector<char*> pointers;
  for (std::string& argument : arguments) pointers.push_back(argument.data());
  pointers.push_back(nullptr);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  constexpr int mode = O_WRONLY | O_CREAT | O_APPEND | O_NOFOLLOW;
  posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, outputs.out.c_str(), mode, 0600);
  if (outputs.err.empty())
    posix_spawn_file_actions_adddup2(&files, STDOUT_FILENO, STDERR_FILENO);
  else
    posix_spawn_file_actions_addopen(&files, STDERR_FILENO, outputs.err.c_str(), mode, 0600);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  // A group of its own: Ctrl-C ends the server, and not the run.
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK);
  sigset_t all, none;
  sigfillset(&all);
  sigemptyset(&none);
  posix_spawnattr_setsigdefault(&attributes, &all);
  posix_spawnattr_setsigmask(&attributes, &none);
  pid_t process = 0;
  const int fault = posix_spawn(&process, program.c_str(), &files, &attributes, pointers.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&files);
  if (fault != 0) why = fmt::format("the program cannot be started: {}", std::strerror(fault));
  return fault == 0 ? process : 0;
}

std::string find_process_start(int process) {
  if (process <= 1) return "";  // a damaged state; kill() and waitpid() take such numbers for groups
  std::ifstream file(fmt::format("/proc/{}/stat", process));
  std::string text;
  std::getline(file, text);
  // The name of the program is in brackets and may contain blanks; the time is the 22nd word, the state the third.
  const std::size_t name_end = text.rfind(')');
  if (name_end == std::string::npos) return "";
  std::istringstream words(text.substr(name_end + 1));
  std::vector<std::string> list;
  for (std::string word; words >> word;) list.push_back(word);
  constexpr std::size_t state = 0, start = 19;
  return list.size() > start && list[state] != "Z" ? list[start] : "";
}

std::optional<int> wait_for_process(int process, double seconds) {
  using Clock = std::chrono::steady_clock;
  constexpr std::chrono::milliseconds pause{10};
  const auto end = Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
  int status = 0;
  for (;;) {
    const pid_t ended = waitpid(process, &status, WNOHANG);
    if (ended == process) return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    if (ended < 0 && errno != EINTR) return -1;
    if (Clock::now() > end) break;
    std::this_thread::sleep_for(pause);
  }
  kill(-process, SIGKILL);
  while (waitpid(process, &status, 0) < 0 && errno == EINTR) continue;
  return std::nullopt;
}

void run_process(const fs::path& program, const std::vector<std::string>& arguments, const fs::path& log,
                 double seconds) {
  std::string why;
  const int process = start_process(program, arguments, {log, {}}, why);
  if (process == 0) throw Refusal(500, why);
  const std::optional<int> status = wait_for_process(process, seconds);
  if (!status) throw Refusal(504, fmt::format("it took longer than {:g} s and was ended", seconds));
  if (*status == 0) return;
  constexpr std::streamoff most = 8192;
  const std::vector<std::string> lines = split_lines(read_tail(log, most));
  throw Refusal(400, lines.empty() ? "the program ended without a message" : lines.back());
}

std::string read_news(const fs::path& file, std::streamoff most, std::streamoff& at) {
  std::error_code failure;
  if (!fs::is_regular_file(fs::symlink_status(file, failure))) return "";
  std::ifstream stream(file, std::ios::binary | std::ios::ate);
  if (!stream) return "";
  const std::streamoff size = stream.tellg();
  if (size <= at) return "";
  at = std::max(at, size - most);
  stream.seekg(at);
  std::string text(static_cast<std::size_t>(size - at), '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(std::max<std::streamsize>(0, stream.gcount())));
  at += static_cast<std::streamoff>(text.size());
  return text;
}

std::string read_tail(const fs::path& file, std::streamoff most) {
  std::streamoff at = 0;
  return read_news(file, most, at);
}

std::vector<std::string> split_lines(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

}  // namespace talus::studio
