#pragma once

#include "tools/console/feed.hpp"
#include "tools/console/gatekeeper.hpp"
#include "tools/console/http.hpp"

#include <atomic>
#include <functional>
#include <string>
#include <thread>

namespace evbal {

/// What the server hands out, and to whom it passes on what it is asked.
struct WebContent {
  std::string page;                                            ///< HTML
  std::function<std::string(const std::string& request)> ask;  ///< answers a request, or throws Error for a no
};

/// Serves the console on the loopback interface, in threads of its own, to whom the gatekeeper lets pass:
///
///     GET  /             the page
///     GET  /events       the feed, as server-sent events
///     GET  /faults.yaml  the day's faults as a schedule
///     POST /ask          a request as of day_request.hpp, whose answer is text; 409 with the reason for a no
class WebServer : public httplib::Server {
 public:
  /// On a port of 127.0.0.1, or on any that is free for 0. `feed` must outlive the server. Throws Error{run_failed} if
  /// the port is taken.
  WebServer(int port, WebContent content, Feed& feed);

  /// Ends all connections, within a second or so.
  ~WebServer() override;

  /// The page's address, with its token.
  std::string link() const;

  /// Answers the request that comes over a connection.
  void serve(httplib::Stream& stream);

 private:
  bool process_and_close_socket(socket_t socket) override;
  int bind(int port);
  void add_pages();
  void send_events(httplib::Response& response);
  void answer(const std::string& request, httplib::Response& response) const;

  WebContent content_;
  Feed& feed_;
  std::string token_;
  int port_;
  Gatekeeper gatekeeper_;
  std::atomic<bool> stopping_ = false;
  std::atomic<bool> listening_ = true;
  std::atomic<int> watching_ = 0;  ///< connections to the feed
  std::thread listener_;
};

}  // namespace evbal
