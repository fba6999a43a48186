// SPDX-License-Identifier: MIT
#include "studio/server.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <map>
#include <nlohmann/json.hpp>
#include <random>

#include "base/foreign_code.hpp"
#include "base/text.hpp"
#include "base/user_file.hpp"
#include "report/pack/pack.hpp"
#include "results/json.hpp"
#include "results/run.hpp"
#include "studio/comparison.hpp"
#include "studio/engine.hpp"
#include "studio/exports.hpp"
#include "studio/method_check.hpp"

namespace talus::studio {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// The page has its own files alone; icons of style sheets are data.
constexpr const char* page_policy =
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data: blob:; font-src 'self'; connect-src "
    "'self'; frame-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";
/// The script of a report is inline: the sandbox separates it from the studio and its token.
constexpr const char* report_policy =
    "sandbox allow-scripts allow-downloads allow-popups allow-modals; default-src 'none'; script-src 'unsafe-inline' "
    "'wasm-unsafe-eval' blob:; style-src 'unsafe-inline'; img-src data: blob:; font-src data:; worker-src blob:; "
    "connect-src data: blob:; base-uri 'none'; form-action 'none'; frame-ancestors 'self'";

constexpr const char* no_page =
    "<!doctype html><html lang=\"en\"><meta charset=\"utf-8\"><title>Talus Studio</title><p>This build of Talus has no "
    "page of the studio: build it with Node 20, or name its folder with --page.</p></html>";

std::string write_answer(const json& answer) {
  return answer.dump(-1, ' ', false, json::error_handler_t::replace);
}

Response make_answer(int status, const json& answer) {
  return {status, "application/json", write_answer(answer)};
}

Response make_error(int status, const std::string& sentence) {
  return make_answer(status, {{"error", sentence}});
}

/// Compares without a time that depends on the place of the first difference.
bool is_token(const std::string& given, const std::string& token) {
  unsigned difference = given.size() == token.size() ? 0 : 1;
  for (std::size_t i = 0; i < token.size(); ++i)
    difference |= static_cast<unsigned char>(token[i]) ^ static_cast<unsigned char>(i < given.size() ? given[i] : 0);
  return difference == 0;
}

const std::string& find(const std::map<std::string, std::string>& list, const char* name) {
  static const std::string none;
  const auto found = list.find(name);
  return found == list.end() ? none : found->second;
}

json read_object(const std::string& body) {
  constexpr std::size_t deepest = 32;
  json read = json::parse(
      body,
      [](int depth, json::parse_event_t, json&) {
        if (depth > static_cast<int>(deepest)) throw Refusal(400, "the JSON of the request is nested too deep");
        return true;
      },
      false);
  if (!read.is_object()) throw Refusal(400, "the body of the request must be a JSON object");
  return read;
}

std::string get_text(const json& object, const char* key, bool is_required = true) {
  const auto found = object.find(key);
  if (found != object.end() && found->is_string()) return found->get<std::string>();
  if (is_required || (found != object.end() && !found->is_null()))
    throw Refusal(400, fmt::format("the request needs '{}' as a text", key));
  return "";
}

Response answer_engine(const std::string& text) {
  return {200, "application/json", text};
}

const char* find_type(const std::string& extension) {
  static const std::map<std::string, const char*> types{
      {".html", "text/html; charset=utf-8"},
      {".js", "text/javascript; charset=utf-8"},
      {".mjs", "text/javascript; charset=utf-8"},
      {".css", "text/css; charset=utf-8"},
      {".json", "application/json"},
      {".svg", "image/svg+xml"},
      {".png", "image/png"},
      {".ico", "image/x-icon"},
      {".wasm", "application/wasm"},
      {".woff2", "font/woff2"},
      {".map", "application/json"},
      {".webmanifest", "application/manifest+json"},
      {".toml", "text/plain; charset=utf-8"},
      {".txt", "text/plain; charset=utf-8"},
  };
  const auto found = types.find(extension);
  return found == types.end() ? "application/octet-stream" : found->second;
}

void add_headers(Response& response, const char* policy) {
  response.headers.insert(response.headers.end(), {{"Content-Security-Policy", policy},
                                                   {"X-Content-Type-Options", "nosniff"},
                                                   {"Referrer-Policy", "no-referrer"},
                                                   {"Cross-Origin-Resource-Policy", "same-origin"},
                                                   {"Cache-Control", "no-store"}});
}

Response make_download(std::string bytes, const std::string& name) {
  Response response{200, "application/octet-stream", std::move(bytes)};
  response.headers.emplace_back("Content-Disposition", fmt::format("attachment; filename=\"{}\"", name));
  return response;
}

/// Returns the results of a run. Throws Refusal for a run without, such as a study.
results::RunResult read_result(const fs::path& folder) {
  auto result = results::read_file<results::RunResult>(folder / "summary.json");
  if (!result) throw Refusal(404, "this run has no results of a single case yet; a study has them in its report");
  return std::move(*result);
}

constexpr int most_searches = 4;  ///< at the same time, of calculations that take all cores
constexpr std::string_view export_part = "export.";
/// The page of the reports without data, which the studio sends to it.
constexpr std::string_view report_page = "report.html";

/// One of several requests at a time.
class Place {
 public:
  explicit Place(std::atomic<int>& taken) : taken_(taken) { ++taken_; }
  Place(const Place&) = delete;
  Place& operator=(const Place&) = delete;
  ~Place() { --taken_; }

