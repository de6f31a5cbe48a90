#include "tools/console/day_json.hpp"

#include "agents/protocol/words.hpp"
#include "experiments/record/row.hpp"
#include "faults/schedule/fault_types.hpp"
#include "tools/report/city_map.hpp"

#include <nlohmann/json.hpp>
#include <unistd.h>

#include <array>
#include <initializer_list>
#include <map>
#include <set>
#include <utility>

namespace evbal {
namespace {

using Json = nlohmann::ordered_json;

/// The keys by which the page asks for a fault of a type.
Json type_json(const FaultType& type) {
  static const std::map<TargetKind, const char*> targets = {
      {TargetKind::regions, "regions"},     {TargetKind::stations, "regions"}, {TargetKind::sensors, "sensors"},
      {TargetKind::processes, "processes"}, {TargetKind::links, "regions"},    {TargetKind::topics, "topics"},
      {TargetKind::hosts, "regions"},       {TargetKind::engine, "engine"}};
  static const std::map<MagnitudeUnit, const char*> units = {{MagnitudeUnit::none, "none"},
                                                             {MagnitudeUnit::number, "number"},
                                                             {MagnitudeUnit::minutes, "minutes"},
                                                             {MagnitudeUnit::count, "count"}};
  return {{"name", type.name},
          {"target", targets.at(type.target)},
          {"unit", units.at(type.unit)},
          {"counted", type.counted},
          {"low", type.range.low},
          {"high", type.range.high},
          {"to", type.to},
          {"on_start", type.on_start},
          {"magnitude", type.magnitude},
          {"duration", type.duration},
          {"invisible", type.may_be_invisible()}};
}

Json fault_of(int position, const Fault& fault) {
  return {{"fault", position},        {"name", fault.name},   {"type", word(fault.type)},
          {"regions", fault.regions}, {"start", fault.start}, {"end", fault.start + fault.duration}};
}

Json tally_of(const DayTally& tally) {
  return {{"tick", tally.tick},     {"served", tally.served}, {"lost", tally.lost},        {"waiting", tally.waiting},
          {"vacant", tally.vacant}, {"queue", tally.queue},   {"empty_km", tally.empty_km}};
}

Json plan_json(const Plan& plan) {
  const Provenance& made = plan.provenance;
  Json json = {{"controller", made.controller}, {"engine", made.engine},
               {"iterations", made.iterations}, {"gap", made.gap},
               {"objective", made.objective},   {"fallback", word(made.fallback)},
               {"reason", made.reason},         {"rejected", made.rejected.size()},
               {"flags", made.flags.size()},    {"costs", Json::array()},
               {"moves", Json::array()}};
  for (const auto& [term, cost] : made.costs) {
    json["costs"].push_back({term, cost});
  }
  for (const Move& move : plan.moves) {
    json["moves"].push_back({move.from, move.to, move.count, static_cast<int>(move.errand)});
  }
  return json;
}

/// By region, as the departures say, which are ascending.
Json regions_json(const TickRecord& record) {
  Json columns;
  for (const Departures& said : record.exchange.departures) {
    long lost = 0;
    for (const Fate& fate : said.fates) {
      lost += fate.served ? 0 : 1;
    }
    const std::initializer_list<std::pair<const char*, long>> numbers = {
        {"demand", said.demand}, {"vacant", said.vacant}, {"queue", said.low_battery}, {"waiting", said.waiting},
        {"lost", lost},          {"points", said.points}, {"broken", said.broken}};
    for (const auto& [name, number] : numbers) {
      columns[name].push_back(number);
    }
  }
  return columns;
}

/// By fault the regions on which it acts and what it was seen to do.
Json acting_json(const TickRecord& record) {
  std::map<int, std::set<int>> regions;
  std::map<int, double> amount;
  for (const Effect& effect : record.tick.effects) {
    regions[effect.fault].insert(effect.region);
  }
  for (const Departures& said : record.exchange.departures) {
    for (const Observed& seen : said.observed) {
      amount[seen.fault] += seen.amount;
    }
  }
  for (const Seen& seen : record.seen) {
    amount[seen.observed.fault] += seen.observed.amount;
  }
  Json all = Json::array();
  for (const auto& [fault, where] : regions) {
    all.push_back({{"fault", fault}, {"regions", where}, {"amount", amount[fault]}});
  }
  return all;
}

/// Cars on the road by errand.
Json under_way_json(const Tick& tick) {
  std::array<int, 3> counts{};
  for (const UnderWay& cars : tick.under_way) {
    counts.at(static_cast<std::size_t>(cars.errand)) += cars.count;
  }
  return counts;
}

}  // namespace

std::string day_json(const Scenario& scenario, const std::filesystem::path& folder) {
  const World& world = scenario.world;
  const Eigen::VectorXi points = world.city.points();
  Json json = {{"title", scenario.name},
               {"controller", scenario.planning.controller},
               {"date", world.day.date},
               {"seed", std::to_string(world.seed)},
               {"transport", scenario.transport},
               {"folder", folder.string()},
               {"process", getpid()},
               {"fleet", world.city.fleet.vehicles},
               {"start", world.clock.start},
               {"tick_minutes", world.clock.tick},
               {"ticks", world.clock.ticks()},
               {"points", std::vector<int>(points.begin(), points.end())},
               {"map", map_json(city_map(world.city.regions))},
               {"fields", report_field_words()},
               {"types", Json::array()},
               {"faults", Json::array()}};
  for (const FaultType& type : fault_types()) {
    json["types"].push_back(type_json(type));
  }
  for (const Fault& fault : scenario.schedule.faults) {
    json["faults"].push_back(fault_of(static_cast<int>(json["faults"].size()), fault));
  }
  return json.dump();
}

std::string fault_json(int position, const Fault& fault) {
  return fault_of(position, fault).dump();
}

std::string tick_json(const TickRecord& record, const DayTally& so_far, const std::vector<Incident>& events) {
  Json json = tally_of(so_far);
  json["regions"] = regions_json(record);
  json["under_way"] = under_way_json(record.tick);
  json["acting"] = acting_json(record);
  if (record.exchange.plan) {
    json["plan"] = plan_json(*record.exchange.plan);
  }
  json["log"] = Json::array();
  for (const auto& [kind, what] : events) {
    json["log"].push_back(std::string(kind).append(": ").append(what));
  }
  return json.dump();
}

std::string pace_json(const DayPace& pace) {
  Json json = {
      {"tick", pace.tick}, {"paused", pace.paused}, {"speed", pace.speed.value_or(0.0)}, {"processes", Json::array()}};
  for (const auto& [name, id, there] : pace.processes) {
    json["processes"].push_back({{"name", name}, {"id", id}, {"there", there}});
  }
  return json.dump();
}

std::string tally_json(const DayTally& tally) {
  return tally_of(tally).dump();
}

}  // namespace evbal
