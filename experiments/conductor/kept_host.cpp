#include "experiments/conductor/kept_host.hpp"

#include "agents/hosting/keeper.hpp"
#include "agents/hosting/process.hpp"
#include "common/error.hpp"
#include "common/files.hpp"
#include "common/interrupt.hpp"
#include "common/open_file.hpp"
#include "common/spawn.hpp"
#include "experiments/conductor/last_words.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <utility>

namespace evbal {
namespace {

using namespace std::chrono_literals;

constexpr auto between_words = 1s;              // that the keeper hears at least
constexpr auto longest_nap = 100ms;             // between looks whether the run is interrupted
constexpr auto grace = time_for_farewell + 2s;  // for a keeper whose processes have that time

/// What a shell over there does: it takes the program from its input, runs it as the keeper, and removes the run's
/// folder whatever becomes of the keeper. The lock says that the folder is in use, for who cleans up.
std::string script(const std::string& address, std::size_t program_size) {
  return "umask 077; d=$(mktemp -d \"${TMPDIR:-/tmp}/evbal-host-XXXXXX\") || exit; trap 'rm -rf \"$d\"' EXIT; "
         "trap 'exit 1' HUP INT TERM; exec 9<\"$d\"; flock 9; head -c " +
         std::to_string(program_size) + " >\"$d/evbal-agent\"; chmod 700 \"$d/evbal-agent\"; cd \"$d\" && " +
         "./evbal-agent " + keeper_word + " " + address + " " + std::to_string(host_lease.count());
}

}  // namespace

KeptHost::KeptHost(const HostSpec& host, int number, HostFolders folders)
    : host_(host), name_("host-" + std::to_string(number)), folders_(std::move(folders)), heard_(Clock::now()) {
  std::signal(SIGPIPE, SIG_IGN);
  to_say_ = text_of_file(folders_.programs / "evbal-agent");
  const OpenFile errors(folders_.logs / (name_ + ".log"), O_WRONLY | O_CREAT | O_APPEND);
  id_ = spawn(on_host(host_, script(host_.address, to_say_.size())),
              {.input = to_.read_end(), .output = from_.write_end(), .errors = errors.number()});
  to_.close_read_end();
  from_.close_write_end();
  fcntl(to_.write_end(), F_SETFL, O_NONBLOCK);
  fcntl(wake_.write_end(), F_SETFL, O_NONBLOCK);
  thread_ = std::thread([this] { talk(); });
}

KeptHost::~KeptHost() {
  end();
  {
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, grace, [&] { return closed_ || !gone_.empty(); });
    over_ = true;
  }
  order({});
  thread_.join();
  give_up("its run has ended");
}

void KeptHost::talk() {
  auto said = Clock::now();
  std::unique_lock lock(mutex_);
  while (!over_ && !closed_ && gone_.empty()) {
    std::array<pollfd, 3> files = {{{from_.read_end(), POLLIN, 0},
                                    {wake_.read_end(), POLLIN, 0},
                                    {to_say_.empty() ? -1 : to_.write_end(), POLLOUT, 0}}};
    lock.unlock();
    poll(files.data(), files.size(), 1000);
    std::array<char, 64> ignored{};
    if (files[1].revents != 0) {
      [[maybe_unused]] const ssize_t woken = read(wake_.read_end(), ignored.data(), ignored.size());
    }
    const bool heard = files[0].revents == 0 || hear();
    lock.lock();
    closed_ = !heard || (files[2].revents != 0 && !write_some(to_.write_end(), to_say_));
    if (greeted_ && to_say_.empty() && Clock::now() - said >= between_words) {
      to_say_ = frame(HostOrder{});
      said = Clock::now();
    }
  }
  closed_ = true;
  to_.close_write_end();  // at which a keeper ends that is still there
  changed_.notify_all();
}

/// Takes what has come from there; false if nothing more will.
bool KeptHost::hear() {
  std::array<char, 1 << 16> part{};
  const ssize_t length = read(from_.read_end(), part.data(), part.size());
  if (length <= 0) {
    return false;
  }
  frames_.add({part.data(), static_cast<std::size_t>(length)});
  try {
    const std::lock_guard lock(mutex_);
    heard_ = Clock::now();
    greeted_ = greeted_ || frames_.greeted();
    while (auto news = greeted_ ? frames_.next<HostNews>() : std::nullopt) {
      take(std::move(*news));
    }
    changed_.notify_all();
    return true;
  } catch (const Error& error) {
    const OpenFile log(folders_.logs / (name_ + ".log"), O_WRONLY | O_CREAT | O_APPEND);
    std::string line = std::string(error.what()) + "\n";
    write_some(log.number(), line);
    return false;
  }
}

