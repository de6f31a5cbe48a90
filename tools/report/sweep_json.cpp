#include "tools/report/sweep_json.hpp"

#include "tools/report/json_numbers.hpp"
#include "tools/report/study_json.hpp"

#include <nlohmann/json.hpp>

namespace evbal {
namespace {

using Json = nlohmann::ordered_json;

Json point_json(const SweptPoint& point) {
  Json json = {{"scenario", point.first.scenario}, {"faults", point.first.faults},
               {"variant", point.first.variant},   {"controller", point.first.controller},
               {"settings", point.first.settings}, {"pairs", point.pairs}};
  for (const auto& [metric, mean] : point.means) {
    json["means"][metric] = rounded_json(mean);
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

/// Day by day.
Json days_json(const std::vector<ComparedDay>& compared) {
  Json days = Json::array();
  for (const auto& [day, value, reference] : compared) {
    days.push_back({{"day", day}, {"value", rounded_json(value)}, {"reference", rounded_json(reference)}});
  }
  return days;
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
          {"from", rounded_json(row.from)},
          {"to", rounded_json(row.to)},
          {"covered", rounded_json(row.covered)},
          {"value", rounded_json(row.value)},
          {"reference", rounded_json(row.reference)},
          {"of_totals", totals ? rounded_json(*totals) : Json()},
          {"relative", row.relative},
          {"difference", interval_json(row.difference)},
          {"p_holm", p_holm ? rounded_json(*p_holm) : Json()}};
}

Json answer_json(const Answer& answer) {
  Json json = {{"metric", answer.question.metric}, {"reference", answer.question.reference}};
  json["at"] = answer.question.at ? Json(*answer.question.at) : Json(nullptr);
  json["refused"] = answer.refused;
  json["rows"] = Json::array();
  for (std::size_t i = 0; i < answer.rows.size(); ++i) {
    const Compared& row = answer.rows[i];
    json["rows"].push_back(row_json(row, answer.p_holm[i]));
    if (row.whole && answer.question.metric == "lost") {
      json["rows"].back()["by_day"] = days_json(row.by_day);
    }
  }
  return json;
}

Json page_json(const SweptAnswers& page) {
  return {{"verdict", page.text.verdict},
          {"decided_after", page.text.decided_after},
          {"reading", page.text.reading},
          {"tables", page.text.tables},
          {"figures", figures_json(page.figures)}};
}

}  // namespace

Json sweep_json(const SweepContent& sweep) {
  Json json = {{"folder", sweep.folder},    {"command", sweep.origin.command},
               {"file", sweep.origin.file}, {"text", sweep.origin.text},
               {"days", sweep.days},        {"page", page_json(sweep.page)},
               {"points", Json::array()},   {"answers", Json::array()},
               {"bounds", Json::array()}};
  for (const auto& point : sweep.points) {
    json["points"].push_back(point_json(point));
  }
  for (const auto& answer : sweep.answers) {
    json["answers"].push_back(answer_json(answer));
  }
  for (const SweptBound& bound : sweep.bounds) {
    json["bounds"].push_back(
        {{"scenario", bound.scenario}, {"faults", bound.faults}, {"corners", points_json(bound.corners)}});
  }
  return json;
}

}  // namespace evbal
