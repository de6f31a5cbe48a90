#include "coordinator/bridge/json_lines.hpp"

#include "agents/protocol/reflection.hpp"
#include "agents/protocol/words.hpp"
#include "coordinator/bridge/move_check.hpp"
#include "coordinator/planning/json_reader.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <string_view>
#include <type_traits>
#include <variant>

namespace evbal {
namespace {

using nlohmann::json;

// Messages as JSON objects with their fields' names, enumerators by their names; without the origin, which differs
// between runs.

template <class Message>
json json_of(const Message& message);

/// The same of each of several.
template <class Message>
json json_of(const std::vector<Message>& messages) {
  json out = json::array();
  for (const auto& message : messages) {
    out.push_back(json_of(message));
  }
  return out;
}

/// A message, or a field of one.
template <class Message>
json json_of(const Message& message) {
  if constexpr (std::is_enum_v<Message>) {
    return enumerator_names<Message>.at(static_cast<std::size_t>(message));
  } else if constexpr (std::is_arithmetic_v<Message> || std::is_same_v<Message, std::string>) {
    return message;
  } else {
    json out = json::object();
    for_each_field(message, [&]<class Field>(std::string_view name, const Field& field) {
      if constexpr (!std::is_same_v<Field, Origin>) {
        out[name] = json_of(field);
      }
    });
    return out;
  }
}

/// Reads what json_of wrote, every field but the origin; refuses others.
template <class Message>
Message read_message(JsonObject& in);

/// One field of a message.
class FieldReader {
 public:
  explicit FieldReader(JsonObject& in) : in_(in) {}

  void operator()(std::string_view /*name*/, Origin& /*not written*/) {}

  template <class Field>
  void operator()(std::string_view name, Field& field) {
    const std::string key(name);
    if constexpr (std::is_same_v<Field, std::string>) {
      field = in_.text(key);
    } else if constexpr (std::is_same_v<Field, bool>) {
      field = in_.boolean(key);
    } else if constexpr (std::is_floating_point_v<Field>) {
      field = in_.number(key, std::numeric_limits<Field>::lowest(), std::numeric_limits<Field>::max());
    } else if constexpr (std::is_enum_v<Field>) {
      field = enumerator(key, in_.text(key), Field{});
    } else if constexpr (std::is_integral_v<Field>) {
      field = in_.integer(key, std::numeric_limits<Field>::min(), std::numeric_limits<Field>::max());
    } else {
      read_list(key, field);
    }
  }

 private:
  template <class Enum>
  Enum enumerator(const std::string& key, const std::string& text, Enum /*type*/) const {
    const auto& names = enumerator_names<Enum>;
    const auto found = std::find(names.begin(), names.end(), text);
    if (found == names.end()) {
      throw in_.error(key, "`" + text + "` is not known");
    }
    return static_cast<Enum>(found - names.begin());
  }

  void read_list(const std::string& key, std::vector<std::int32_t>& field) {
    constexpr auto any = std::numeric_limits<std::int32_t>();
    for (const double number : in_.numbers(key, any.min(), any.max())) {
      field.push_back(static_cast<std::int32_t>(number));
    }
  }

  template <class Item>
  void read_list(const std::string& key, std::vector<Item>& field) {
    for (JsonObject& object : in_.objects(key)) {
      field.push_back(read_message<Item>(object));
    }
  }

