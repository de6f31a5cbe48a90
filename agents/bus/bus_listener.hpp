#pragma once

#include "agents/bus/fast_dds.hpp"
#include "agents/bus/strangers.hpp"

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <string>

namespace evbal {

/// What a participant is told of the others: counts how often an end of a topic has found, or lost, another, and keeps
/// an account of strangers.
class BusListener : public fast_dds::DiscoveryListener {
 public:
  /// `roster` must outlive this.
  explicit BusListener(const Roster& roster) : strangers_(roster) {}

  /// A writer of ours has found, or lost, a reader.
  void on_publication_matched(fast_dds::dds::DataWriter* /*writer*/,
                              const fast_dds::dds::PublicationMatchedStatus& /*status*/) override {
    count();
  }
  /// A reader of ours has found, or lost, a writer.
  void on_subscription_matched(fast_dds::dds::DataReader* /*reader*/,
                               const fast_dds::dds::SubscriptionMatchedStatus& /*status*/) override {
    count();
  }

  /// A participant announces itself.
  void on_seen(const GuidPrefix& who, const std::string& name) override { strangers_.seen(who, name); }
  /// It is gone.
  void on_left(const GuidPrefix& who) override { strangers_.left(who); }
  /// It has proved that it belongs to the run, or failed to.
  void on_proof(const GuidPrefix& who, bool proved) override {
    proved ? strangers_.proved(who) : strangers_.failed(who);
  }

  /// Until an end has found or lost another since the last call, or the time is up.
  void wait(std::chrono::milliseconds at_most) {
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, at_most, [&] { return count_ != seen_; });
    seen_ = count_;
  }

  /// Who has not proved itself.
  Strangers& strangers() { return strangers_; }

 private:
  void count() {
    const std::lock_guard lock(mutex_);
    ++count_;
    changed_.notify_one();
  }

  Strangers strangers_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::uint64_t count_ = 0;
  std::uint64_t seen_ = 0;
};

}  // namespace evbal
