// SPDX-License-Identifier: MIT
#include "studio/run_queue.hpp"

#include <fmt/format.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <nlohmann/json.hpp>

#include "base/atomic_file.hpp"
#include "base/text.hpp"
#include "base/user_file.hpp"
#include "results/governing.hpp"
#include "results/json.hpp"
#include "results/run.hpp"
#include "studio/process.hpp"
#include "studio/run_progress.hpp"

namespace talus::studio {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using std::chrono::milliseconds;

constexpr std::array state_words{"waiting", "running", "done", "failed", "stopped"};
constexpr const char* results_folder = "studio_runs";
constexpr milliseconds pause{100};  ///< between looks at a process or a log

const char* get_word(RunState state) {
  return state_words[static_cast<std::size_t>(state)];
}

json to_json(const StudioRun& run) {
  json out{{"id", run.id},
           {"path", run.path},
           {"revision", run.revision},
           {"set", run.overrides},
           {"threads", run.threads},
           {"is_study", run.is_study},
           {"state", get_word(run.state)},
           {"resumes", run.resumes},
           {"is_stopping", run.is_stopping},
           {"process", run.process},
           {"process_start", run.process_start},
           {"message", run.message},
           {"factor", nullptr}};
  if (run.factor) out["factor"] = *run.factor;
  return out;
}

StudioRun from_json(const json& in) {
  StudioRun run;
  run.id = in.at("id").get<std::string>();
  run.path = in.at("path").get<std::string>();
  run.revision = in.at("revision").get<std::string>();
  run.overrides = in.at("set").get<std::vector<std::string>>();
  run.threads = in.at("threads").get<int>();
  run.is_study = in.value("is_study", false);
  const auto word = std::find(state_words.begin(), state_words.end(), in.at("state").get<std::string>());
  if (word == state_words.end()) throw Refusal(500, "the state of a run is damaged");
  run.state = static_cast<RunState>(word - state_words.begin());
  run.resumes = in.at("resumes").get<bool>();
  run.is_stopping = in.at("is_stopping").get<bool>();
  run.process = in.at("process").get<int>();
  run.process_start = in.at("process_start").get<std::string>();
  run.message = in.at("message").get<std::string>();
  if (in.at("factor").is_number()) run.factor = in.at("factor").get<double>();
  return run;
}

std::vector<std::string> read_overrides(const json& settings) {
  constexpr std::size_t most = 200, longest = 1000;
  std::vector<std::string> list;
  const auto set = settings.find("set");
  if (set == settings.end()) return list;
  if (!set->is_object() || set->size() > most)
    throw Refusal(400, fmt::format("'set' must be an object with at most {} keys of the case", most));
  for (const auto& [key, value] : set->items()) {
    const std::string text = value.is_string() ? value.get<std::string>() : value.dump();
    std::string change = fmt::format("{}={}", key, text);
    if (key.empty() || key.find('=') != std::string::npos || change.size() > longest ||
        change.find('\0') != std::string::npos)
      throw Refusal(400, fmt::format("'{}' cannot be set", make_printable(key)));
    list.push_back(std::move(change));
  }
  return list;
}

}  // namespace

RunQueue::RunQueue(const Workspace& workspace, fs::path program)
    : workspace_(workspace), program_(std::move(program)), worker_([this] { work(); }) {}

RunQueue::~RunQueue() {
  end();
  worker_.join();
}

void RunQueue::end() {
  ends_ = true;
  wakes_.notify_all();
}

fs::path RunQueue::find_state(const std::string& id) const {
  constexpr std::size_t longest = 9;
  if (id.empty() || id.size() > longest || id.find_first_not_of("0123456789") != std::string::npos)
    throw Refusal(404, "there is no such run");
  return workspace_.state() / "runs" / (id + ".json");
}
fs::path RunQueue::find_log(const std::string& id) const {
  return workspace_.state() / "runs" / (id + ".log");
}
fs::path RunQueue::find_results(const std::string& id) const {
  return workspace_.folder() / results_folder / id;
}
fs::path RunQueue::find_snapshot(const StudioRun& run) const {
  // Beside the case, because its tables and meshes are named relative to it.
  const fs::path file = workspace_.find(run.path);
  return file.parent_path() / fmt::format(".{}-{}.toml", file.stem().string(), run.id);
}

StudioRun RunQueue::read(const std::string& id) const {
  std::string text;
  if (try_user_file(find_state(id), largest_file::megabyte, text)) throw Refusal(404, "there is no such run");
  const json state = json::parse(text, nullptr, false);
  try {
    StudioRun run = from_json(state);
    if (run.id != id) throw Refusal(500, "the state of this run is damaged");
    return run;
  } catch (const json::exception&) {
    throw Refusal(500, "the state of this run is damaged");
  }
}