  JsonObject& in_;
};

template <class Message>
Message read_message(JsonObject& in) {
  Message message;
  for_each_field(message, FieldReader(in));
  in.finish();
  return message;
}

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

json rows_of(const Eigen::MatrixXd& matrix) {
  json rows = json::array();
  for (const auto& row : matrix.rowwise()) {
    rows.push_back(std::vector<double>(row.begin(), row.end()));
  }
  return rows;
}

json json_of_city(const City& city) {
  const Eigen::VectorXi points = city.points();
  json regions = json::array();
  for (int i = 0; i < city.size(); ++i) {
    regions.push_back({{"name", city.regions[static_cast<std::size_t>(i)].name}, {"points", points(i)}});
  }
  return {{"name", city.name}, {"regions", regions}, {"km", rows_of(city.km)}, {"minutes", rows_of(city.minutes)}};
}

json json_of_clock(const World& world) {
  const DayClock& clock = world.clock;
  return {{"date", world.day.date}, {"start", clock.start}, {"end", clock.end},
          {"tick", clock.tick},     {"step", clock.step},   {"plan_every", clock.plan_every}};
}

/// Whole numbers without a point, as most languages want them for counts.
json json_of_number(double number) {
  constexpr double exact = 1e15;
  if (number == std::floor(number) && std::abs(number) < exact) {
    return static_cast<std::int64_t>(number);
  }
  return number;
}

json json_of_parameters(const ControllerParameters& parameters) {
  json out = json::object();
  for (const auto& [name, value] : parameters) {
    const auto* const number = std::get_if<double>(&value);
    out[name] =
        number != nullptr ? json_of_number(*number) : std::visit([](const auto& any) { return json(any); }, value);
  }
  return out;
}

bool is_told(const Effect& effect) {
  const bool demand = effect.type == EffectType::demand_scale || effect.type == EffectType::demand_add;
  return (effect.visible && demand) || family_of(effect.type) == FaultFamily::solver;
}

}  // namespace

std::string opening_line(const World& world, const PlanningSettings& settings, const std::string& scenario) {
  const json line = {{"controller", settings.controller},
                     {"city", json_of_city(world.city)},
                     {"clock", json_of_clock(world)},
                     {"top_up", world.city.charging.top_up},
                     {"parameters", json_of_parameters(settings.parameters)},
                     {"scenario", scenario}};
  return line.dump();
}

std::vector<Effect> told_effects(const Tick& tick) {
  std::vector<Effect> told;
  std::ranges::copy_if(tick.effects, std::back_inserter(told), is_told);
  return told;
}

std::string question_line(const Tick& tick, const std::vector<Report>& reports) {
  return json{{"tick", tick.tick}, {"reports", json_of(reports)}, {"effects", json_of(told_effects(tick))}}.dump();
}

Plan read_answer(const std::string& line, const std::string& place, const std::vector<Report>& reports,
                 const City& city) {
  const json parsed = parse_json(line, place);
  JsonObject answer(parsed, place, "");
  Plan plan;
  if (answer.has("provenance")) {
    JsonObject provenance = answer.object("provenance");
    plan.provenance = read_message<Provenance>(provenance);
  }
  MoveCheck check(reports, plan.provenance.rejected, city);
  for (JsonObject& object : answer.objects("moves")) {
    Move& move = plan.moves.emplace_back();
    for_each_field(move, MoveReader(object));
    object.finish();
    if (const auto wrong = check.take(move)) {
      throw object.error(wrong->field, wrong->words);
    }
  }
  answer.finish();
  if (const auto twice = sort_moves(plan.moves); !twice.empty()) {
    throw answer.error("moves", twice);
  }
  return plan;
}

std::string read_opening(const std::string& line) {
  const json parsed = parse_json(line, "the first line");
  return JsonObject(parsed, "the first line", "").text("scenario");
}

PlanRequest read_question(const std::string& line) {
  const json parsed = parse_json(line, "a question");
  JsonObject in(parsed, "a question", "");
  PlanRequest question;
  question.tick.tick = in.integer("tick", 0, std::numeric_limits<int>::max());
  for (JsonObject& report : in.objects("reports")) {
    question.reports.push_back(read_message<Report>(report));
  }
  for (JsonObject& effect : in.objects("effects")) {
    question.tick.effects.push_back(read_message<Effect>(effect));
  }
  in.finish();
  return question;
}

std::string answer_line(const Plan& plan) {
  return json{{"moves", json_of(plan.moves)}, {"provenance", json_of(plan.provenance)}}.dump();
}

}  // namespace evbal
