#include "common/legs.hpp"

#include <mrpt/system/CTimeLogger.h>

#include <map>

namespace evbal {

using mrpt::system::CTimeLogger;

Legs::Legs() : times_(std::make_unique<CTimeLogger>()) {
  times_->logging_enable_console_output = false;  // where it would tell of them at its end
}

Legs::~Legs() = default;

void Legs::add(const char* name, std::chrono::steady_clock::time_point begin) {
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
  times_->registerUserMeasure(name, taken.count(), true);
}

std::vector<Leg> Legs::taken() const {
  std::map<std::string, CTimeLogger::TCallStats> stats;
  times_->getStats(stats);
  std::vector<Leg> legs;
  for (const auto& [name, leg] : stats) {
    legs.push_back(
        {.name = name, .times = static_cast<std::int64_t>(leg.n_calls), .seconds = leg.total_t, .longest = leg.max_t});
  }
  return legs;
}

}  // namespace evbal
