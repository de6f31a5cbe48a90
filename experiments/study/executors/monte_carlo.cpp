#include "experiments/study/executors/monte_carlo.hpp"

#include "common/decimal.hpp"
#include "common/digest.hpp"
#include "common/error.hpp"
#include "common/files.hpp"
#include "common/table_text.hpp"
#include "common/workers.hpp"
#include "experiments/record/paired_run.hpp"
#include "experiments/run/record_day.hpp"
#include "experiments/run/twins.hpp"
#include "experiments/study/executors/day_keys.hpp"
#include "experiments/study/executors/drawn_quantities.hpp"
#include "experiments/study/executors/draws_page.hpp"
#include "experiments/study/executors/play_days.hpp"
#include "experiments/study/executors/play_sweep.hpp"
#include "experiments/study/statistics/distribution.hpp"
#include "experiments/study/store/sweep_file.hpp"

#include <algorithm>

namespace evbal {
namespace {

namespace fs = std::filesystem;

/// What the draws of one controller came to.
struct Drawn {
  Run run;
  std::vector<std::map<std::string, double>> totals;  ///< of each draw, by metric
  std::map<std::string, double> without;              ///< faults

  std::vector<double> values(const std::string& metric) const {
    std::vector<double> all;
    all.reserve(totals.size());
    for (const auto& of_draw : totals) {
      all.push_back(of_draw.at(metric));
    }
    return all;
  }
};

std::string name_of(std::size_t draw) {
  return "draw-" + std::to_string(draw + 1);
}

Scenario with_draw(Scenario scenario, std::size_t draw) {
  scenario.schedule = scenario.draws[draw];
  scenario.draws = {scenario.schedule};
  return scenario;
}

std::string resolved_draw(const Scenario& scenario, std::size_t draw) {
  return resolved_yaml(with_draw(scenario, draw), scenario.planning.controller);
}

/// Plays the draws that have no result in runs.sqlite yet.
void play(const Draws& draws, const fs::path& folder, const DrawsStage& stage) {
  const fs::path file = draws_file(folder);
  const auto play_one = [&](std::size_t i) {
    const std::size_t per_run = draws.runs.front().scenario.draws.size();
    const Scenario scenario = with_draw(draws.runs[i / per_run].scenario, i % per_run);
    add_result(file, draws.keys[i], scenario.world.clock,
               stage.over_bus ? play_day(scenario, folder / "processes-of-a-draw") : play_day(scenario));
  };
  const auto work = [&](const std::vector<std::size_t>& days, const Done& done) {
    work_through(days, stage.over_bus ? 1 : cores(), play_one, done);
  };
  refuse_failed(do_days(draws.sweep, draws.keys, file, stage.on_day_ended, work), draws.sweep);
}

std::vector<Drawn> gathered(const std::vector<Run>& runs, const fs::path& folder) {
  const auto days = read_finished(draws_file(folder));
  std::vector<Drawn> all;
  for (const auto& run : runs) {
    Drawn drawn{.run = run, .totals = {}, .without = read_run(twin_folder(run.folder)).totals};
    for (const auto& day : days) {
      if (day.variant == run.scenario.planning.controller) {
        drawn.totals.push_back(day.totals);
      }
    }
    all.push_back(std::move(drawn));
  }
  return all;
}

std::string distribution_csv(const std::vector<Drawn>& all) {
  std::vector<std::string> cells = {"controller", "metric"};
  for (const auto& [name, value] : named(Distribution{})) {
    cells.push_back(name);
  }
  cells.emplace_back("without");
  std::string text = csv_row(cells);
  for (const auto& drawn : all) {
    for (const auto& metric : metric_names()) {
      cells = {drawn.run.scenario.planning.controller, metric};
      for (const auto& [name, value] : named(distribution_of(drawn.values(metric)))) {
        cells.push_back(decimal(value));
      }
      cells.push_back(decimal(drawn.without.at(metric)));
      text += csv_row(cells);
    }
  }
  return text;
}

/// What decides which draw is worst.
Expect measure_of_worst(const Scenario& scenario) {
  const std::vector<Expect> expected = of_runs(scenario.expect);
  return expected.empty() ? Expect{.metric = "lost"} : expected.front();
}

std::size_t worst_draw(const Drawn& drawn) {
  const Expect measure = measure_of_worst(drawn.run.scenario);
  return worst_of(drawn.values(measure.metric), measure.at_most);
}

DrawnController summary_of(const Drawn& drawn) {
  const Expect measure = measure_of_worst(drawn.run.scenario);
  const std::string& metric = measure.metric;
  const std::size_t worst = worst_draw(drawn);
  DrawnController summary{.controller = drawn.run.scenario.planning.controller,
                          .draws = drawn.totals.size(),
                          .metrics = {},
                          .worst = name_of(worst),
                          .worst_metric = metric,
                          .worst_value = drawn.totals[worst].at(metric),
                          .worst_file = drawn.run.folder / "worst.yaml",
                          .largest_is_worst = measure.at_most,
                          .values = drawn.values(metric)};
  summary.quantities = drawn_quantities(drawn.run.scenario.draws, drawn.run.scenario.world.clock.start);
  summary.influences = influences(summary.quantities, summary.values);
  for (const auto& name : expectable_metrics()) {
    summary.metrics.push_back({name, distribution_of(drawn.values(name)), drawn.without.at(name)});
  }
  return summary;
}

/// What was expected and did not hold, empty if all did.
std::string disappointments(const std::vector<Drawn>& all) {
  std::string failed;
  for (const auto& drawn : all) {
    for (const auto& expect : of_runs(drawn.run.scenario.expect)) {
      const std::vector<double> values = drawn.values(expect.metric);
      const auto misses = std::count_if(values.begin(), values.end(), [&](double x) { return !expect.holds(x); });
      if (misses > 0) {
        const std::size_t worst = worst_of(values, expect.at_most);
        failed += (failed.empty() ? "" : "; ") + drawn.run.scenario.planning.controller + ": " + expect.metric +
                  ", expected " + expect.words() + ", fails in " + std::to_string(misses) + " of " +
                  std::to_string(values.size()) + " draws, in " + name_of(worst) + " it is " + decimal(values[worst]);
      }
    }
  }
  return failed;
}

}  // namespace

std::string Draws::fingerprint() const {
  std::string all;
  for (const auto& key : keys) {
    all += key;
  }
  return text_digest(all);
}

Draws draws_of(const Scenario& scenario, const fs::path& folder) {
  Draws draws{.runs = runs_of(scenario, folder), .sweep = {}, .keys = {}};
  DayKeys day_keys;
  for (const auto& [of_controller, its_folder] : draws.runs) {
    const std::string& controller = of_controller.planning.controller;
    for (std::size_t draw = 0; draw < of_controller.draws.size(); ++draw) {
      const Scenario drawn = with_draw(of_controller, draw);
      draws.sweep.days.push_back({.variant = controller,
                                  .controller = controller,
                                  .faults = name_of(draw),
                                  .day = scenario.world.day.date,
                                  .seed = scenario.world.seed,
                                  .yaml = YamlValue::parse(resolved_yaml(drawn, controller), name_of(draw))});
      draws.keys.push_back(day_keys.of(drawn, controller));
    }
  }
  return draws;
}

fs::path draws_file(const fs::path& folder) {
  return folder / "runs.sqlite";
}

DrawsResult play_draws(const Draws& draws, const fs::path& folder, const DrawsStage& stage) {
  Twins twins(draws.runs);
  for (std::size_t run = 0; run < draws.runs.size(); ++run) {
    twins.need(run);
  }
  play(draws, folder, stage);
  twins.await();
  const std::vector<Drawn> all = gathered(draws.runs, folder);
  write_file(folder / "runs.csv", swept_days_csv(draws_file(folder)));
  write_file(folder / "distribution.csv", distribution_csv(all));
  DrawsResult result;
  for (const auto& drawn : all) {
    write_file(drawn.run.folder / "worst.yaml", resolved_draw(drawn.run.scenario, worst_draw(drawn)));
    result.controllers.push_back(summary_of(drawn));
  }
  write_file(folder / "influence.csv", influence_csv(result));
  write_file(folder / "draws.md", draws_markdown(result));
  result.disappointments = disappointments(all);
  return result;
}

}  // namespace evbal
