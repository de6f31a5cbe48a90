#include "tools/evbal/report_content.hpp"

#include "common/error.hpp"
#include "common/files.hpp"
#include "coordinator/planning/city_model.hpp"
#include "experiments/bound/bound_file.hpp"
#include "experiments/record/paired_run.hpp"
#include "experiments/scenario/scenario.hpp"
#include "experiments/study/store/sweep_folder.hpp"
#include "tools/evbal/runs_folder.hpp"
#include "tools/evbal/study_page.hpp"

#include <algorithm>
#include <functional>
#include <iterator>
#include <optional>
#include <set>
#include <utility>

namespace evbal {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> hourly_columns = {"idle_km", "unfairness_demand", "unfairness_charging", "lost"};

/// Adds to the page what `add` reads, or that `what` is left out and why.
void add_or_say(PageContent& content, const std::string& what, const std::function<void()>& add) {
  try {
    add();
  } catch (const Error& error) {
    content.left_out.push_back("Left out: " + what + ". " + error.what());
  }
}

CityModel model_of(const Scenario& scenario) {
  return read_model(model_file(scenario.planning, scenario.world.city));
}

/// What the model says one step ahead of `counts` of the scenario's day.
ForecastFigure figure_of(const SeriesModel& series, const CityModel& model, const Scenario& scenario,
                         const Eigen::MatrixXd& counts) {
  const int start = scenario.world.clock.start;
  ForecastFigure figure =
      forecast_figure(series.seasonal, model.kind(scenario.world.day.date), start - model.day_start, counts);
  figure.start = start;
  return figure;
}

std::vector<ForecastFigure> forecast_figures(const RecordedRun& run, const CityModel& model, const Scenario& scenario) {
  if (model.regions() != run.regions) {
    throw bad_input("the model has " + std::to_string(model.regions()) + " regions, the run " +
                    std::to_string(run.regions));
  }
  std::vector<ForecastFigure> figures{figure_of(model.demand, model, scenario, run.by_region.at("demand")),
                                      figure_of(model.completions, model, scenario, run.by_region.at("completions"))};
  figures[0].title = "Demand, forecast and real";
  figures[0].unit = "passengers per step";
  figures[1].title = "Supply, forecast and real";
  figures[1].unit = "charging sessions that end, per step";
  for (auto& figure : figures) {
    figure.note = "The whole city, " + run.controller + "; faults are in what came, not in the forecast.";
  }
  return figures;
}

/// The recorded trips of the scenario's day by origin, N x steps of its clock.
Eigen::MatrixXd recorded_demand(const Scenario& scenario) {
  const City& city = scenario.world.city;
  const DayClock& clock = scenario.world.clock;
  const int first = (clock.start - city.day_start) / city.step_minutes;
  Eigen::MatrixXd counts = Eigen::MatrixXd::Zero(city.size(), clock.minutes() / city.step_minutes);
  for (int step = 0; step < counts.cols(); ++step) {
    for (const auto& [origin, destination, trips] : scenario.world.day.steps.at(first + step)) {
      counts(origin, step) += trips;
    }
  }
  return counts;
}

ForecastFigure history_figure(const CityModel& model, const Scenario& scenario) {
  ForecastFigure figure = figure_of(model.demand, model, scenario, recorded_demand(scenario));
  figure.title = "Demand, forecast and on record";
  figure.unit = "passengers per step";
  figure.note = "The whole city on " + scenario.world.day.date + ", trips as recorded.";
  return figure;
}

std::vector<FittedThresholds> thresholds_of(const CityModel& model) {
  std::vector<FittedThresholds> all;
  for (const auto& [name, series] :
       {std::pair("demand", &model.demand), std::pair("completions", &model.completions)}) {
    for (int lead = 0; lead < model.leads(); ++lead) {
      const Thresholds& fitted = series->errors.thresholds[static_cast<std::size_t>(lead)];
      all.push_back({.series = name, .steps = lead + 1, .g1 = fitted.g1, .g2 = fitted.g2});
    }
  }
  return all;
}

/// The run, and the one without faults beside it.
ReportedRun reported(const RecordedRun& run) {
  ReportedRun reported{run};
  if (fs::exists(twin_folder(run.folder) / "summary.json")) {
    reported.without_faults = read_run(twin_folder(run.folder));
  }
  return reported;
}

/// The bound that was computed for the run's day, if one was.
std::optional<DayBound> known_bound(const RecordedRun& run) {
  if (!fs::exists(bounds_folder())) {
    return std::nullopt;
  }
  return read_bound(bound_file(bounds_folder(), bound_key(read_scenario(run.folder / "scenario.resolved.yaml"))));
}

/// The map of the runs' city, if all are of one with as many regions.
void add_map(const std::vector<RecordedRun>& runs, const City& city, PageContent& content) {
  const auto elsewhere =
      std::find_if(runs.begin(), runs.end(), [&](const RecordedRun& run) { return run.regions != city.size(); });
  if (elsewhere != runs.end()) {
    throw bad_input(elsewhere->folder.string() + " has " + std::to_string(elsewhere->regions) + " regions, the city " +
                    city.name + " has " + std::to_string(city.size()));
  }
  content.map = city_map(city.regions);
}

void add_runs(const std::vector<RecordedRun>& runs, PageContent& content) {
  std::transform(runs.begin(), runs.end(), std::back_inserter(content.runs), reported);
  add_or_say(content, "bounds", [&] {
    for (ReportedRun& run : content.runs) {
      run.bound = known_bound(run);
    }
  });
  add_or_say(content, "map, forecasts and thresholds", [&] {
    const Scenario scenario = read_scenario(runs.front().folder / "scenario.resolved.yaml");
    add_or_say(content, "map", [&] { add_map(runs, scenario.world.city, content); });
    add_or_say(content, "forecasts and thresholds", [&] {
      const CityModel model = model_of(scenario);
      content.thresholds = thresholds_of(model);
      content.forecasts = forecast_figures(runs.front(), model, scenario);
    });
  });
}

/// The bound of each scenario and schedule of faults, if it is kept for each of its days.
std::vector<SweptBound> swept_bounds(const PageDays& days) {
  std::vector<SweptBound> bounds;
  std::set<std::pair<std::string, std::string>> seen;
  for (const FinishedDay& corner : days.bounds) {
    if (seen.emplace(corner.scenario, corner.faults).second) {
      bounds.push_back({corner.scenario, corner.faults, mean_bound(days, corner.scenario, corner.faults).front});
    }
  }
  std::erase_if(bounds, [](const SweptBound& bound) { return bound.corners.empty(); });
  return bounds;
}

/// What the sweep's page answers; nothing if it has none.
SweptAnswers swept_answers(const StudyPage& study) {
  return {study_text(study), study.figures};
}

/// Whom the others are compared with if nobody is named.
std::vector<std::string> references_of(const StudyPage& study) {
  if (!study.page.verdict.empty()) {
    return study.page.verdict.front().fronts.front().against;
  }
  return study.page.title.empty() ? std::vector{study.days.days.front().variant} : std::vector<std::string>{};
}

SweepContent sweep_content(const fs::path& folder, const StudyPage& study, std::vector<std::string> against,
                           DayFilter filter) {
  const bool all = is_empty(filter);
  if (against.empty()) {
    against = references_of(study);
  }
  if (!filter.variants.empty()) {
    filter.variants.insert(filter.variants.end(), against.begin(), against.end());
  }
  const auto chosen = positions_of(filter, study.days.days);
  const auto days = at_positions(chosen, study.days.days);
  const auto steps = at_positions(chosen, read_finished_steps(folder / sweep_file_name, hourly_columns));
  return {.folder = folder.string(),
          .origin = study.origin,
          .page = all && !study.page.title.empty() ? swept_answers(study) : SweptAnswers{},
          .days = static_cast<int>(days.size()),
          .points = swept_points(days, steps),
          .answers = answers(days, against, all ? study.primaries : std::vector<PrimaryAnswer>{}),
          .bounds = all ? swept_bounds(study.days) : std::vector<SweptBound>{}};
}

}  // namespace

