#include "tests/run/evbal/browser.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <vector>

namespace evbal {
namespace {

using Json = nlohmann::json;

/// The ends of a pipe, at numbers that are not in the way of those that Chromium takes them from.
std::array<int, 2> high_pipe() {
  std::array<int, 2> ends{};
  EXPECT_EQ(pipe2(ends.data(), O_CLOEXEC), 0);
  for (int& end : ends) {
    const int high = fcntl(end, F_DUPFD_CLOEXEC, 10);
    close(end);
    end = high;
  }
  return ends;
}

}  // namespace

Browser::Browser() {
  const auto to = high_pipe();
  const auto from = high_pipe();
  std::vector<std::string> words = {EVBAL_CHROMIUM,
                                    "--headless",
                                    "--no-sandbox",
                                    "--disable-gpu",
                                    "--disable-quic",
                                    "--no-first-run",
                                    "--disable-background-networking",
                                    "--disable-component-update",
                                    "--disable-sync",
                                    "--host-resolver-rules=MAP * ~NOTFOUND , EXCLUDE 127.0.0.1",
                                    "--remote-debugging-pipe",
                                    "--window-size=1500,1400",
                                    "--user-data-dir=" + (folder_.path() / "user").string()};
  std::vector<char*> arguments;
  for (auto& word : words) {
    arguments.push_back(word.data());
  }
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_adddup2(&files, to[0], 3);
  posix_spawn_file_actions_adddup2(&files, from[1], 4);
  posix_spawn_file_actions_addopen(&files, 2, (folder_.path() / "err.txt").c_str(), O_WRONLY | O_CREAT, 0600);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  EXPECT_EQ(posix_spawnp(&id_, arguments.front(), &files, &attributes, arguments.data(), environ), 0);
  posix_spawn_file_actions_destroy(&files);
  posix_spawnattr_destroy(&attributes);
  close(to[0]);
  close(from[1]);
  to_ = to[1];
  from_ = from[0];
}

Browser::~Browser() {
  kill(-id_, SIGKILL);
  waitpid(id_, nullptr, 0);
  close(to_);
  close(from_);
}

std::string Browser::next_message() {
  pollfd waited{.fd = from_, .events = POLLIN, .revents = 0};
  while (heard_.find('\0') == std::string::npos && poll(&waited, 1, 60'000) > 0) {
    std::array<char, 65536> bytes{};
    const ssize_t count = read(from_, bytes.data(), bytes.size());
    if (count <= 0) {
      break;
    }
    heard_.append(bytes.data(), static_cast<std::size_t>(count));
  }
  const auto end = heard_.find('\0');
  if (end == std::string::npos) {
    return "";
  }
  const std::string message = heard_.substr(0, end);
  heard_.erase(0, end + 1);
  return message;
}

Json Browser::call(const std::string& method, const Json& params) {
  Json request = {{"id", ++calls_}, {"method", method}, {"params", params}};
  if (!session_.empty()) {
    request["sessionId"] = session_;
  }
  const std::string text = request.dump() + '\0';
  EXPECT_EQ(write(to_, text.data(), text.size()), static_cast<ssize_t>(text.size()));
  for (std::string message = next_message(); !message.empty(); message = next_message()) {
    const Json answer = Json::parse(message);
    if (answer.value("id", 0) == calls_) {
      return answer.value("result", Json::object());
    }
  }
  ADD_FAILURE() << method << ": no answer; " << text_of(folder_.path() / "err.txt");
  return Json::object();
}

void Browser::open(const std::string& address) {
  const Json target = call("Target.createTarget", {{"url", "about:blank"}});
  const Json session = call("Target.attachToTarget", {{"targetId", target.value("targetId", "")}, {"flatten", true}});
  session_ = session.value("sessionId", "");
  call("Page.enable", Json::object());
  call("Page.navigate", {{"url", address}});
}

std::string Browser::value_of(const std::string& expression) {
  const Json answer =
      call("Runtime.evaluate", {{"expression", expression}, {"awaitPromise", true}, {"returnByValue", true}});
  if (answer.contains("exceptionDetails")) {
    return answer["exceptionDetails"].dump();
  }
  return answer.contains("result") && answer["result"].contains("value") ? answer["result"]["value"].dump() : "";
}

bool Browser::comes_true(const std::string& expression) {
  return value_of("new Promise(done => { let left = 3000; const look = () => { let is = false; try { is = !!(" +
                  expression + "); } catch {} is || --left === 0 ? done(is) : setTimeout(look, 10); }; look(); })") ==
         "true";
}

}  // namespace evbal