std::vector<StudioRun> RunQueue::read_all() const {
  std::vector<StudioRun> runs;
  std::error_code failure;
  for (const auto& entry : fs::directory_iterator(workspace_.state() / "runs", failure)) {
    if (entry.path().extension() != ".json") continue;
    try {
      runs.push_back(read(entry.path().stem().string()));
    } catch (const Refusal&) {
      continue;  // a damaged state must not end the queue
    }
  }
  std::sort(runs.begin(), runs.end(), [](const StudioRun& a, const StudioRun& b) { return a.id < b.id; });
  return runs;
}

void RunQueue::store(const StudioRun& run) const {
  write_atomically(find_state(run.id), to_json(run).dump(2, ' ', false, json::error_handler_t::replace) + "\n");
}

json RunQueue::describe(const StudioRun& run) const {
  json out{{"id", run.id},
           {"path", run.path},
           {"revision", run.revision},
           {"state", get_word(run.state)},
           {"is_study", run.is_study},
           {"is_stopping", run.is_stopping},
           {"message", run.message},
           {"factor", nullptr},
           {"folder", fmt::format("{}/{}", results_folder, run.id)}};
  if (run.factor) out["factor"] = *run.factor;
  if (run.state == RunState::done) out["progress"] = 1;
  if (run.state != RunState::running) return out;
  const json progress = find_last_progress(find_log(run.id));
  if (progress.is_null()) return out;
  out["message"] = progress["line"];
  if (progress.contains("fraction")) out["progress"] = progress["fraction"];
  return out;
}

std::string RunQueue::add(const std::string& path, const json& settings) {
  constexpr std::size_t most_waiting = 200;
  constexpr int most_threads = 1024;
  const RevisedText text = workspace_.read(path);
  StudioRun run;
  run.path = path;
  run.revision = text.revision;
  if (!settings.is_null() && !settings.is_object()) throw Refusal(400, "'settings' must be an object");
  if (settings.is_object()) {
    run.overrides = read_overrides(settings);
    const auto study = settings.find("study");
    if (study != settings.end()) {
      if (!study->is_boolean()) throw Refusal(400, "'study' must be true or false");
      run.is_study = study->get<bool>();
    }
    const auto threads = settings.find("threads");
    if (threads != settings.end()) {
      if (!threads->is_number_integer() || threads->get<double>() < 1 || threads->get<double>() > most_threads)
        throw Refusal(400, fmt::format("'threads' must be a whole number from 1 to {}", most_threads));
      run.threads = threads->get<int>();
    }
  }
  const FileLock lock(workspace_.state() / "runs.lock");
  const std::vector<StudioRun> all = read_all();
  if (std::count_if(all.begin(), all.end(), [](const StudioRun& r) { return r.state == RunState::waiting; }) >=
      static_cast<std::ptrdiff_t>(most_waiting))
    throw Refusal(503, fmt::format("{} runs are waiting; stop some of them first", most_waiting));
  int number = all.empty() ? 1 : std::stoi(all.back().id) + 1;
  do run.id = fmt::format("{:04}", number++);
  while (fs::exists(find_results(run.id)) || fs::exists(find_state(run.id)));
  write_atomically(find_snapshot(run), text.text);
  store(run);
  wakes_.notify_all();
  return run.id;
}

json RunQueue::list() const {
  json list = json::array();
  const std::vector<StudioRun> all = read_all();
  for (auto run = all.rbegin(); run != all.rend(); ++run) list.push_back(describe(*run));
  return list;
}

void RunQueue::stop(const std::string& id) {
  const FileLock lock(workspace_.state() / "runs.lock");
  StudioRun run = read(id);
  if (run.state == RunState::waiting) run.state = RunState::stopped;
  if (run.state == RunState::running && find_process_start(run.process) == run.process_start) {
    kill(run.process, run.is_stopping ? SIGKILL : SIGINT);
    run.is_stopping = true;
  }
  store(run);
  wakes_.notify_all();
}

void RunQueue::resume(const std::string& id) {
  const FileLock lock(workspace_.state() / "runs.lock");
  StudioRun run = read(id);
  if (run.state != RunState::stopped && run.state != RunState::failed)
    throw Refusal(409,
                  fmt::format("run {} is {}; only a stopped or failed run can be resumed", id, get_word(run.state)));
  if (!fs::exists(find_snapshot(run)))
    throw Refusal(409, fmt::format("the text of run {} is missing; start a new run", id));
  run.state = RunState::waiting;
  run.is_stopping = false;
  run.resumes = true;
  run.message.clear();
  store(run);
  wakes_.notify_all();
}

fs::path RunQueue::find_folder(const std::string& id) const {
  read(id);
  fs::path folder = find_results(id);
  std::error_code failure;
  if (fs::canonical(folder, failure) != folder || failure || !fs::is_directory(folder))
    throw Refusal(404, fmt::format("run {} has no results yet", id));
  return folder;
}

bool RunQueue::is_active(const std::string& id) const {
  const RunState state = read(id).state;
  return state == RunState::waiting || state == RunState::running;
}

