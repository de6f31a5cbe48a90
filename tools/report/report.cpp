#include "tools/report/report.hpp"

#include "common/error.hpp"
#include "tools/report/assets.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <set>
#include <string_view>

namespace evbal {
namespace {

using Json = nlohmann::ordered_json;

/// The controller's name, with the directory's where two runs have the same.
std::vector<std::string> labels_of(const std::vector<RecordedRun>& runs) {
  std::vector<std::string> labels;
  for (const auto& run : runs) {
    const auto alike =
        std::count_if(runs.begin(), runs.end(), [&](const auto& other) { return other.controller == run.controller; });
    const auto folder = run.folder.has_filename() ? run.folder.filename() : run.folder.parent_path().filename();
    labels.push_back(alike == 1 ? run.controller : run.controller + " (" + folder.string() + ")");
  }
  return labels;
}

Json faults_json(const std::vector<RecordedRun>& runs) {
  Json faults = Json::array();
  std::set<std::string> seen;
  for (const auto& run : runs) {
    for (const auto& fault : run.faults) {
      const Json json = {{"name", fault.name}, {"type", fault.type}, {"start", fault.start}, {"end", fault.end}};
      if (seen.insert(json.dump()).second) {
        faults.push_back(json);
      }
    }
  }
  return faults;
}

Json runs_json(const std::vector<RecordedRun>& runs) {
  const auto labels = labels_of(runs);
  Json all = Json::array();
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const RecordedRun& run = runs[i];
    all.push_back({{"label", labels[i]},
                   {"controller", run.controller},
                   {"folder", run.folder.string()},
                   {"scenario", run.scenario},
                   {"date", run.date},
                   {"seed", std::to_string(run.seed)},
                   {"transport", run.transport},
                   {"digest", run.digest},
                   {"regions", run.regions},
                   {"fleet", run.fleet},
                   {"solves", run.solves},
                   {"fallbacks", run.fallbacks},
                   {"solve_seconds_median", run.solve_seconds_median},
                   {"wall_seconds", run.wall_seconds},
                   {"totals", run.totals},
                   {"steps", run.steps}});
  }
  return all;
}

Json forecasts_json(const std::vector<ForecastFigure>& forecasts) {
  const auto numbers = [](const Eigen::VectorXd& vector) { return std::vector<double>(vector.begin(), vector.end()); };
  Json all = Json::array();
  for (const ForecastFigure& figure : forecasts) {
    all.push_back({{"title", figure.title},
                   {"unit", figure.unit},
                   {"observed", numbers(figure.observed)},
                   {"forecast", numbers(figure.forecast)},
                   {"deviation", numbers(figure.deviation)}});
  }
  return all;
}

/// JSON that may stand within a script element.
std::string script_safe(const Json& json) {
  std::string text = json.dump();
  for (std::size_t at = text.find('<'); at != std::string::npos; at = text.find('<', at)) {
    text.replace(at, 1, "\\u003c");
  }
  return text;
}

std::string filled(std::string page, std::string_view place, std::string_view content) {
  return page.replace(page.find(place), place.size(), content);
}

}  // namespace

std::string report_page(const std::vector<RecordedRun>& runs, const std::vector<ForecastFigure>& forecasts) {
  for (const auto& run : runs) {
    if (run.step_minutes != runs.front().step_minutes || run.day_start != runs.front().day_start ||
        run.steps.at("step").size() != runs.front().steps.at("step").size()) {
      throw bad_input(run.folder.string() + ": has another clock than " + runs.front().folder.string() +
                      "; report runs of the same clock together");
    }
  }
  const Json data = {{"day_start", runs.front().day_start},
                     {"step_minutes", runs.front().step_minutes},
                     {"runs", runs_json(runs)},
                     {"forecasts", forecasts_json(forecasts)},
                     {"faults", faults_json(runs)}};
  std::string page = filled(page_html, "/*PAGE_CSS*/", page_css);
  page = filled(std::move(page), "/*D3_JS*/", d3_js);
  page = filled(std::move(page), "/*PAGE_JS*/", page_js);
  return filled(std::move(page), "/*DATA*/", script_safe(data));
}

}  // namespace evbal
