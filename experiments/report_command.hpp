#pragma once

#include "experiments/record/recorded_run.hpp"

#include <filesystem>
#include <vector>

namespace CLI {
class App;
}

namespace evbal {

/// Writes the page on these runs (tools/report), with what the first one's model says of its day.
void write_report(const std::filesystem::path& page, const std::vector<RecordedRun>& runs);

/// Adds `evbal report DIR...`: one HTML page on finished runs.
/// The command throws Error, whose status main exits with.
void add_report_command(CLI::App& app);

}  // namespace evbal
