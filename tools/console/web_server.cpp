#include "tools/console/web_server.hpp"

#include "common/error.hpp"
#include "experiments/run/request_box.hpp"
#include "tools/console/bounded_queue.hpp"
#include "tools/console/bounded_stream.hpp"

#include <pthread.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace evbal {
namespace {

using namespace std::chrono_literals;

constexpr int most_watching = 4;
constexpr std::size_t threads = 8;   // watchers, and some for questions
constexpr std::size_t waiting = 16;  // connections

std::vector<std::string> headers(const httplib::Request& request, const std::string& name) {
  std::vector<std::string> values;
  const auto [first, last] = request.headers.equal_range(name);
  for (auto header = first; header != last; ++header) {
    values.push_back(header->second);
  }
  return values;
}

std::optional<std::size_t> length_of(const httplib::Request& request) {
  const auto given = headers(request, "Content-Length");
  const bool number = given.size() == 1 && !given.front().empty() && given.front().size() < 10 &&
                      given.front().find_first_not_of("0123456789") == std::string::npos;
  return number ? std::optional<std::size_t>(std::stoul(given.front())) : std::nullopt;
}

Caller caller_of(const httplib::Request& request) {
  Caller caller{.method = request.method,
                .path = request.path,
                .hosts = headers(request, "Host"),
                .origins = headers(request, "Origin"),
                .types = headers(request, "Content-Type"),
                .coded = request.has_header("Transfer-Encoding") || request.has_header("Content-Encoding"),
                .length = length_of(request)};
  const auto [first, last] = request.params.equal_range("token");
  for (auto token = first; token != last; ++token) {
    caller.tokens.push_back(token->second);
  }
  return caller;
}

}  // namespace

WebServer::WebServer(int port, WebContent content, Feed& feed)
    : content_(std::move(content)),
      feed_(feed),
      token_(Gatekeeper::new_token()),
      port_(bind(port)),
      gatekeeper_(port_, token_) {
  if (port_ < 0) {
    throw run_failed("--watch: port " + std::to_string(port) + " of 127.0.0.1 cannot be had; give another one");
  }
  new_task_queue = [] { return new BoundedQueue(threads, waiting); };
  set_payload_max_length(longest_request);
  set_default_headers(
      {{"Cache-Control", "no-store"},
       {"Content-Security-Policy",
        "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; connect-src 'self'; "
        "frame-ancestors 'none'; form-action 'none'; base-uri 'none'"},
       {"Referrer-Policy", "no-referrer"},
       {"X-Content-Type-Options", "nosniff"}});
  add_pages();
  listener_ = std::thread([this] {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, nullptr);  // signals are for the thread that plays the day
    listen_after_bind();
    listening_ = false;
  });
}

WebServer::~WebServer() {
  stopping_ = true;
  while (listening_ && !is_running()) {  // what has not begun to listen cannot be stopped
    std::this_thread::sleep_for(1ms);
  }
  stop();
  listener_.join();
}

int WebServer::bind(int port) {
  set_socket_options([](socket_t socket) {  // in place of httplib's, by which others could share the port
    const int yes = 1;
    setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  });
  if (port == 0) {
    return bind_to_any_port("127.0.0.1");
  }
  return bind_to_port("127.0.0.1", port) ? port : -1;
}

std::string WebServer::link() const {
  return "http://127.0.0.1:" + std::to_string(port_) + "/?token=" + token_;
}

bool WebServer::process_and_close_socket(socket_t socket) {
  BoundedStream stream(socket, stopping_);
  serve(stream);
  ::shutdown(socket, SHUT_RDWR);
  ::close(socket);
  return true;
}

void WebServer::serve(httplib::Stream& stream) {
  const auto plain = [](httplib::Request& request) {
    request.headers.erase("Accept-Encoding");  // to compress costs more than to send
    request.ranges.clear();
  };
  const auto process = [&](auto& self) {
    bool closed = false;
    if constexpr (requires { self.process_request(stream, true, closed, plain); }) {
      self.process_request(stream, true, closed, plain);
    } else {  // later versions of httplib
      self.process_request(stream, "", 0, "", 0, true, closed, plain);
    }
  };
  process(*this);
}

void WebServer::add_pages() {
  set_pre_routing_handler([this](const httplib::Request& request, httplib::Response& response) {
    const auto turned = gatekeeper_.turns_away(caller_of(request));
    if (turned) {
      response.status = turned->status;
      response.set_content(turned->why + "\n", "text/plain");
    }
    return turned ? HandlerResponse::Handled : HandlerResponse::Unhandled;
  });
  Get("/", [this](const httplib::Request&, httplib::Response& response) {
    response.set_content(content_.page, "text/html; charset=utf-8");
  });
  Get("/events", [this](const httplib::Request&, httplib::Response& response) { send_events(response); });
  Get("/faults[.]yaml",
      [this](const httplib::Request&, httplib::Response& response) { answer("{do: schedule}", response); });
  Post("/ask",
       [this](const httplib::Request& request, httplib::Response& response) { answer(request.body, response); });
}

void WebServer::answer(const std::string& request, httplib::Response& response) const {
  try {
    response.set_content(content_.ask(request), "text/plain; charset=utf-8");
  } catch (const Error& error) {
    response.status = error.status() == ExitStatus::bad_input ? 409 : 503;
    response.set_content(error.what(), "text/plain; charset=utf-8");
  }
}

void WebServer::send_events(httplib::Response& response) {
  const std::shared_ptr<void> watcher(nullptr, [this](void*) { --watching_; });
  if (++watching_ > most_watching) {
    response.status = 503;
    response.set_content(std::to_string(most_watching) + " pages are open already; close one\n", "text/plain");
    return;
  }
  const auto place = std::make_shared<Feed::Place>();
  const auto provide = [this, place, watcher](std::size_t, httplib::DataSink& sink) {
    const std::string text = feed_.next(*place, 1s);
    if (text.empty() && (feed_.over(*place) || stopping_)) {
      sink.done();
      return true;
    }
    const std::string sent = text.empty() ? ":\n\n" : text;  // a comment shows whether the browser is still there
    return sink.write(sent.data(), sent.size());
  };
  response.set_chunked_content_provider("text/event-stream", provide);
}

}  // namespace evbal
