// SPDX-License-Identifier: MIT
// The module libtalus_http.so: HTTP by cpp-httplib.
#include <httplib.h>

#include <algorithm>
#include <exception>

#include "studio/http.hpp"

namespace talus::studio {
namespace {

/// Streams of events wait in a thread each.
constexpr std::size_t threads = 40;
constexpr time_t patience = 10;  ///< for a client that sends or receives nothing [s]

Request convert(const httplib::Request& from) {
  Request to;
  to.method = from.method;
  to.path = from.path;
  for (const auto& [name, value] : from.headers) {
    std::string small = name;
    for (char& c : small)
      if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    // Two values of one name are ambiguous; a token or a host that is given twice is refused as the join of both.
    auto [found, is_new] = to.headers.emplace(small, value);
    if (!is_new) found->second += ", " + value;
  }
  for (const auto& [name, value] : from.params) to.query.emplace(name, value);
  to.body = from.body;
  return to;
}

void convert(Response&& from, httplib::Response& to) {
  to.status = from.status;
  for (const auto& [name, value] : from.headers) to.set_header(name, value);
  if (!from.stream) {
    to.set_content(from.body, from.type);
    return;
  }
  to.set_chunked_content_provider(from.type, [next = std::move(from.stream)](std::size_t, httplib::DataSink& sink) {
    std::string piece;
    const bool has_more = next(piece);
    if (!piece.empty() && !sink.write(piece.data(), piece.size())) return false;
    if (!has_more) sink.done();
    return sink.is_writable();
  });
}

class ServerByHttplib : public HttpServer {
 public:
  int bind(int port) override {
    const std::string loopback = "127.0.0.1";
    if (port == 0) return std::max(0, server_.bind_to_any_port(loopback));
    return server_.bind_to_port(loopback, port) ? port : 0;
  }

  void serve(const Handlers& handlers, std::size_t largest_body) override {
    server_.new_task_queue = [] { return new httplib::ThreadPool(threads); };
    server_.set_payload_max_length(largest_body);
    server_.set_keep_alive_max_count(1000);
    server_.set_keep_alive_timeout(2);
    server_.set_read_timeout(patience);
    server_.set_write_timeout(patience);
    server_.set_tcp_nodelay(true);
    server_.set_pre_routing_handler([&](const httplib::Request& request, httplib::Response& response) {
      std::optional<Response> refusal = handlers.admit(convert(request));
      if (!refusal) return httplib::Server::HandlerResponse::Unhandled;
      convert(std::move(*refusal), response);
      return httplib::Server::HandlerResponse::Handled;
    });
    const auto answer = [&](const httplib::Request& request, httplib::Response& response) {
      convert(handlers.answer(convert(request)), response);
    };
    const std::string any = "[\\s\\S]*";
    server_.Get(any, answer).Post(any, answer).Put(any, answer).Delete(any, answer);
    server_.set_exception_handler([](const httplib::Request&, httplib::Response& response, const std::exception_ptr&) {
      response.status = 500;
      response.set_content("{\"error\":\"The server failed at this request.\"}", "application/json");
    });
    server_.listen_after_bind();
  }

  void stop() override { server_.stop(); }

 private:
  httplib::Server server_;
};

}  // namespace
}  // namespace talus::studio

extern "C" talus::studio::HttpServer* talus_make_http_server() {
  return new talus::studio::ServerByHttplib;
}
