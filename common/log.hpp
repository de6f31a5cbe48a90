#pragma once

#include <string>
#include <vector>

namespace evbal {

/// How much a line of the log matters, from least to most.
enum class LogLevel { debug, info, warn, error };

/// Their names, in that order: "debug", "info", "warn", "error".
const std::vector<std::string>& log_levels();

/// The level of that name. Throws Error{bad_input} with those that there are.
LogLevel log_level_of(const std::string& name);

/// Says whose lines this process's log has, and from which level on they are written, to stderr; before that, from
/// `warn` on. To be called before there are threads.
void begin_log(const std::string& name, LogLevel least);

/// From which level on lines are written.
LogLevel least_logged();

/// Whether lines of a level are written.
bool is_logged(LogLevel level);

/// Writes a line, with time, level and name before it, if its level is written. From any thread.
void log_line(LogLevel level, const std::string& line);

}  // namespace evbal
