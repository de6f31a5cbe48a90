#pragma once

#include "agents/bus/participant.hpp"
#include "common/error.hpp"

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace evbal {

/// The messages of one tick as they come in, one for each region that is due.
template <class Message>
class Collected {
 public:
  /// Of the tick; `due` are the regions to hear from.
  Collected(int tick, const std::vector<int>& due) : tick_(tick), missing_(due.begin(), due.end()) {}

  /// Messages of other ticks are left out: who was killed says again what it last said. Throws Error{run_failed} if one
  /// is of no tick up to `newest`.
  void add(std::vector<Heard<std::vector<Message>>> batches, int newest) {
    for (auto& [from, batch] : batches) {
      for (auto& message : batch) {
        if (message.tick < 0 || message.tick > newest) {
          throw run_failed(name_of(from) + " speaks of tick " + std::to_string(message.tick) + ", region " +
                           std::to_string(message.region) + " in tick " + std::to_string(tick_));
        }
        if (message.tick == tick_ && missing_.erase(message.region) > 0) {
          found_.emplace(message.region, std::move(message));
        }
      }
    }
  }

  /// Regions from which nothing has come.
  const std::set<int>& missing() const { return missing_; }

  /// Takes out what has come, by region.
  std::vector<Message> by_region() {
    std::vector<Message> messages;
    for (auto& [region, message] : found_) {
      messages.push_back(std::move(message));
    }
    return messages;
  }

 private:
  int tick_;
  std::set<int> missing_;
  std::map<int, Message> found_;
};

}  // namespace evbal
