#include "tools/report/report.hpp"

#include "common/error.hpp"
#include "tools/report/assets.hpp"

#include <nlohmann/json.hpp>

#include <string_view>

namespace evbal {
namespace {

using Json = nlohmann::ordered_json;

Json forecasts_json(const std::vector<ForecastFigure>& forecasts) {
  const auto numbers = [](const Eigen::VectorXd& vector) { return std::vector<double>(vector.begin(), vector.end()); };
  Json all = Json::array();
  for (const ForecastFigure& figure : forecasts) {
    all.push_back({{"title", figure.title},
                   {"note", figure.note},
                   {"unit", figure.unit},
                   {"start", figure.start},
                   {"step_minutes", figure.step_minutes},
                   {"observed", numbers(figure.observed)},
                   {"forecast", numbers(figure.forecast)},
                   {"deviation", numbers(figure.deviation)}});
  }
  return all;
}

Json thresholds_json(const std::vector<FittedThresholds>& thresholds) {
  Json all = Json::array();
  for (const auto& [series, steps, g1, g2] : thresholds) {
    all.push_back({{"series", series}, {"steps", steps}, {"g1", g1}, {"g2", g2}});
  }
  return all;
}

void check_clocks(const std::vector<ReportedRun>& runs) {
  for (const auto& run : runs) {
    if (run.step_minutes != runs.front().step_minutes || run.day_start != runs.front().day_start ||
        run.steps.at("step").size() != runs.front().steps.at("step").size()) {
      throw bad_input(run.folder.string() + ": has another clock than " + runs.front().folder.string() +
                      "; report runs of the same clock together");
    }
  }
}

Json content_json(const PageContent& content) {
  const auto same_city = [&](const RecordedRun& run) {
    return content.map && static_cast<std::size_t>(run.regions) == content.map->names.size();
  };
  const bool map = !content.runs.empty() && std::all_of(content.runs.begin(), content.runs.end(), same_city);
  Json json = {{"title", content.title},
               {"subtitle", content.subtitle},
               {"left_out", content.left_out},
               {"draws", content.draws},
               {"runs", runs_json(content.runs, map)},
               {"windows", windows_json(content.runs)},
               {"forecasts", forecasts_json(content.forecasts)},
               {"thresholds", thresholds_json(content.thresholds)}};
  if (!content.runs.empty()) {
    json["day_start"] = content.runs.front().day_start;
    json["step_minutes"] = content.runs.front().step_minutes;
  }
  if (map) {
    json["map"] = map_json(*content.map);
  }
  if (content.sweep) {
    json["sweep"] = sweep_json(*content.sweep);
  }
  return json;
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

std::string report_page(const PageContent& content) {
  check_clocks(content.runs);
  std::string page = filled(page_html, "/*PAGE_CSS*/", page_css);
  page = filled(std::move(page), "/*D3_JS*/", d3_js);
  page = filled(std::move(page), "/*PAGE_JS*/", page_js);
  return filled(std::move(page), "/*DATA*/", script_safe(content_json(content)));
}

}  // namespace evbal