 private:
  std::atomic<int>& taken_;
};

}  // namespace

std::string make_token() {
  std::random_device random;
  std::string token;
  for (int i = 0; i < 4; ++i) token += fmt::format("{:08x}", static_cast<std::uint32_t>(random()));
  return token;
}

fs::path find_page(const fs::path& program) {
  const fs::path beside = program.parent_path();
  for (const char* place : {"studio", "../share/talus/studio", "../../../share/talus/studio"}) {
    std::error_code failure;
    fs::path folder = fs::canonical(beside / place, failure);
    if (!failure && fs::exists(folder / "index.html", failure)) return folder;
  }
  return {};
}

std::unique_ptr<HttpServer> make_http_server() {
  std::string why;
  void* make = load_module("libtalus_http.so", "talus_make_http_server", false, why);
  if (make == nullptr)
    fail_input(
        "this build of the program has no studio, because it has no cpp-httplib ({}); 'make program "
        "CMAKE_ARGS=-DTALUS_STUDIO=ON' in its source folder adds it",
        why);
  return std::unique_ptr<HttpServer>(reinterpret_cast<MakeHttpServer>(make)());
}

StudioServer::StudioServer(ServerOptions options)
    : options_(std::move(options)),
      workspace_(options_.folder),
      runs_(workspace_, options_.program),
      asides_(workspace_) {}

Handlers StudioServer::handlers() {
  return {[this](const Request& request) { return admit(request); },
          [this](const Request& request) { return answer(request); }};
}

std::optional<Response> StudioServer::admit(const Request& request) const {
  const auto refuse = [](int status, const char* sentence) {
    Response refusal = make_error(status, sentence);
    add_headers(refusal, page_policy);
    refusal.headers.emplace_back("Connection", "close");
    return refusal;
  };
  const auto is_own = [&](const std::string& name, const char* scheme) {
    return name == fmt::format("{}127.0.0.1:{}", scheme, options_.port) ||
           name == fmt::format("{}localhost:{}", scheme, options_.port);
  };
  // A page of another site may reach this address under its own name (DNS rebinding).
  if (!is_own(find(request.headers, "host"), "")) return refuse(403, "The Host of the request is not this server.");
  if (request.headers.contains("origin") && !is_own(find(request.headers, "origin"), "http://"))
    return refuse(403, "The request comes from another page.");
  if (!request.path.starts_with("/api/") && request.path != "/api") {
    if (request.method != "GET" && request.method != "HEAD") return refuse(405, "Pages can only be read.");
    return std::nullopt;
  }
  // A stream of events and a new window have no headers of the page's own.
  const bool has_query = request.method == "GET" && request.query.contains("token");
  if (!is_token(has_query ? find(request.query, "token") : find(request.headers, "x-talus-token"), options_.token))
    return refuse(401, "The token is missing or that of another start: open the address that talus studio printed.");
  return std::nullopt;
}

Response StudioServer::answer(const Request& request) {
  Response response;
  try {
    response = route(request);
  } catch (const Refusal& refusal) {
    response = make_error(refusal.status(), refusal.what());
  } catch (const Error& error) {
    response = make_error(error.code() == ExitCode::wrong_input ? 400 : 500, error.what());
  } catch (...) {
    response = make_error(500, explain_failure(std::current_exception()).sentence);
  }
  const bool has_policy = std::any_of(response.headers.begin(), response.headers.end(),
                                      [](const auto& header) { return header.first == "Content-Security-Policy"; });
  if (!has_policy) add_headers(response, page_policy);
  return response;
}