PageContent content_on(const std::vector<RecordedRun>& runs) {
  PageContent content{.title = runs.front().scenario,
                      .subtitle = "What became of the day; faults in their windows are shaded."};
  add_runs(runs, content);
  return content;
}

PageContent content_on(const fs::path& folder, const std::vector<std::string>& against, const DayFilter& filter,
                       const std::vector<RecordedRun>& runs) {
  const StudyPage study = read_study_page(folder);
  PageContent content{.sweep = sweep_content(folder, study, against, filter)};
  content.title = study.page.title.empty() ? fs::path(study.origin.file).stem().string() : study.page.title;
  if (content.sweep->page.text.verdict.empty()) {
    content.subtitle = is_empty(filter) ? "A sweep: every variant on the same days, seeds and faults."
                                        : "Some of a sweep's days, as asked for.";
  }
  if (!runs.empty()) {
    add_runs(runs, content);
    return content;
  }
  add_or_say(content, "forecasts and thresholds", [&] {
    const Scenario scenario = read_scenario(YamlValue::parse(content.sweep->origin.scenario, "sweep.sqlite"));
    const CityModel model = model_of(scenario);
    content.thresholds = thresholds_of(model);
    content.forecasts = {history_figure(model, scenario)};
  });
  return content;
}

}  // namespace evbal
