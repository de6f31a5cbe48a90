#pragma once

#include "experiments/record/run_record.hpp"

#include <span>
#include <string>
#include <vector>

namespace evbal {

/// summary.json of a finished run, as text:
///
///     scenario, date, seed, controller, transport, digest, scenario_digest (of scenario.resolved.yaml)
///     pack_digest, model_digest (of the files that the day was played with), program (version and build);
///     coordinator_digest, of the files of a coordinator in place of evbal's
///     steps, step_minutes, regions, fleet, fleet_conserved
///     totals       by the names of metrics/columns.hpp
///     solver       engine, solves, fallbacks, iterations, max_violation, max_gap, seconds in all,
///                  seconds_median, seconds_max of a solve (CPU); cross_check: engine, plans,
///                  unsolved, max_relative_difference, if plans were solved again by another engine
///     processes    how many processes wrote for the agents, the coordinator and the injector, the launcher left out:
///                  0 in one process; and how often one was started again
///     step_seconds wall time of a step: median, max, and median of what is left without the solver
///     wall_seconds
///     timings      what the legs of the ticks took, by process (all agents together) and leg: times, wall seconds
///                  in all, mean_ms, longest_ms
///     network      loss, delay_ms, deterministic_in_time, exchange_seconds (of a tick, without the solver); only
///                  if the scenario has the key
///     dds_profiles file of settings of Fast DDS, only if the scenario has the key
///     security     "on", only of a run over the bus whose scenario says so
///
/// `program`, `transport`, `processes`, `network`, `security`, `dds_profiles` and what is measured in time depend on
/// how the day was run, nothing else does.
std::string summary_json(const RunHeader& header, const DayMetrics& day, const RunResult& result,
                         std::span<const TickRecord> ticks, std::span<const double> tick_seconds,
                         const std::vector<ProcessLegs>& timings);

/// Plans that were not the controller's own.
int count_fallbacks(std::span<const TickRecord> ticks);

}  // namespace evbal
