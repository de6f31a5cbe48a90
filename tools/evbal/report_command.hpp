#pragma once

#include "experiments/record/recorded_run.hpp"

#include <filesystem>
#include <vector>

namespace CLI {
class App;
}

namespace evbal {

/// Writes the page on these runs (docs/reports.md).
void write_report(const std::filesystem::path& page, const std::vector<RecordedRun>& runs);

/// Adds `evbal report DIR...`: one HTML page on finished runs, or on a sweep.
/// The command throws Error, whose status main exits with.
void add_report_command(CLI::App& app);

}  // namespace evbal
