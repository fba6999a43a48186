// SPDX-License-Identifier: MIT
#pragma once
// The server of the studio: routes of its interface over the engine, the files and the runs of a folder
// (docs/decisions/0052-studio-server.md). Requests are refused before they are read unless they come from the page
// itself.

#include <atomic>
#include <filesystem>
#include <mutex>
#include <string>

#include "studio/http.hpp"
#include "studio/imports.hpp"
#include "studio/run_queue.hpp"
#include "studio/workspace.hpp"

namespace talus::studio {

struct ServerOptions {
  std::filesystem::path folder;   ///< with the case files
  std::string open;               ///< case file that the page opens, below the folder; may be empty
  std::filesystem::path page;     ///< folder of the page; empty: none was built
  std::filesystem::path program;  ///< for `talus run`
  std::string token;              ///< of make_token()
  int port = 0;                   ///< at which the server listens
  int threads = 1;                ///< of a search
};

/// Returns 128 random bits as text.
std::string make_token();

/// Returns the folder of the page beside a program or in its installation; empty if there is none.
std::filesystem::path find_page(const std::filesystem::path& program);

/// Largest body of a request [bytes]: a case file in JSON, in which a character may have six bytes.
inline constexpr std::size_t largest_body = 64'000'000;

class StudioServer {
 public:
  explicit StudioServer(ServerOptions options);
  /// Refuses requests of other pages: wrong Host, Origin or token.
  std::optional<Response> admit(const Request& request) const;
  /// Answers a request that was admitted. Does not throw.
  Response answer(const Request& request);
  Handlers handlers();
  /// Ends the streams of events, so that the server can stop.
  void end_streams() { runs_.end(); }

 private:
  Response route(const Request& request);
  /// Returns the name of a text for the engine, whose folder is that of its tables. Throws Refusal for a bad path.
  std::string find_name(const std::string& path) const;
  Response answer_method_check(const Request& request);
  Response answer_solve(const std::string& body);
  Response answer_export(const std::string& body);
  Response answer_comparison(const std::string& first, const std::string& second) const;
  Response answer_run_export(const std::string& id, const std::string& format);
  Response answer_file(const std::string& method, const std::string& path, const std::string& body);
  Response answer_journal(const std::string& method, const std::string& path, const std::string& body);
  Response answer_runs(const Request& request, const std::string& rest);
  /// Returns {active, stamp, data}, the data of the report of a run; without them if the results still have the stamp
  /// `known`, and with `why` if there are none yet.
  Response answer_report_data(const std::string& id, const std::string& known);
  /// Imports dropped files: a few at a time, because each is a process.
  Response answer_import(const std::string& body);
  Response answer_aside(const std::string& method, const std::string& name, const std::string& body);
  Response answer_page(const std::string& path) const;
  Response watch_run(const std::string& id);

  const ServerOptions options_;
  const Workspace workspace_;
  RunQueue runs_;
  const Asides asides_;
  std::atomic<int> streams_{0}, searches_{0}, imports_{0}, reports_{0};
};

}  // namespace talus::studio
