// SPDX-License-Identifier: MIT
#pragma once
// Requests and responses of HTTP, and the interface of the module libtalus_http.so, which serves them: only that module
// includes cpp-httplib.

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace talus::studio {

struct Request {
  std::string method, path;                    ///< the path is decoded
  std::map<std::string, std::string> headers;  ///< names in small letters; of several the first
  std::map<std::string, std::string> query;
  std::string body;
};

struct Response {
  /// Waits for the next piece of a stream, for at most a second. Returns false at its end.
  using Stream = std::function<bool(std::string& piece)>;

  int status = 200;
  std::string type = "application/json";
  std::string body;
  std::vector<std::pair<std::string, std::string>> headers{};
  Stream stream{};  ///< in place of the body
};

struct Handlers {
  /// Called before the body is read; a response refuses the request.
  std::function<std::optional<Response>(const Request&)> admit;
  std::function<Response(const Request&)> answer;
};

/// Listens on the loopback address 127.0.0.1 alone.
class HttpServer {
 public:
  virtual ~HttpServer() = default;
  /// Binds a port; 0: a free one. Returns the port, or 0 if it is in use.
  virtual int bind(int port) = 0;
  /// Serves until stop(); requests are handled by several threads.
  virtual void serve(const Handlers& handlers, std::size_t largest_body) = 0;
  virtual void stop() = 0;
};

/// Loads the module. Throws Error (wrong_input) if this build has none.
std::unique_ptr<HttpServer> make_http_server();

/// The function of the module.
using MakeHttpServer = HttpServer* (*)();

}  // namespace talus::studio
