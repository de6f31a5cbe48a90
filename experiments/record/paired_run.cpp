#include "experiments/record/paired_run.hpp"

#include "common/contract.hpp"
#include "common/decimal.hpp"
#include "common/files.hpp"
#include "common/table_text.hpp"

#include <nlohmann/json.hpp>

namespace evbal {
namespace {

using Json = nlohmann::ordered_json;

/// The numbers of a row by name, in the order of the files: `visit("name", value)`.
template <class Visit>
void columns(Visit&& visit, const FaultCost& cost) {
  visit("with", cost.with);
  visit("without", cost.without);
  visit("cost", cost.cost());
  visit("area", cost.area);
  visit("signed_area", cost.signed_area);
  visit("band", cost.band);
}

std::string cell(const std::optional<int>& minutes) {
  return minutes ? decimal(*minutes) : "";
}

Json value(const std::optional<int>& minutes) {
  return minutes ? Json(*minutes) : Json(nullptr);
}

std::string csv(const RecordedRun& run, const std::vector<MetricCost>& costs) {
  std::vector<std::string> cells = {"metric"};
  columns([&](const char* name, double) { cells.emplace_back(name); }, FaultCost{});
  cells.emplace_back("recovered_min");
  for (const auto& fault : run.faults) {
    cells.push_back("recovered_min:" + fault.name);
  }
  std::string text = csv_row(cells);
  for (const auto& [metric, cost] : costs) {
    cells = {metric};
    columns([&](const char*, double number) { cells.push_back(decimal(number)); }, cost);
    cells.push_back(cell(cost.recovered));
    for (const auto& minutes : cost.by_fault) {
      cells.push_back(cell(minutes));
    }
    text += csv_row(cells);
  }
  return text;
}

Json json(const RecordedRun& run, const std::vector<MetricCost>& costs) {
  Json metrics;
  for (const auto& [metric, cost] : costs) {
    Json& row = metrics[metric];
    columns([&](const char* name, double number) { row[name] = number; }, cost);
    row["recovered_min"] = value(cost.recovered);
    for (std::size_t fault = 0; fault < run.faults.size(); ++fault) {
      row["by_fault"][run.faults[fault].name] = value(cost.by_fault[fault]);
    }
  }
  return metrics;
}

}  // namespace

std::filesystem::path twin_folder(const std::filesystem::path& folder) {
  return folder / "without-faults";
}

std::vector<MetricCost> costs_of(const RecordedRun& run, const RecordedRun& twin) {
  EVBAL_EXPECT(run.step_minutes == twin.step_minutes, "a twin with steps of the same length");
  std::vector<FaultWindow> windows;
  for (const auto& fault : run.faults) {
    windows.push_back({fault.start, fault.end});
  }
  std::vector<MetricCost> costs;
  for (const auto& metric : costed_metrics()) {
    const PairedCurves curves{run.steps.at(metric.name), twin.steps.at(metric.name), run.step_minutes};
    costs.push_back({metric.name, fault_cost(curves, metric.stock, windows)});
  }
  return costs;
}

void write_costs(const RecordedRun& run, const RecordedRun& twin, const std::vector<MetricCost>& costs) {
  write_file(run.folder / "faults.csv", csv(run, costs));
  const auto file = run.folder / "summary.json";
  Json summary = Json::parse(text_of_file(file));
  summary["without_faults"] = {{"digest", twin.digest}, {"metrics", json(run, costs)}};
  write_file(file, summary.dump(2) + "\n");
}

}  // namespace evbal
