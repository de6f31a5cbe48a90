#include "experiments/record/compare.hpp"

#include "common/digest.hpp"
#include "common/files.hpp"
#include "common/plain_text.hpp"
#include "common/table_text.hpp"
#include "experiments/record/compare_days.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <vector>

namespace evbal {
namespace {

namespace fs = std::filesystem;

std::string cell(const std::vector<std::string>& cells, std::size_t column) {
  return column < cells.size() ? "`" + cells[column] + "`" : "missing";
}

/// "step 5 (tick 30), region 3", from the cells of a row of steps.csv or regions.csv.
std::string place_of(const std::vector<std::string>& names, const std::vector<std::string>& cells,
                     const DayClock& clock) {
  std::string place;
  for (std::size_t i = 0; i < names.size() && i < cells.size(); ++i) {
    if (names[i] == "step") {
      const int tick = std::stoi(cells[i]) * (clock.step / clock.tick);
      place += "step " + cells[i] + " (tick " + std::to_string(tick) + ")";
    } else if (names[i] == "region") {
      place += ", region " + cells[i];
    }
  }
  return place;
}

std::optional<std::string> compare_csv(const fs::path& recorded, const fs::path& replayed, const DayClock& clock) {
  const std::string was = text_of_file(recorded);
  const std::string is = text_of_file(replayed);
  if (was == is) {
    return std::nullopt;
  }
  const auto was_lines = lines_of(was);
  const auto is_lines = lines_of(is);
  const std::string file = recorded.filename().string() + ": ";
  const auto names = split_csv(is_lines.front());
  for (std::size_t row = 0; row < is_lines.size(); ++row) {
    const auto was_cells = row < was_lines.size() ? split_csv(was_lines[row]) : std::vector<std::string>{};
    const auto is_cells = split_csv(is_lines[row]);
    for (std::size_t column = 0; column < std::max(was_cells.size(), is_cells.size()); ++column) {
      if (cell(was_cells, column) != cell(is_cells, column)) {
        const std::string place = row == 0 ? "header" : place_of(names, is_cells, clock);
        const std::string name = column < names.size() ? names[column] : "a further column";
        return file + place + ": " + disagreement(name, cell(was_cells, column), cell(is_cells, column));
      }
    }
  }
  return file + "has " + std::to_string(was_lines.size()) + " lines, the replay gives " +
         std::to_string(is_lines.size());
}

/// Drops what depends on how the run was made, or on another run.
void forget_circumstances(nlohmann::json& summary) {
  for (const char* key : {"processes", "network", "security", "dds_profiles", "step_seconds", "wall_seconds", "timings",
                          "without_faults", "program", "pack_digest", "model_digest", "coordinator_digest"}) {
    summary.erase(key);
  }
  if (summary.contains("solver") && summary["solver"].is_object()) {
    for (const char* key : {"seconds", "seconds_median", "seconds_max"}) {
      summary["solver"].erase(key);
    }
  }
}

std::optional<std::string> compare_summaries(const fs::path& recorded, const fs::path& replayed) {
  nlohmann::json was = nlohmann::json::parse(text_of_file(recorded), nullptr, false);
  nlohmann::json is = nlohmann::json::parse(text_of_file(replayed), nullptr, false);
  if (was.is_discarded() || !was.is_object()) {
    return "summary.json: cannot be read as JSON";
  }
  forget_circumstances(was);
  forget_circumstances(is);
  const nlohmann::json was_values = was.flatten();
  const nlohmann::json is_values = is.flatten();
  for (const auto& [key, value] : is_values.items()) {
    if (!was_values.contains(key) || was_values.at(key) != value) {
      const std::string said = was_values.contains(key) ? was_values.at(key).dump() : "missing";
      return key == "/scenario_digest"
                 ? "scenario.resolved.yaml: is not the text that the run was made from (all ticks and regions agree)"
                 : "summary.json: " + disagreement(key.substr(1), said, value.dump());
    }
  }
  for (const auto& [key, value] : was_values.items()) {
    if (!is_values.contains(key)) {
      return "summary.json: " + key.substr(1) + " is " + value.dump() + ", the replay has no such entry";
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::string> first_difference(const fs::path& recorded, const fs::path& replayed, const DayClock& clock) {
  if (auto found = compare_days(recorded / "run.sqlite", replayed / "run.sqlite")) {
    return found;
  }
  for (const char* name : {"steps.csv", "regions.csv"}) {
    if (auto found = compare_csv(recorded / name, replayed / name, clock)) {
      return found;
    }
  }
  return compare_summaries(recorded / "summary.json", replayed / "summary.json");
}

bool scenario_is_original(const fs::path& folder) {
  const nlohmann::json summary = nlohmann::json::parse(text_of_file(folder / "summary.json"), nullptr, false);
  return summary.is_object() && summary.contains("scenario_digest") &&
         summary["scenario_digest"] == text_digest(text_of_file(folder / "scenario.resolved.yaml"));
}

}  // namespace evbal
