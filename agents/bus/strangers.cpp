#include "agents/bus/strangers.hpp"

#include "common/log.hpp"

#include <algorithm>
#include <utility>

namespace evbal {
namespace {

/// What a stranger calls itself, fit for a line of text.
std::string fit(std::string name) {
  constexpr std::size_t longest = 40;
  name.resize(std::min(name.size(), longest));
  std::ranges::replace_if(
      name, [](unsigned char c) { return c < ' ' || c > '~' || c == '`'; }, '?');
  return name;
}

}  // namespace

void Strangers::seen(const GuidPrefix& who, const std::string& name, Clock::time_point now) {
  const std::lock_guard lock(mutex_);
  if (!roster_.secured() || proved_.contains(who)) {
    return;
  }
  Unproved& stranger = unproved_[who];
  stranger = {.name = fit(name), .since = now, .failed = stranger.failed, .named = stranger.named};
  if (roster_.number_of(who) < 0) {
    this->name(who, stranger);
  }
}

void Strangers::proved(const GuidPrefix& who) {
  const std::lock_guard lock(mutex_);
  if (roster_.number_of(who) >= 0) {
    unproved_.erase(who);
    proved_.insert(who);
  }
}

void Strangers::failed(const GuidPrefix& who, Clock::time_point now) {
  const std::lock_guard lock(mutex_);
  Unproved& stranger = unproved_.try_emplace(who, Unproved{.since = now}).first->second;
  stranger.failed = true;
  name(who, stranger);
}

void Strangers::left(const GuidPrefix& who) {
  const std::lock_guard lock(mutex_);
  unproved_.erase(who);
  proved_.erase(who);
}

std::vector<std::string> Strangers::named(Clock::time_point now) {
  const std::lock_guard lock(mutex_);
  for (auto& [who, stranger] : unproved_) {
    if (now - stranger.since >= time_to_prove) {
      name(who, stranger);
    }
  }
  if (unnamed_ > 0) {
    found_.push_back(std::to_string(std::exchange(unnamed_, 0)) + " more");
  }
  return std::exchange(found_, {});
}

void Strangers::name(const GuidPrefix& who, Unproved& stranger) {
  if (std::exchange(stranger.named, true)) {
    return;
  }
  if (found_.size() >= most_named) {
    ++unnamed_;
    return;
  }
  const int number = roster_.number_of(who);
  found_.push_back("participant " + text_of(who) +
                   (stranger.name.empty() ? " " : ", which calls itself `" + stranger.name + "`, ") +
                   (number < 0        ? "has no certificate of this run"
                    : stranger.failed ? "cannot prove that it is " + name_of(number)
                                      : "has not proved that it is " + name_of(number)));
  log_line(LogLevel::warn, "kept out: " + found_.back());
}

}  // namespace evbal