void KeptHost::take(HostNews news) {
  const bool of_process = news.process.find('/') == std::string::npos;
  if (news.kind == HostNewsKind::printed && of_process) {
    const OpenFile log(folders_.logs / (news.process + ".log"), O_WRONLY | O_CREAT | O_APPEND);
    write_some(log.number(), news.text);
  } else if (news.kind == HostNewsKind::legs && of_process) {
    write_file(legs_file(folders_.legs / news.process), news.text);
  } else if (news.kind != HostNewsKind::alive) {
    news_.push_back(std::move(news));
  }
}

void KeptHost::order(const HostOrder& order) {
  {
    const std::lock_guard lock(mutex_);
    to_say_ += frame(order);
  }
  [[maybe_unused]] const ssize_t woken = write(wake_.write_end(), "", 1);
}

void KeptHost::await(std::chrono::milliseconds patience) {
  const auto deadline = Clock::now() + patience;
  std::unique_lock lock(mutex_);
  while (!greeted_ && !closed_ && Clock::now() < deadline) {
    check_interrupt();
    changed_.wait_for(lock, longest_nap);
  }
  const bool there = greeted_;
  lock.unlock();
  if (!there) {
    std::string why = gone();
    if (why.empty()) {
      give_up("nothing was heard of it within " + std::to_string(patience.count() / 1000) + " s");
      why = gone();
    }
    throw run_failed("host " + shown(host_) + ": " + why);
  }
}

std::string KeptHost::gone() {
  std::unique_lock lock(mutex_);
  if (!gone_.empty()) {
    return gone_;
  }
  const bool silent = greeted_ && Clock::now() - heard_ > host_lease;
  if (!closed_ && !silent) {
    return "";
  }
  lock.unlock();
  give_up(silent ? "nothing was heard of it for " + std::to_string(host_lease.count()) + " s" : "");
  return gone_;
}

/// Lets go of the connection, not of a keeper on this machine: that removes what there is, as one elsewhere does. If
/// `why` is empty the reason is how its program ended.
void KeptHost::give_up(std::string why) {
  if (id_ != 0) {
    int status = 0;
    const auto deadline = Clock::now() + 1s;
    while (waitpid(id_, &status, WNOHANG) != id_) {
      if (!why.empty() || Clock::now() > deadline) {
        kill(host_.start.empty() ? id_ : -id_, SIGKILL);
      }
      poll(nullptr, 0, 5);
    }
    id_ = 0;
    if (why.empty()) {
      why = "its keeper " + ending(status) + last_words(folders_.logs / (name_ + ".log"));
    }
  }
  const std::lock_guard lock(mutex_);
  gone_ = gone_.empty() ? why : gone_;
}

std::optional<HostNews> KeptHost::await_news(const std::function<bool(const HostNews&)>& is_it) {
  for (;;) {
    {
      std::unique_lock lock(mutex_);
      const auto found = std::ranges::find_if(news_, is_it);
      if (found != news_.end()) {
        HostNews news = std::move(*found);
        news_.erase(found);
        return news;
      }
      if (!closed_) {
        changed_.wait_for(lock, longest_nap);
      }
    }
    check_interrupt();
    if (!gone().empty()) {
      return std::nullopt;
    }
  }
}

std::optional<pid_t> KeptHost::start(const std::string& process, const std::vector<std::string>& arguments,
                                     const std::vector<SentFile>& files) {
  if (!gone().empty()) {
    return std::nullopt;
  }
  order({.kind = HostOrderKind::start, .process = process, .words = arguments, .files = files});
  const auto news = await_news([&](const HostNews& heard) {
    return heard.process == process && (heard.kind == HostNewsKind::started || heard.kind == HostNewsKind::not_started);
  });
  if (news && news->kind == HostNewsKind::not_started) {
    throw run_failed("host " + shown(host_) + ": " + news->text);
  }
  return news ? std::optional<pid_t>(news->number) : std::nullopt;
}

void KeptHost::send_signal(const std::string& process, int number) {
  order({.kind = HostOrderKind::signal, .process = process, .number = number});
}

std::vector<HostNews> KeptHost::ended() {
  const std::lock_guard lock(mutex_);
  std::vector<HostNews> found;
  std::ranges::copy_if(news_, std::back_inserter(found),
                       [](const HostNews& news) { return news.kind == HostNewsKind::ended; });
  std::erase_if(news_, [](const HostNews& news) { return news.kind == HostNewsKind::ended; });
  return found;
}

std::string KeptHost::complaint_of_ports(int first, int last) {
  order({.kind = HostOrderKind::ports, .number = first, .last_port = last});
  const auto news = await_news([](const HostNews& heard) { return heard.kind == HostNewsKind::ports; });
  return news ? news->text : "";
}

void KeptHost::end() {
  order({.kind = HostOrderKind::end});
}

}  // namespace evbal