fs::path RunQueue::find_report(const std::string& id) const {
  read(id);
  fs::path report = find_results(id) / "report.html";
  std::error_code failure;
  if (fs::canonical(report, failure) != report || failure)
    throw Refusal(404, fmt::format("run {} has no report yet", id));
  return report;
}

Response::Stream RunQueue::watch(const std::string& id) const {
  read(id);
  const auto follower = std::make_shared<RunFollower>(find_log(id), find_results(id));
  return [this, id, follower, has_begun = false](std::string& piece) mutable {
    StudioRun run;
    try {
      run = read(id);  // before the log, which is then complete for a run that has ended
    } catch (const Refusal& refusal) {
      add_event(piece, "done", {{"id", id}, {"state", "failed"}, {"message", refusal.what()}});
      return false;
    }
    if (!has_begun) add_event(piece, "progress", describe(run));
    has_begun = true;
    follower->add_news(piece);
    if (run.state != RunState::waiting && run.state != RunState::running) {
      add_event(piece, "done", describe(run));
      return false;
    }
    if (ends_) return false;
    if (!piece.empty()) return true;
    std::unique_lock lock(mutex_);
    wakes_.wait_for(lock, 2 * pause, [this] { return ends_.load(); });
    piece = ":\n";  // a comment, at which a client that has gone is noticed
    return true;
  };
}

void RunQueue::work() {
  while (!ends_) {
    try {
      if (leads_ || FileLock::try_lock(workspace_.state() / "queue.lock", leads_)) {
        const FileLock lock(workspace_.state() / "runs.lock");
        advance();
      }
    } catch (const std::exception& error) {
      // A full disk, for example: the queue waits for better times.
      print(stderr, fmt::format("talus: warning: the queue of runs cannot go on: {}\n", error.what()));
      std::unique_lock lock(mutex_);
      wakes_.wait_for(lock, 50 * pause, [this] { return ends_.load(); });
    }
    std::unique_lock lock(mutex_);
    wakes_.wait_for(lock, pause, [this] { return ends_.load(); });
  }
}

void RunQueue::advance() {
  std::vector<StudioRun> all = read_all();
  for (StudioRun& run : all) {
    if (run.state != RunState::running) continue;
    std::optional<int> code;
    if (!has_ended(run, code)) return;
    finish(run, code);
    store(run);
  }
  for (StudioRun& run : all)
    if (run.state == RunState::waiting) {
      start(run);
      store(run);
      return;
    }
}

void RunQueue::start(StudioRun& run) {
  make_own_folder(workspace_.folder() / results_folder);
  const fs::path results = find_results(run.id), snapshot = find_snapshot(run), log = find_log(run.id);
  std::vector<std::string> arguments{
      "talus", run.is_study ? "study" : "run", snapshot.string(), "-o", results.string(), "--progress-lines"};
  if (!run.is_study) arguments.emplace_back("--live");
  if (run.resumes && fs::exists(results)) arguments.emplace_back("--resume");
  if (run.threads > 0) {
    arguments.emplace_back("--threads");
    arguments.push_back(std::to_string(run.threads));
  }
  for (const std::string& change : run.overrides) arguments.push_back("--set=" + change);
  std::string why;
  const int process = start_process(program_, std::move(arguments), {log, {}}, why);
  if (process == 0) {
    run.state = RunState::failed;
    run.message = why;
    return;
  }
  run.state = RunState::running;
  run.process = process;
  run.process_start = find_process_start(process);
}

bool RunQueue::has_ended(const StudioRun& run, std::optional<int>& code) const {
  if (run.process <= 1) return true;
  int status = 0;
  const pid_t ended = waitpid(run.process, &status, WNOHANG);
  if (ended == run.process) {
    code = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
    return true;
  }
  if (ended == 0) return false;
  // The child of an earlier server.
  const std::string start = find_process_start(run.process);
  return start.empty() || start != run.process_start;
}

void RunQueue::finish(StudioRun& run, std::optional<int> code) const {
  const auto result = results::find_file<results::RunResult>(find_results(run.id) / "summary.json");
  auto status = result ? result->status : results::Status::unfinished;
  // A study ends with its report.
  if (run.is_study && fs::exists(find_results(run.id) / "report.html")) status = results::Status::finished;
  const bool is_interrupted = code ? *code == static_cast<int>(ExitCode::interrupted) || *code < 0
                                   : status == results::Status::interrupted || status == results::Status::unfinished;
  const bool is_done = code ? *code == 0 : status == results::Status::finished;
  run.state = is_done ? RunState::done : is_interrupted ? RunState::stopped : RunState::failed;
  run.process = 0;
  run.process_start.clear();
  run.is_stopping = false;
  if (result) run.factor = results::find_main_factor(*result);
  if (run.state == RunState::failed) run.message = find_last_sentence(find_log(run.id));
  std::error_code ignored;
  if (run.state == RunState::done) fs::remove(find_snapshot(run), ignored);
}

}  // namespace talus::studio
