#pragma once

#include "experiments/record/run_record.hpp"
#include "experiments/study/executors/monte_carlo.hpp"
#include "experiments/study/statistics/comparison.hpp"
#include "experiments/study/statistics/primaries.hpp"
#include "tools/evbal/diagnosis.hpp"
#include "tools/evbal/listing.hpp"
#include "tools/evbal/sourced_scenario.hpp"
#include "tools/verify/verify.hpp"

#include <filesystem>
#include <string>
#include <vector>

/// What `--json` prints in place of tables: one JSON document, with a line break at its end. Numbers are not rounded,
/// what is not known or infinite is null.
namespace evbal {

/// {"report": file, "runs": [what summary.json of each has, and its `folder`]}. Throws Error{run_failed} if one cannot
/// be read.
std::string runs_json(const std::vector<RunResult>& runs, const std::filesystem::path& report);

/// {"folder": folder, "controllers": [{controller, draws, metrics, worst}]}
std::string draws_json(const DrawsResult& draws, const std::filesystem::path& folder);

/// [{scenario, faults, variant, settings, metric, reference_variant, at, whole, days, apart, points, inside, from, to,
/// covered, value, reference, of_totals, relative, difference, p, p_holm, way}]; `p_holm` of the page's primary
/// endpoints only.
std::string compared_json(const std::vector<AnsweredQuestion>& answers, const std::vector<PrimaryAnswer>& primaries);

/// [{what, cases, largest, allowed, holds, where}]
std::string comparisons_json(const std::vector<Comparison>& comparisons);

/// A list of maps, by column.
std::string listing_json(const Listing& listing);

/// {"scenario": {...}, "sources": {"balancing.tau": source}}
std::string sourced_json(const SourcedScenario& scenario);

/// [{what, well, cure}]; `well` is null where either will do, `cure` where none is needed.
std::string findings_json(const std::vector<Finding>& findings);

}  // namespace evbal
