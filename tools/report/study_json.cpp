#include "tools/report/study_json.hpp"

#include "tools/report/json_numbers.hpp"

#include <nlohmann/json.hpp>

namespace evbal {
namespace {

nlohmann::ordered_json panel_json(const FrontPanel& panel) {
  nlohmann::ordered_json json = {{"title", panel.title}, {"note", panel.note}, {"bound", points_json(panel.bound)}};
  json["lines"] = nlohmann::ordered_json::array();
  for (const FrontLine& line : panel.lines) {
    json["lines"].push_back({{"name", line.name},
                             {"points", points_json(line.points)},
                             {"hull", points_json(line.hull)},
                             {"km", line.km ? interval_json(*line.km) : nlohmann::ordered_json()},
                             {"lost", line.lost ? interval_json(*line.lost) : nlohmann::ordered_json()}});
  }
  return json;
}

nlohmann::ordered_json group_json(const FigureGroup& group) {
  nlohmann::ordered_json json = {{"title", group.title}, {"rows", nlohmann::ordered_json::array()}};
  for (const FigureRow& row : group.rows) {
    json["rows"].push_back({{"name", row.name},
                            {"difference", row.difference ? interval_json(*row.difference) : nlohmann::ordered_json()},
                            {"days", row.days},
                            {"p_holm", row.p_holm ? rounded_json(*row.p_holm) : nlohmann::ordered_json()},
                            {"paper", row.paper ? rounded_json(*row.paper) : nlohmann::ordered_json()}});
  }
  return json;
}

nlohmann::ordered_json slope_json(const SlopePanel& panel) {
  nlohmann::ordered_json json = {{"title", panel.title}, {"days", nlohmann::ordered_json::array()}};
  for (const ComparedDay& day : panel.days) {
    json["days"].push_back(
        {{"day", day.day}, {"value", rounded_json(day.value)}, {"reference", rounded_json(day.reference)}});
  }
  return json;
}

nlohmann::ordered_json bars_json(const BarGroup& group) {
  nlohmann::ordered_json json = {{"title", group.title}, {"bars", nlohmann::ordered_json::array()}};
  for (const Bar& bar : group.bars) {
    json["bars"].push_back({{"name", bar.name}, {"value", interval_json(bar.value)}});
  }
  return json;
}

template <class Parts, class MakeJson>
nlohmann::ordered_json list_json(const Parts& parts, const MakeJson& json_of) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const auto& part : parts) {
    list.push_back(json_of(part));
  }
  return list;
}

}  // namespace

nlohmann::ordered_json figures_json(const std::vector<StudyFigure>& figures) {
  return list_json(figures, [](const StudyFigure& figure) {
    return nlohmann::ordered_json{{"kind", kind_name(figure.kind)},
                                  {"name", figure.name},
                                  {"title", figure.title},
                                  {"caption", figure.caption},
                                  {"from", figure.from},
                                  {"to", figure.to},
                                  {"fronts", list_json(figure.fronts, panel_json)},
                                  {"groups", list_json(figure.groups, group_json)},
                                  {"slopes", list_json(figure.slopes, slope_json)},
                                  {"bars", list_json(figure.bars, bars_json)},
                                  {"shares", figure.shares}};
  });
}

}  // namespace evbal