Response StudioServer::route(const Request& request) {
  const std::string &path = request.path, &method = request.method;
  const auto is = [&](const char* verb, const char* name) { return method == verb && path == name; };
  if (!path.starts_with("/api")) return answer_page(path);
  if (is("POST", "/api/check")) return answer_engine(check(request.body, find_name(find(request.query, "path"))));
  if (is("POST", "/api/check-methods")) return answer_method_check(request);
  if (is("POST", "/api/solve")) return answer_solve(request.body);
  if (is("POST", "/api/import")) return answer_import(request.body);
  if (is("POST", "/api/export")) return answer_export(request.body);
  if (is("GET", "/api/compare")) return answer_comparison(find(request.query, "first"), find(request.query, "second"));
  if (is("GET", "/api/schema")) return answer_engine(schema());
  if (is("GET", "/api/template")) return make_answer(200, {{"text", template_text()}});
  if (is("GET", "/api/files")) {
    json list = json::array();
    for (const ListedFile& file : workspace_.list()) list.push_back({{"path", file.path}, {"revision", file.revision}});
    return make_answer(200,
                       {{"files", list}, {"folder", workspace_.folder().filename().string()}, {"open", options_.open}});
  }
  const std::string files = "/api/files/", journal = "/api/journal/", runs = "/api/runs", aside = "/api/aside/";
  if (path.starts_with(files)) return answer_file(method, path.substr(files.size()), request.body);
  if (path == "/api/journal") return answer_journal(method, "", request.body);
  if (path.starts_with(journal)) {
    if (path == journal) throw Refusal(404, "the journal of a file is at its path");
    return answer_journal(method, path.substr(journal.size()), request.body);
  }
  if (path.starts_with(aside)) return answer_aside(method, path.substr(aside.size()), request.body);
  if (path == runs || path.starts_with(runs + "/")) return answer_runs(request, path.substr(runs.size()));
  throw Refusal(404, fmt::format("there is no {} {}", method, make_printable(path)));
}

std::string StudioServer::find_name(const std::string& path) const {
  return (path.empty() ? workspace_.folder() / unnamed_case : workspace_.find(path)).string();
}

Response StudioServer::answer_method_check(const Request& request) {
  const Place place(searches_);
  if (searches_ > most_searches) throw Refusal(503, "other calculations are in progress; wait for them");
  return answer_engine(check_methods(request.body, find_name(find(request.query, "path"))));
}

Response StudioServer::answer_export(const std::string& body) {
  const json asked = read_object(body);
  const std::string text = get_text(asked, "text"), path = get_text(asked, "path", false);
  const Place place(searches_);
  if (searches_ > most_searches) throw Refusal(503, "other calculations are in progress; wait for them");
  return make_download(export_case(workspace_, options_.program, text, path), "case.dxf");
}

Response StudioServer::answer_comparison(const std::string& first, const std::string& second) const {
  return make_answer(200, compare_runs(read_result(runs_.find_folder(first)), read_result(runs_.find_folder(second))));
}

Response StudioServer::answer_run_export(const std::string& id, const std::string& format) {
  const Place place(searches_);
  if (searches_ > most_searches) throw Refusal(503, "other calculations are in progress; wait for them");
  return make_download(export_results(workspace_, options_.program, runs_.find_folder(id), format),
                       fmt::format("run-{}.{}", id, format));
}

Response StudioServer::answer_solve(const std::string& body) {
  const json asked = read_object(body);
  const std::string text = get_text(asked, "text"), name = find_name(get_text(asked, "path", false));
  json options = asked.value("options", json::object());
  // A quick search takes milliseconds, in which threads cost more than they save where a run takes all cores.
  if (options.is_object() && !options.contains("threads"))
    options["threads"] = options.contains("circles") ? 1 : options_.threads;
  const Place place(searches_);
  if (searches_ > most_searches) throw Refusal(503, "other calculations are in progress; wait for them");
  return answer_engine(solve(text, write_answer(options), name));
}

Response StudioServer::answer_file(const std::string& method, const std::string& path, const std::string& body) {
  if (method == "GET") {
    const RevisedText file = workspace_.read(path);
    return make_answer(200, {{"text", file.text}, {"revision", file.revision}});
  }
  if (method != "PUT") throw Refusal(405, "a file can be read and written");
  const json given = read_object(body);
  const auto revision = workspace_.write(path, get_text(given, "text"), get_text(given, "revision", false));
  if (revision) return make_answer(200, {{"revision", *revision}});
  const bool exists = fs::exists(workspace_.find(path));
  const RevisedText now = exists ? workspace_.read(path) : RevisedText{};
  return make_answer(409, {{"text", now.text}, {"revision", now.revision}});
}

Response StudioServer::answer_journal(const std::string& method, const std::string& path, const std::string& body) {
  if (method == "GET") {
    json entries = json::array();
    for (const JournalEntry& entry : workspace_.read_journal(path))
      entries.push_back({{"window", entry.window},
                         {"text", entry.text},
                         {"base", entry.base},
                         {"revision", entry.revision},
                         {"time", entry.time}});
    return make_answer(200, {{"entries", entries}});
  }
  if (method != "PUT") throw Refusal(405, "a journal can be read and written");
  const json given = read_object(body);
  const std::string window = get_text(given, "window", false);
  if (const auto text = given.find("text"); text != given.end() && text->is_null()) {
    workspace_.remove_journal(path, window);
    return make_answer(200, json::object());
  }
  const std::chrono::duration<double> now = std::chrono::system_clock::now().time_since_epoch();
  workspace_.write_journal(path, {window, get_text(given, "text"), get_text(given, "base", false),
                                  get_text(given, "revision", false), now.count()});
  return make_answer(200, json::object());
}

