#include "common/log.hpp"

#include "common/error.hpp"

#include <mrpt/core/Clock.h>
#include <mrpt/system/COutputLogger.h>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <string_view>

namespace evbal {
namespace {

using mrpt::system::COutputLogger;
using mrpt::system::VerbosityLevel;

VerbosityLevel mrpt_level(LogLevel level) {
  return static_cast<VerbosityLevel>(level);
}

/// One call writes the line, so that those of several threads do not mix.
void write_line(std::string_view line, VerbosityLevel level, std::string_view name, mrpt::Clock::time_point when) {
  const std::time_t second = static_cast<std::time_t>(mrpt::Clock::toDouble(when));
  std::tm parts{};
  char time[16] = "";
  std::strftime(time, sizeof time, "%H:%M:%S", localtime_r(&second, &parts));
  const std::string text = std::string(time) + " " + log_levels()[static_cast<std::size_t>(level)] + " " +
                           std::string(name) + ": " + std::string(line) + "\n";
  std::fwrite(text.data(), 1, text.size(), stderr);
}

/// This process's, which threads may use until its very end.
COutputLogger& logger() {
  static COutputLogger& only = [&]() -> COutputLogger& {
    auto* made = new COutputLogger("evbal");
    made->logging_enable_console_output = false;
    made->logRegisterCallback(write_line);
    made->setMinLoggingLevel(mrpt::system::LVL_WARN);
    return *made;
  }();
  return only;
}

}  // namespace

const std::vector<std::string>& log_levels() {
  static const std::vector<std::string> names = {"debug", "info", "warn", "error"};
  return names;
}

LogLevel log_level_of(const std::string& name) {
  const auto found = std::find(log_levels().begin(), log_levels().end(), name);
  if (found == log_levels().end()) {
    throw bad_input("`" + name + "` is no level of a log; choose debug, info, warn or error");
  }
  return static_cast<LogLevel>(found - log_levels().begin());
}

void begin_log(const std::string& name, LogLevel least) {
  logger().setLoggerName(name);
  logger().setMinLoggingLevel(mrpt_level(least));
}

LogLevel least_logged() {
  return static_cast<LogLevel>(logger().getMinLoggingLevel());
}

bool is_logged(LogLevel level) {
  return logger().isLoggingLevelVisible(mrpt_level(level));
}

void log_line(LogLevel level, const std::string& line) {
  if (is_logged(level)) {
    logger().logStr(mrpt_level(level), line);
  }
}

}  // namespace evbal
