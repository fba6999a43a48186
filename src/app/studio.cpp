// SPDX-License-Identifier: MIT
// `talus studio [CASE | FOLDER]`: serves the studio on the loopback address until a signal arrives.
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <memory>
#include <thread>

#include "app/command_line.hpp"
#include "base/error.hpp"
#include "base/foreign_code.hpp"
#include "base/parallel.hpp"
#include "base/progress.hpp"
#include "base/text.hpp"
#include "studio/server.hpp"

namespace talus::app {
namespace {

namespace fs = std::filesystem;

struct StudioCommand {
  std::string target = ".";
  int port = 0, threads = 0;
  bool stays_closed = false;
  fs::path page;
};

constexpr int most_ports = 65535;

fs::path find_program() {
  std::error_code failure;
  fs::path program = fs::read_symlink("/proc/self/exe", failure);
  if (failure) fail_input("the studio needs /proc to start runs: {}", failure.message());
  return program;
}

/// Opens the address in the browser of the desktop, if there is a desktop.
void open_browser(std::string address) {
  if (std::getenv("DISPLAY") == nullptr && std::getenv("WAYLAND_DISPLAY") == nullptr) return;
  std::string opener = "xdg-open";
  char* arguments[] = {opener.data(), address.data(), nullptr};
  pid_t process = 0;
  if (spawn_program(process, opener.c_str(), nullptr, arguments) == 0)
    std::thread([process] { waitpid(process, nullptr, 0); }).detach();
}

void serve(const StudioCommand& command) {
  studio::ServerOptions options;
  const fs::path target = command.target;
  const bool is_folder = fs::is_directory(target);
  if (!is_folder && !fs::exists(target)) fail_input("there is no file or folder '{}'", command.target);
  options.folder = is_folder ? target : fs::absolute(target).parent_path();
  if (!is_folder) options.open = target.filename().string();
  options.program = find_program();
  options.page = command.page.empty() ? studio::find_page(options.program) : fs::canonical(command.page);
  options.token = studio::make_token();
  options.threads = command.threads > 0 ? command.threads : default_threads();
  const std::unique_ptr<studio::HttpServer> server = studio::make_http_server();
  options.port = server->bind(command.port);
  if (options.port == 0) fail_input("port {} cannot be used; leave --port out for a free one", command.port);
  const std::string address = fmt::format("http://127.0.0.1:{}/#{}", options.port, options.token);
  studio::StudioServer studio(options);
  catch_interrupts();
  std::exception_ptr failure;
  std::atomic<bool> has_ended{false};
  std::thread serving([&] {
    try {
      server->serve(studio.handlers(), studio::largest_body);
    } catch (...) {
      failure = std::current_exception();
    }
    has_ended = true;
  });
  print(stdout, fmt::format("Talus studio: {}\nCtrl-C ends it; runs go on, and the next start shows them.\n", address));
  std::fflush(stdout);
  if (!command.stays_closed) open_browser(address);
  while (!is_interrupted() && !has_ended) std::this_thread::sleep_for(std::chrono::milliseconds(50));
  studio.end_streams();
  server->stop();
  serving.join();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace

void add_studio(CLI::App& app) {
  const Command command(app, "studio", "Draw, run and read cases in the browser, from a server on this machine alone");
  const auto options = std::make_shared<StudioCommand>();
  command.take("TARGET", options->target, "Case file to open, or folder of case files (default: this folder)")
      .shown_as("CASE|FOLDER");
  command.take("--port", options->port, "Port of the server (default: a free one)").positive(most_ports);
  command.take("--threads", options->threads, "Threads of a whole search by LEM (default: all cores)")
      .positive(most_threads);
  command.flag("--no-open", options->stays_closed, "Print the address and open no browser");
  command.take("--page", options->page, "Folder of the page, for its development").shown_as("FOLDER");
  command.act([options] { serve(*options); });
}

}  // namespace talus::app
