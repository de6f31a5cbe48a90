#pragma once

#include "agents/bus/fast_dds.hpp"
#include "agents/bus/topics.hpp"
#include "common/error.hpp"

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <map>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace evbal {

/// What has come for a reader and was not taken yet. The middleware's thread puts it there as it arrives, so that who
/// waits for several messages wakes once, and meets none of the locks that the middleware holds while it tells of one.
template <class Message>
class Inbox : public fast_dds::dds::DataReaderListener {
 public:
  static constexpr int most_unread = 1 << 14;  ///< messages that are kept until they are taken

  /// Of a reader at `address` that keeps what concerns `regions`. Address and roster must outlive this.
  Inbox(const BusAddress& address, const Roster& roster, const RegionRange& regions)
      : address_(address), roster_(roster), regions_(regions) {}

  /// Called by the middleware.
  void on_data_available(fast_dds::dds::DataReader* reader) override {
    Sample<Message> sample;
    sample.regions = regions_;
    fast_dds::dds::SampleInfo info;
    while (fast_dds::succeeded(reader->take_next_sample(&sample, &info))) {
      if (info.valid_data) {
        put(fast_dds::prefix_of(info.sample_identity.writer_guid()), sample);
      }
    }
  }

  /// As Reader's.
  std::vector<Heard<Message>> take() {
    const std::lock_guard lock(mutex_);
    if (!wrong_.empty()) {
      throw run_failed(std::exchange(wrong_, {}));
    }
    return std::exchange(heard_, {});
  }

  /// As Reader's.
  std::map<std::string, int> refused() {
    const std::lock_guard lock(mutex_);
    return std::exchange(refused_, {});
  }

  /// As Reader's.
  void wait(std::chrono::milliseconds at_most, std::size_t messages) {
    std::unique_lock lock(mutex_);
    awaited_ = messages;
    come_.wait_for(lock, at_most, [&] { return has_come(); });
  }

 private:
  bool has_come() const { return heard_.size() >= awaited_ || !wrong_.empty(); }

  void put(const GuidPrefix& writer, Sample<Message>& sample) {
    const int from = roster_.number_of(writer);
    const std::string& run = address_.run;
    const std::lock_guard lock(mutex_);
    if (from < 0 || !Topic<Message>::has_say(from)) {
      refuse(writer, "who has no say there");
    } else if (!sample.wrong.empty() && (sample.run.empty() || sample.run == run)) {
      wrong_ = "a sample of " + said_by(writer) + " is no message: " + sample.wrong;
    } else if (sample.run != run) {
      refuse(writer, "of another run");
    } else if (!speaks_for_itself(from, sample.message)) {
      refuse(writer, "who speaks for another process");
    } else if (heard_.size() == std::size_t{most_unread}) {
      refuse(writer, "who says more than is read");
    } else {
      heard_.push_back({from, std::move(sample.message)});
    }
    if (has_come()) {
      come_.notify_one();
    }
  }

  void refuse(const GuidPrefix& writer, const char* why) { ++refused_[said_by(writer) + ", " + why]; }

  std::string said_by(const GuidPrefix& writer) const {
    const int from = roster_.number_of(writer);
    return Topic<Message>::name + (" from " + (from < 0 ? "participant " + text_of(writer) : name_of(from)));
  }

  template <class Said>
  bool speaks_for_itself(int /*from*/, const Said& /*message*/) const {
    return true;
  }

  bool speaks_for_itself(int from, const Hello& hello) const { return hello.name == name_of(from); }

  template <class Regional>
  bool speaks_for_itself(int from, const std::vector<Regional>& batch) const {
    return std::ranges::all_of(batch, [&](const auto& message) { return address_.agent_of(message.region) == from; });
  }

  const BusAddress& address_;
  const Roster& roster_;
  RegionRange regions_;
  std::mutex mutex_;
  std::condition_variable come_;
  std::size_t awaited_ = 1;
  std::vector<Heard<Message>> heard_;
  std::map<std::string, int> refused_;
  std::string wrong_;  ///< what one who has a say wrote, and is no message
};

}  // namespace evbal
