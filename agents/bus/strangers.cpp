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
  if (!roster_.secured()) {
    return;
  }
  const std::lock_guard lock(mutex_);
  Unproved& stranger = unproved_[who];
  stranger = {.name = fit(name), .since = now};
  if (roster_.number_of(who) < 0) {
    this->name(who, stranger, "has no certificate of this run");
  }
}

void Strangers::proved(const GuidPrefix& who) {
  const std::lock_guard lock(mutex_);
  if (roster_.number_of(who) >= 0) {
    unproved_.erase(who);
  }
}

void Strangers::failed(const GuidPrefix& who) {
  const std::lock_guard lock(mutex_);
  name(who, unproved_[who], "cannot prove that it is " + claim_of(who));
}

void Strangers::left(const GuidPrefix& who) {
  const std::lock_guard lock(mutex_);
  unproved_.erase(who);
}

std::vector<std::string> Strangers::named(Clock::time_point now) {
  const std::lock_guard lock(mutex_);
  for (auto& [who, stranger] : unproved_) {
    if (now - stranger.since >= time_to_prove) {
      name(who, stranger, "has not proved that it is " + claim_of(who));
    }
  }
  if (unnamed_ > 0) {
    found_.push_back(std::to_string(std::exchange(unnamed_, 0)) + " more");
  }
  return std::exchange(found_, {});
}

void Strangers::name(const GuidPrefix& who, Unproved& stranger, const std::string& why) {
  if (std::exchange(stranger.named, true)) {
    return;
  }
  if (found_.size() >= most_named) {
    ++unnamed_;
    return;
  }
  found_.push_back("participant " + text_of(who) + ", which calls itself `" + stranger.name + "`, " + why);
  log_line(LogLevel::warn, "kept out: " + found_.back());
}

/// Whom the participant's GUID says it is.
std::string Strangers::claim_of(const GuidPrefix& who) const {
  const int number = roster_.number_of(who);
  return number < 0 ? "of this run" : name_of(number);
}

}  // namespace evbal
