// SPDX-License-Identifier: MIT
#pragma once
// Runs of the studio: child processes `talus run`, one at a time, in a queue that is kept in the folder. The state of a
// run is a file; servers of one folder share the queue, and one of them starts the runs.

#include <atomic>
#include <condition_variable>
#include <filesystem>
#include <mutex>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "studio/http.hpp"
#include "studio/workspace.hpp"

namespace talus::studio {

enum class RunState { waiting, running, done, failed, stopped };

/// A run as stored in `.talus-studio/runs/ID.json`.
struct StudioRun {
  std::string id;        ///< "0001"
  std::string path;      ///< case file, below the folder
  std::string revision;  ///< of the text that is run
  std::vector<std::string> overrides;
  int threads = 0;        ///< 0: the default of `talus run`
  bool is_study = false;  ///< `talus study` in place of `talus run`
  RunState state = RunState::waiting;
  bool resumes = false;
  bool is_stopping = false;
  int process = 0;
  std::string process_start;  ///< of /proc, which identifies the process after a restart
  std::string message;        ///< why it failed
  std::optional<double> factor;
};

class RunQueue {
 public:
  /// `program` is executed as `program run …`. Starts the thread that runs the queue.
  RunQueue(const Workspace& workspace, std::filesystem::path program);
  RunQueue(const RunQueue&) = delete;
  RunQueue& operator=(const RunQueue&) = delete;
  /// Ends the thread. A run that is in progress goes on, and a later queue of the folder finds it.
  ~RunQueue();

  /// Ends the thread and all streams of events.
  void end();

  /// Adds a run of the case file as it is now. `settings`: {"set": {key: value}, "threads": n, "study": true for
  /// `talus study`}. Throws Refusal.
  std::string add(const std::string& path, const nlohmann::json& settings);
  /// Returns all runs, the newest first: {id, path, revision, state, progress, message, factor, folder}.
  nlohmann::json list() const;
  /// Removes a waiting run from the queue; asks a running one to save its state and end, the second time at once.
  void stop(const std::string& id);
  /// Continues a stopped or failed run in its folder.
  void resume(const std::string& id);
  /// Returns server-sent events: those of RunFollower, and at last `done` {state, …}.
  Response::Stream watch(const std::string& id) const;
  /// Returns the folder of results of a run. Throws Refusal (404) if there is none yet.
  std::filesystem::path find_folder(const std::string& id) const;
  /// Returns true if a run waits or is in progress. Throws Refusal (404) if there is no such run.
  bool is_active(const std::string& id) const;
  /// Returns the report of a run. Throws Refusal (404) if there is none yet.
  std::filesystem::path find_report(const std::string& id) const;

 private:
  std::filesystem::path find_state(const std::string& id) const;
  std::filesystem::path find_log(const std::string& id) const;
  std::filesystem::path find_results(const std::string& id) const;
  std::filesystem::path find_snapshot(const StudioRun& run) const;
  std::vector<StudioRun> read_all() const;
  StudioRun read(const std::string& id) const;
  void store(const StudioRun& run) const;
  nlohmann::json describe(const StudioRun& run) const;

  void work();
  /// Starts the next run, or examines the one in progress. Requires the lock of the states.
  void advance();
  void start(StudioRun& run);
  /// Returns true if the process has ended; `code` is its exit code if it was a child of this process.
  bool has_ended(const StudioRun& run, std::optional<int>& code) const;
  void finish(StudioRun& run, std::optional<int> code) const;

  const Workspace& workspace_;
  std::filesystem::path program_;
  std::atomic<bool> ends_{false};
  mutable std::mutex mutex_;
  mutable std::condition_variable wakes_;
  std::optional<FileLock> leads_;  ///< held by the server that starts the runs
  std::thread worker_;
};

}  // namespace talus::studio