Response StudioServer::answer_import(const std::string& body) {
  constexpr int most_imports = 2;
  const Place place(imports_);
  if (imports_ > most_imports) throw Refusal(503, "other files are being imported; wait for them");
  return answer_engine(import_dropped(workspace_, options_.program, body));
}

Response StudioServer::answer_aside(const std::string& method, const std::string& name, const std::string& body) {
  if (method == "GET") return answer_engine(asides_.read(name));
  if (method != "PUT") throw Refusal(405, "a note can be read and written");
  asides_.write(name, body);
  return make_answer(200, json::object());
}

Response StudioServer::answer_report_data(const std::string& id, const std::string& known) {
  constexpr int most_reports = 2;
  const Place place(reports_);
  if (reports_ > most_reports) throw Refusal(503, "other reports are being made; wait for them");
  json head{{"active", runs_.is_active(id)}};  // before the results, which are then complete for a run that has ended
  try {
    const fs::path results = runs_.find_folder(id);
    const std::string stamp = stamp_results(results);
    head["stamp"] = stamp;
    if (stamp == known) return make_answer(200, head);
    std::string answer = write_answer(head);
    answer.pop_back();
    return answer_engine(answer + ",\"data\":" + read_report_data(workspace_, options_.program, results) + "}");
  } catch (const Refusal& refusal) {
    if (refusal.status() >= 500) throw;
    head["why"] = refusal.what();  // before its first results a run in progress has no report
    return make_answer(200, head);
  }
}

Response StudioServer::answer_runs(const Request& request, const std::string& rest) {
  const std::string &method = request.method, &body = request.body;
  if (rest.empty() && method == "GET") return make_answer(200, {{"runs", runs_.list()}});
  if (rest.empty() && method == "POST") {
    const json given = read_object(body);
    return make_answer(200, {{"id", runs_.add(get_text(given, "path"), given.value("settings", json()))}});
  }
  const std::size_t slash = rest.find('/', 1);
  if (rest.empty() || slash == std::string::npos) throw Refusal(404, "there is no such part of a run");
  const std::string id = rest.substr(1, slash - 1), part = rest.substr(slash + 1);
  if (method == "POST" && part == "stop")
    runs_.stop(id);
  else if (method == "POST" && part == "resume")
    runs_.resume(id);
  else if (method == "GET" && part == "events")
    return watch_run(id);
  else if (method == "GET" && part == "values")
    return make_answer(200, list_run(read_result(runs_.find_folder(id))));
  else if (method == "GET" && part == "report-data")
    return answer_report_data(id, find(request.query, "known"));
  else if (method == "GET" && part.starts_with(export_part))
    return answer_run_export(id, part.substr(export_part.size()));
  else if (method == "GET" && part == "report") {
    Response page{200, "text/html; charset=utf-8", read_user_file(runs_.find_report(id), largest_file::result)};
    add_headers(page, report_policy);
    return page;
  } else
    throw Refusal(404, "there is no such part of a run");
  return make_answer(200, json::object());
}

Response StudioServer::watch_run(const std::string& id) {
  constexpr int most_streams = 24;
  const auto place = std::make_shared<Place>(streams_);
  if (streams_ > most_streams) throw Refusal(503, "too many windows follow runs; close some of them");
  Response response;
  response.type = "text/event-stream";
  response.stream = [place, next = runs_.watch(id)](std::string& piece) { return next(piece); };
  return response;
}

Response StudioServer::answer_page(const std::string& path) const {
  const std::string name = path == "/" ? "index.html" : path.substr(1);
  if (name == report_page) {
    Response page{200, "text/html; charset=utf-8", std::string(report::get_page())};
    add_headers(page, report_policy);
    return page;
  }
  if (options_.page.empty()) {
    if (name == "index.html") return {200, "text/html; charset=utf-8", no_page};
    throw Refusal(404, "there is no such page");
  }
  const fs::path parts(name);
  for (const fs::path& part : parts)
    if (!find_name_fault(part.string()).empty() || part.string().starts_with('.'))
      throw Refusal(404, "there is no such page");
  const fs::path file = options_.page / parts;
  std::string text;
  std::error_code failure;
  if (fs::canonical(file, failure) != file || failure || try_user_file(file, largest_file::table, text))
    throw Refusal(404, "there is no such page");
  return {200, find_type(file.extension().string()), std::move(text)};
}

}  // namespace talus::studio
