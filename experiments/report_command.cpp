#include "experiments/report_command.hpp"

#include "common/error.hpp"
#include "coordinator/planning/city_model.hpp"
#include "experiments/record/recorded_run.hpp"
#include "experiments/record/text.hpp"
#include "experiments/scenario/scenario.hpp"
#include "tools/report/report.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>

namespace evbal {
namespace {

namespace fs = std::filesystem;

/// A run directory itself, or those in a directory of several.
std::vector<fs::path> runs_in(const fs::path& folder) {
  std::vector<fs::path> found;
  if (fs::is_directory(folder) && !fs::exists(folder / "run.sqlite")) {
    for (const auto& entry : fs::directory_iterator(folder)) {
      if (fs::exists(entry.path() / "summary.json")) {
        found.push_back(entry.path());
      }
    }
    std::sort(found.begin(), found.end());
  }
  return found.empty() ? std::vector<fs::path>{folder} : found;
}

/// What the run's model says of its day one step ahead, demand and supply.
std::vector<ForecastFigure> forecast_figures(const RecordedRun& run, const Scenario& scenario) {
  const CityModel model = read_model(model_file(scenario.planning, scenario.world.city));
  if (model.regions() != run.regions) {
    return {};
  }
  const DayKind kind = model.kind(run.date);
  const int start = scenario.world.clock.start - model.day_start;
  std::vector<ForecastFigure> figures{
      forecast_figure(model.demand.seasonal, kind, start, run.by_region.at("demand")),
      forecast_figure(model.completions.seasonal, kind, start, run.by_region.at("completions"))};
  figures[0].title = "Demand, forecast and real";
  figures[0].unit = "passengers per step";
  figures[1].title = "Supply, forecast and real";
  figures[1].unit = "charging sessions that end, per step";
  return figures;
}

/// The runs, and what their city adds to them, if it is still there: a run outlives it.
PageContent content_on(const std::vector<RecordedRun>& runs) {
  PageContent content{.runs = runs};
  try {
    const Scenario scenario = read_scenario(runs.front().folder / "scenario.resolved.yaml");
    content.map = city_map(scenario.world.city.regions);
    content.forecasts = forecast_figures(runs.front(), scenario);
  } catch (const Error&) {
    return content;
  }
  return content;
}

void report(const std::vector<std::string>& folders, const std::string& out) {
  std::vector<RecordedRun> runs;
  for (const auto& given : folders) {
    for (const auto& folder : runs_in(given)) {
      runs.push_back(read_run(folder));
    }
  }
  const fs::path page =
      !out.empty() ? fs::path(out) : (folders.size() == 1 ? fs::path(folders[0]) : ".") / "report.html";
  write_report(page, runs);
  std::printf("%s\n", page.c_str());
}

}  // namespace

void write_report(const fs::path& page, const std::vector<RecordedRun>& runs) {
  write_file(page, report_page(content_on(runs)));
}

void add_report_command(CLI::App& app) {
  struct Arguments {
    std::vector<std::string> folders;
    std::string out;
  };
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("report", "Write one HTML page on finished runs");
  command->add_option("DIR", arguments->folders, "Run directories, or directories of them")->required();
  command->add_option("--out", arguments->out, "The page; otherwise report.html in DIR, or here if there are several");
  command->callback([arguments] { report(arguments->folders, arguments->out); });
}

}  // namespace evbal
