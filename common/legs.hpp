#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace mrpt::system {
class CTimeLogger;
}

namespace evbal {

/// What one leg of a tick took in a process, in wall seconds.
struct Leg {
  std::string name;        ///< what it did: "live", "wait for the plan"
  std::int64_t times = 0;  ///< that it was done
  double seconds = 0.0;    ///< in all
  double longest = 0.0;    ///< seconds
};

/// What the legs of a process took.
struct ProcessLegs {
  std::string process;    ///< "conductor", "coordinator", "faults", "agent-0"
  std::vector<Leg> legs;  ///< by name
};

/// Times the legs of a process's ticks. Any thread may ask what they took meanwhile.
class Legs {
 public:
  /// None has been done.
  Legs();
  ~Legs();
  Legs(const Legs&) = delete;
  Legs& operator=(const Legs&) = delete;

  /// Gives what `leg` gives; the time it takes counts under `name`, unless it throws.
  template <class Function>
  auto time(const char* name, Function&& leg) {
    const auto begin = std::chrono::steady_clock::now();
    if constexpr (std::is_void_v<decltype(leg())>) {
      std::forward<Function>(leg)();
      add(name, begin);
    } else {
      auto given = std::forward<Function>(leg)();
      add(name, begin);
      return given;
    }
  }

  /// What the legs took so far, by name.
  std::vector<Leg> taken() const;

 private:
  void add(const char* name, std::chrono::steady_clock::time_point begin);

  std::unique_ptr<mrpt::system::CTimeLogger> times_;
};

}  // namespace evbal
