// Who may pass, and what does not hold the server up: over real connections of the loopback interface.

#include "tools/console/web_server.hpp"

#include "common/error.hpp"
#include "experiments/run/request_box.hpp"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <chrono>
#include <memory>
#include <string>
#include <vector>

namespace evbal {
namespace {

/// A connection as a browser, or somebody worse, has one.
class Connection {
 public:
  explicit Connection(int port) : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    EXPECT_EQ(connect(socket_, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
  }
  ~Connection() { close(socket_); }
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  /// Whether the other end took all of it.
  bool say(const std::string& text) const {
    for (std::size_t sent = 0; sent < text.size();) {
      const ssize_t count = send(socket_, text.data() + sent, text.size() - sent, MSG_NOSIGNAL);
      if (count <= 0) {
        return false;
      }
      sent += static_cast<std::size_t>(count);
    }
    return true;
  }

  /// What comes until it holds `end`, or until the connection is closed, in half a minute at most.
  std::string hear(const std::string& end = "\n\nnever") const {
    std::string text;
    pollfd waited{.fd = socket_, .events = POLLIN, .revents = 0};
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(30);
    while (text.find(end) == std::string::npos && std::chrono::steady_clock::now() < deadline &&
           poll(&waited, 1, 30'000) > 0) {
      std::array<char, 4096> bytes{};
      const ssize_t count = recv(socket_, bytes.data(), bytes.size(), 0);
      if (count <= 0) {
        return text;
      }
      text.append(bytes.data(), static_cast<std::size_t>(count));
    }
    return text;
  }

 private:
  int socket_;
};

class WebServerTest : public ::testing::Test {
 protected:
  WebServerTest() {
    const auto ask = [this](const std::string& request) {
      ++asked_;
      if (request == "no") {
        throw bad_input("not this");
      }
      return "yes to " + request;
    };
    server_ = std::make_unique<WebServer>(0, WebContent{.page = "<p>the page</p>", .ask = ask}, feed_);
    const std::string link = server_->link();
    port_ = std::stoi(link.substr(link.rfind(':') + 1));
    token_ = link.substr(link.find('=') + 1);
    host_ = "Host: 127.0.0.1:" + std::to_string(port_) + "\r\n";
    origin_ = "Origin: http://127.0.0.1:" + std::to_string(port_) + "\r\n";
  }

  /// The answer to a request; in `headers` each ends its line.
  std::string answer(const std::string& line, const std::string& headers, const std::string& body = "") const {
    const Connection caller(port_);
    caller.say(line + " HTTP/1.1\r\n" + headers + "\r\n" + body);
    return caller.hear();
  }

  /// Its status, 0 without an answer.
  int status(const std::string& line, const std::string& headers, const std::string& body = "") const {
    const std::string text = answer(line, headers, body);
    return text.starts_with("HTTP/1.1 ") ? std::stoi(text.substr(9, 3)) : 0;
  }

  std::string with_token(const std::string& path) const { return path + "?token=" + token_; }

  std::string post_headers(std::size_t length) const {
    return host_ + origin_ + "Content-Type: application/json\r\nContent-Length: " + std::to_string(length) + "\r\n";
  }

  std::string watch() const { return "GET " + with_token("/events") + " HTTP/1.1\r\n" + host_ + "\r\n"; }

  Feed feed_;
  std::atomic<int> asked_ = 0;
  std::unique_ptr<WebServer> server_;
  int port_ = 0;
  std::string token_;
  std::string host_;
  std::string origin_;
};

TEST_F(WebServerTest, ShowsThePageToWhoHasTheLink) {
  const std::string text = answer("GET " + with_token("/"), host_);
  EXPECT_TRUE(text.starts_with("HTTP/1.1 200")) << text;
  EXPECT_TRUE(text.ends_with("<p>the page</p>")) << text;
  EXPECT_NE(text.find("default-src 'none'"), std::string::npos) << text;
  EXPECT_NE(text.find("frame-ancestors 'none'"), std::string::npos) << text;
  EXPECT_EQ(status("GET " + with_token("/"), "Host: localhost:" + std::to_string(port_) + "\r\n"), 200);
}

TEST_F(WebServerTest, RefusesAWrongToken) {
  std::string other = token_;
  other.back() = other.back() == '0' ? '1' : '0';
  for (const std::string& path : std::vector<std::string>{
           "/", "/?token=", "/?token=" + other, "/?token=" + token_.substr(1), "/?token=" + token_ + "0",
           with_token("/") + "&token=" + other, "/events", "/events?token=" + other}) {
    EXPECT_EQ(status("GET " + path, host_), 403) << path;
  }
  EXPECT_EQ(status("POST /ask?token=" + other, post_headers(2), "{}"), 403);
  EXPECT_EQ(asked_, 0);
}

TEST_F(WebServerTest, RefusesAForeignHost) {
  const std::string port = std::to_string(port_);
  for (const std::string& host :
       std::vector<std::string>{"", "Host: evil.example:" + port + "\r\n", "Host: 127.0.0.1\r\n",
                                "Host: 127.0.0.1.evil.example:" + port + "\r\n", host_ + "Host: evil.example\r\n",
                                "Host: 0.0.0.0:" + port + "\r\n"}) {
    EXPECT_EQ(status("GET " + with_token("/"), host), 403) << host;
    EXPECT_EQ(status("POST " + with_token("/ask"),
                     host + origin_ + "Content-Type: application/json\r\nContent-Length: 2\r\n", "{}"),
              403)
        << host;
  }
  EXPECT_EQ(asked_, 0);
}

TEST_F(WebServerTest, RefusesAForeignOrigin) {
  const std::string rest = "Content-Type: application/json\r\nContent-Length: 2\r\n";
  const std::string port = std::to_string(port_);
  for (const std::string& origin : std::vector<std::string>{
           "Origin: http://evil.example\r\n", "Origin: null\r\n", "Origin: https://127.0.0.1:" + port + "\r\n",
           "Origin: http://127.0.0.1:1\r\n", "Origin: http://127.0.0.1:" + port + ".evil.example\r\n",
           origin_ + "Origin: http://evil.example\r\n"}) {
    EXPECT_EQ(status("POST " + with_token("/ask"), host_ + origin + rest, "{}"), 403) << origin;
    EXPECT_EQ(status("GET " + with_token("/events"), host_ + origin), 403) << origin;
  }
  EXPECT_EQ(status("POST " + with_token("/ask"), host_ + rest, "{}"), 403) << "no origin";
  EXPECT_EQ(asked_, 0);
}

TEST_F(WebServerTest, ChangesNothingByGet) {
  EXPECT_EQ(status("GET " + with_token("/ask"), host_ + origin_), 405);
  EXPECT_EQ(status("HEAD " + with_token("/ask"), host_ + origin_), 405);
  EXPECT_EQ(status("PUT " + with_token("/ask"), post_headers(2), "{}"), 405);
  EXPECT_EQ(status("OPTIONS " + with_token("/ask"), host_ + origin_), 405);
  EXPECT_EQ(status("POST " + with_token("/"), post_headers(2), "{}"), 405);
  EXPECT_EQ(status("GET " + with_token("/scenario.resolved.yaml"), host_), 404);
  EXPECT_EQ(status("GET " + with_token("/../etc/passwd"), host_), 404);
  EXPECT_EQ(asked_, 0);
}

TEST_F(WebServerTest, TakesRequestsOfItsOwnPageOnlyAsItWritesThem) {
  const std::string plain = host_ + origin_ + "Content-Type: text/plain\r\nContent-Length: 2\r\n";
  EXPECT_EQ(status("POST " + with_token("/ask"), plain, "{}"), 415) << "other pages could send it unasked";
  const std::string json = host_ + origin_ + "Content-Type: application/json\r\n";
  EXPECT_EQ(status("POST " + with_token("/ask"), json + "Transfer-Encoding: chunked\r\n", "2\r\n{}\r\n0\r\n\r\n"), 411);
  EXPECT_EQ(status("POST " + with_token("/ask"), json + "Content-Encoding: gzip\r\nContent-Length: 2\r\n", "{}"), 411);
  EXPECT_EQ(status("POST " + with_token("/ask"), json + "Content-Length: -2\r\n", "{}"), 411);
  EXPECT_EQ(asked_, 0);
}

TEST_F(WebServerTest, BoundsWhatItReads) {
  EXPECT_EQ(status("POST " + with_token("/ask"), post_headers(longest_request + 1), "{}"), 413);
  EXPECT_EQ(status("POST " + with_token("/ask"), post_headers(longest_request), std::string(longest_request, ' ')),
            200);
  EXPECT_EQ(asked_, 1);
  const std::string endless(1'000'000, 'x');
  for (const std::string& beginning : std::vector<std::string>{"", "GET /", "GET / HTTP/1.1\r\n" + host_ + "X-A: "}) {
    const Connection caller(port_);
    caller.say(beginning + endless);
    EXPECT_EQ(caller.hear().find("200 OK"), std::string::npos);
  }
  EXPECT_EQ(status("GET " + with_token("/"), host_), 200) << "it goes on";
}

TEST_F(WebServerTest, PassesOnWhatIsAskedAndItsAnswer) {
  const std::string yes = answer("POST " + with_token("/ask"), post_headers(5), "pause");
  EXPECT_TRUE(yes.starts_with("HTTP/1.1 200") && yes.ends_with("yes to pause")) << yes;
  const std::string no = answer("POST " + with_token("/ask"), post_headers(2), "no");
  EXPECT_TRUE(no.starts_with("HTTP/1.1 409") && no.ends_with("not this")) << no;
  EXPECT_TRUE(answer("GET " + with_token("/faults.yaml"), host_).ends_with("yes to {do: schedule}"));
}

TEST_F(WebServerTest, TellsTheDayAsItGoesOn) {
  feed_.begin_day("{\"day\": 1}");
  const Connection caller(port_);
  caller.say(watch());
  EXPECT_NE(caller.hear("{\"day\": 1}\n\n").find("text/event-stream"), std::string::npos);
  feed_.tell("tick", "{\"tick\": 7}");
  EXPECT_NE(caller.hear("{\"tick\": 7}\n\n").find("event: tick\n"), std::string::npos);
}

TEST_F(WebServerTest, IsHeldUpByNobody) {
  feed_.begin_day("{}");
  const Connection silent(port_);
  const Connection stuck(port_);  // asks, and never takes anything
  stuck.say(watch());
  {
    const Connection vanished(port_);
    vanished.say(watch());
    vanished.hear("{}");
  }
  for (int i = 0; i < 1000; ++i) {
    feed_.tell("tick", std::string(10'000, 'x'));  // does not wait, or this never ends
  }
  EXPECT_EQ(status("GET " + with_token("/"), host_), 200);
  feed_.close();
  server_.reset();
}

TEST_F(WebServerTest, LetsFourWatchAndNoMore) {
  feed_.begin_day("{}");
  std::vector<std::unique_ptr<Connection>> watching;
  for (int i = 0; i < 4; ++i) {
    watching.push_back(std::make_unique<Connection>(port_));
    watching.back()->say(watch());
    EXPECT_NE(watching.back()->hear("{}").find("200 OK"), std::string::npos);
  }
  EXPECT_EQ(status("GET " + with_token("/events"), host_), 503);
  watching.clear();
  std::string heard;
  for (int tries = 0; tries < 100 && heard.find("200 OK") == std::string::npos; ++tries) {
    usleep(100'000);  // until the server has seen that they are gone
    const Connection again(port_);
    again.say(watch());
    heard = again.hear("\n\n");
  }
  EXPECT_NE(heard.find("200 OK"), std::string::npos) << heard;
}

TEST(WebServerPort, IsSaidToBeTaken) {
  Feed feed;
  const WebServer first(0, {}, feed);
  const std::string link = first.link();
  EXPECT_THROW(WebServer(std::stoi(link.substr(link.rfind(':') + 1)), {}, feed), Error);
}

}  // namespace
}  // namespace evbal
