#include "coordinator/bridge/json_lines.hpp"

#include "agents/protocol/reflection.hpp"
#include "agents/protocol/words.hpp"
#include "coordinator/planning/json_reader.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>
#include <tuple>
#include <type_traits>
#include <utility>

namespace evbal {
namespace {

using nlohmann::json;

/// A message's fields as a JSON object.
class FieldWriter {
 public:
  explicit FieldWriter(json& out) : out_(out) {}

  void operator()(std::string_view /*name*/, const Origin& /*differs between runs*/) {}

  template <class Field>
  void operator()(std::string_view name, const Field& field) {
    out_[name] = value(field);
  }

 private:
  template <class Field>
  static json value(const Field& field) {
    if constexpr (std::is_enum_v<Field>) {
      return word(field);
    } else if constexpr (std::is_arithmetic_v<Field>) {
      return field;
    } else {
      json out = json::object();
      for_each_field(field, FieldWriter(out));
      return out;
    }
  }

  template <class Item>
  static json value(const std::vector<Item>& items) {
    json out = json::array();
    for (const auto& item : items) {
      out.push_back(value(item));
    }
    return out;
  }

  json& out_;
};

/// A move's fields from a JSON object, each within its type.
class MoveReader {
 public:
  explicit MoveReader(JsonObject& in) : in_(in) {}

  void operator()(std::string_view name, std::int32_t& number) { number = in_.integer(std::string(name), 0, most); }

  void operator()(std::string_view name, Errand& errand) {
    const std::string text = in_.text(std::string(name));
    const auto* const found = std::ranges::find(enumerator_names<Errand>, text);
    if (found == enumerator_names<Errand>.end() || text == word(Errand::passenger)) {
      throw in_.error(std::string(name), "`rebalance` or `charge` is expected, not `" + text + "`");
    }
    errand = static_cast<Errand>(found - enumerator_names<Errand>.begin());
  }

 private:
  static constexpr int most = 1'000'000;
  JsonObject& in_;
};

/// Checks moves against the reports, one after another.
class MoveCheck {
 public:
  MoveCheck(const std::vector<Report>& reports, const City& city) : city_(city) {
    for (const auto& report : reports) {
      left_[report.region] = {report.vacant, report.low_battery, city.charging.top_up ? report.chargeable : 0};
    }
  }

  void take(const Move& move, const JsonObject& in) {
    for (const auto& [key, region] : {std::pair("from", move.from), std::pair("to", move.to)}) {
      if (region >= city_.size()) {
        throw in.error(key, "a region from 0 to " + std::to_string(city_.size() - 1) + " is expected, not " +
                                std::to_string(region));
      }
    }
    if (move.from == move.to && (move.errand == Errand::rebalance || !city_.charging.top_up)) {
      throw in.error("to", "another region than `from` is expected");
    }
    Left& left = left_[move.from];
    if (move.errand == Errand::rebalance) {
      take(move, left.vacant, "vacant", in);
    } else if (move.from != move.to) {
      take(move, left.low_battery, "low-battery", in);
    } else {
      take(move, left.vacant, "vacant", in);
      take(move, left.chargeable, "chargeable", in);
    }
  }

 private:
  struct Left {
    int vacant = 0;
    int low_battery = 0;
    int chargeable = 0;
  };

  static void take(const Move& move, int& left, const char* which, const JsonObject& in) {
    if (move.count < 1 || move.count > left) {
      throw in.error("count", "region " + std::to_string(move.from) + " has " + std::to_string(left) + " " + which +
                                  " vehicles left to send; give 1 at least and no more, not " +
                                  std::to_string(move.count));
    }
    left -= move.count;
  }

  const City& city_;
  std::map<int, Left> left_;  // none where no report came
};

json rows_of(const Eigen::MatrixXd& matrix) {
  json rows = json::array();
  for (const auto& row : matrix.rowwise()) {
    rows.push_back(std::vector<double>(row.begin(), row.end()));
  }
  return rows;
}

}  // namespace

std::string opening_line(const World& world, const std::string& controller) {
  const Eigen::VectorXi points = world.city.points();
  json regions = json::array();
  for (int i = 0; i < world.city.size(); ++i) {
    regions.push_back({{"name", world.city.regions[static_cast<std::size_t>(i)].name}, {"points", points(i)}});
  }
  const DayClock& clock = world.clock;
  const json line = {{"controller", controller},
                     {"city",
                      {{"name", world.city.name},
                       {"regions", regions},
                       {"km", rows_of(world.city.km)},
                       {"minutes", rows_of(world.city.minutes)}}},
                     {"top_up", world.city.charging.top_up},
                     {"clock",
                      {{"date", world.day.date},
                       {"start", clock.start},
                       {"end", clock.end},
                       {"tick", clock.tick},
                       {"step", clock.step},
                       {"plan_every", clock.plan_every}}}};
  return line.dump();
}

std::string question_line(int tick, const std::vector<Report>& reports) {
  json said = json::array();
  for (const auto& report : reports) {
    for_each_field(report, FieldWriter(said.emplace_back(json::object())));
  }
  return json{{"tick", tick}, {"reports", said}}.dump();
}

std::vector<Move> read_answer(const std::string& line, const std::string& place, const std::vector<Report>& reports,
                              const City& city) {
  const json parsed = parse_json(line, place);
  JsonObject answer(parsed, place, "");
  MoveCheck check(reports, city);
  std::vector<Move> moves;
  for (JsonObject& object : answer.objects("moves")) {
    Move& move = moves.emplace_back();
    for_each_field(move, MoveReader(object));
    object.finish();
    check.take(move, object);
  }
  answer.finish();
  const auto key = [](const Move& move) { return std::tuple(move.errand, move.from, move.to); };
  std::ranges::sort(moves, {}, key);
  if (const auto twice = std::ranges::adjacent_find(moves, {}, key); twice != moves.end()) {
    throw answer.error("moves", std::string(word(twice->errand)) + " from " + std::to_string(twice->from) + " to " +
                                    std::to_string(twice->to) + " is given twice; give it once with the sum");
  }
  return moves;
}

}  // namespace evbal
