#include "tools/report/sweep_json.hpp"

#include <nlohmann/json.hpp>

#include <cmath>

namespace evbal {
namespace {

using Json = nlohmann::ordered_json;

/// To six digits, which is more than a page shows; nothing for what is not finite.
Json rounded(double value) {
  if (value == 0.0 || !std::isfinite(value)) {
    return value == 0.0 ? Json(0) : Json(nullptr);
  }
  const double scale = std::pow(10.0, 5.0 - std::floor(std::log10(std::abs(value))));
  return std::round(value * scale) / scale;
}

Json interval_json(const Interval& interval) {
  return {rounded(interval.mean), rounded(interval.low), rounded(interval.high)};
}

Json point_json(const SweptPoint& point) {
  Json json = {{"scenario", point.first.scenario}, {"faults", point.first.faults},
               {"variant", point.first.variant},   {"controller", point.first.controller},
               {"settings", point.first.settings}, {"pairs", point.pairs}};
  for (const auto& [metric, mean] : point.means) {
    json["means"][metric] = rounded(mean);
  }
  for (const auto& [column, hours] : point.hours) {
    for (const auto& [hour, interval] : hours) {
      Json numbers = interval_json(interval);
      numbers.insert(numbers.begin(), hour);
      json["hours"][column].push_back(numbers);
    }
  }
  return json;
}

Json row_json(const Compared& row, const std::optional<double>& p_holm) {
  const auto totals = of_totals(row);
  return {{"scenario", row.scenario},
          {"faults", row.faults},
          {"variant", row.variant},
          {"settings", row.settings},
          {"whole", row.whole},
          {"days", row.days},
          {"apart", row.apart},
          {"points", row.points},
          {"inside", row.inside},
          {"from", rounded(row.from)},
          {"to", rounded(row.to)},
          {"covered", rounded(row.covered)},
          {"value", rounded(row.value)},
          {"reference", rounded(row.reference)},
          {"of_totals", totals ? rounded(*totals) : Json()},
          {"relative", row.relative},
          {"difference", interval_json(row.difference)},
          {"p_holm", p_holm ? rounded(*p_holm) : Json()}};
}

Json answer_json(const Answer& answer) {
  Json json = {{"metric", answer.question.metric}, {"reference", answer.question.reference}};
  json["at"] = answer.question.at ? Json(*answer.question.at) : Json(nullptr);
  json["refused"] = answer.refused;
  json["rows"] = Json::array();
  for (std::size_t i = 0; i < answer.rows.size(); ++i) {
    json["rows"].push_back(row_json(answer.rows[i], answer.p_holm[i]));
  }
  return json;
}

}  // namespace

Json sweep_json(const SweepContent& sweep) {
  Json json = {{"folder", sweep.folder},    {"command", sweep.origin.command},
               {"file", sweep.origin.file}, {"text", sweep.origin.text},
               {"page", sweep.page},        {"days", sweep.days},
               {"points", Json::array()},   {"answers", Json::array()}};
  for (const auto& point : sweep.points) {
    json["points"].push_back(point_json(point));
  }
  for (const auto& answer : sweep.answers) {
    json["answers"].push_back(answer_json(answer));
  }
  if (sweep.bound) {
    json["bound"] = {{"scenario", sweep.bound->scenario}, {"faults", sweep.bound->faults}, {"corners", Json::array()}};
    for (const FrontPoint& corner : sweep.bound->corners) {
      json["bound"]["corners"].push_back({rounded(corner.cost), rounded(corner.value)});
    }
  }
  return json;
}

}  // namespace evbal
