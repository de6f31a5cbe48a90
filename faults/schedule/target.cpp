#include "faults/schedule/target.hpp"

#include "agents/protocol/words.hpp"
#include "faults/schedule/entry.hpp"

namespace evbal {
namespace {

bool names_agents(const FaultType& type) {
  return type.target == TargetKind::processes;
}

const char* list_key(const FaultType& type) {
  return names_agents(type) ? "agents" : "regions";
}

bool needs_points(const FaultType& type) {
  return type.target == TargetKind::stations;
}

std::vector<int> read_candidates(const std::optional<YamlValue>& of, const FaultType& type,
                                 const FaultContext& context) {
  if (!of) {
    return regions_with(context, needs_points(type) ? 1 : 0);
  }
  YamlMap map(*of);
  const auto list = map.find(list_key(type));
  const auto min_points = map.find("min_points");
  map.finish();
  if (list.has_value() == min_points.has_value()) {
    throw of->error(std::string("expected either `") + list_key(type) + ": [..]` or `min_points: k`");
  }
  return list ? read_regions(*list, context, needs_points(type))
              : regions_with(context, min_points->integer(1, 1'000'000));
}

void refuse_nobody(const YamlValue& value, const std::vector<int>& candidates) {
  if (candidates.empty()) {
    throw value.error("no region fits; ask for fewer points");
  }
}

Quantity read_pick(const YamlValue& value, const std::vector<int>& candidates) {
  refuse_nobody(value, candidates);
  const int most = static_cast<int>(candidates.size());
  if (value.is_scalar()) {
    value.integer(1, most);
  }
  return read_quantity(value, Unit::number, {1.0, static_cast<double>(most)});
}

/// The regions of a target: a list, or so many of some.
void read_where(YamlMap& map, const FaultType& type, const FaultContext& context, Target& target) {
  const auto list = map.find(list_key(type));
  const auto one = names_agents(type) ? map.find("agent") : std::nullopt;
  const auto pick = map.find("pick");
  const auto of = map.find("of");
  const auto fraction = map.find("fraction");
  map.finish();
  const int given = int{list.has_value()} + int{one.has_value()} + int{pick.has_value()} + int{fraction.has_value()};
  const bool may_be_all = type.target == TargetKind::topics;
  if (given > 1 || (given == 0 && !may_be_all) || (of && !pick && !fraction)) {
    throw map.value().error(std::string("expected either `") + list_key(type) + ": [..]`" +
                            (names_agents(type) ? ", `agent: k`, `coordinator: true`, `injector: true`" : "") +
                            ", or `pick: n` or `fraction: f`, with or without `of: {min_points: k}`");
  }
  if (one) {
    target.candidates = {one->integer(0, static_cast<int>(context.points_per_region.size()) - 1)};
    return;
  }
  if (list) {
    target.candidates = read_regions(*list, context, needs_points(type));
    return;
  }
  target.candidates = read_candidates(of, type, context);
  if (pick) {
    target.pick = read_pick(*pick, target.candidates);
  } else if (fraction) {
    refuse_nobody(*fraction, target.candidates);
    target.pick = read_quantity(*fraction, Unit::number, {0.0, 1.0});
    target.share = true;
  }
}

/// The regions of a host by its position, or of one that was resolved before.
std::vector<int> read_host(YamlMap& map, const FaultContext& context) {
  const auto regions = map.find("regions");
  const auto host = map.find("host");
  map.finish();
  if (regions.has_value() == host.has_value()) {
    throw map.value().error("expected `host: k`, the k-th of the scenario's `hosts`, from 0");
  }
  if (regions) {
    return read_regions(*regions, context, false);
  }
  const int hosts = static_cast<int>(context.regions_per_host.size());
  if (hosts == 0) {
    throw host->error("the scenario names no hosts; add the key `hosts`, or kill single agents by process.kill");
  }
  const std::vector<int>& held = context.regions_per_host[host->integer(0, hosts - 1)];
  if (held.empty()) {
    throw host->error("host " + host->text() + " holds no region; give it more weight or choose another one");
  }
  return held;
}

/// Reads a process that is no agent, if the map names one.
bool read_single_process(YamlMap& map, Target& target) {
  for (const auto& [key, role] :
       {std::pair{"coordinator", ProcessRole::coordinator}, std::pair{"injector", ProcessRole::injector}}) {
    const auto given = map.find(key);
    if (given && !given->boolean()) {
      throw given->error(std::string("expected `") + key + ": true`");
    }
    if (given) {
      target.process = role;
      target.candidates = {no_region};
      return true;
    }
  }
  return false;
}

}  // namespace

Target read_target(YamlMap& entry, const FaultType& type, const FaultContext& context) {
  Target target;
  if (type.target == TargetKind::engine) {
    target.candidates = {no_region};
    return target;
  }
  YamlMap map(entry.require("target"));
  if (type.target == TargetKind::hosts) {
    target.candidates = read_host(map, context);
    return target;
  }
  if (type.target == TargetKind::sensors) {
    const auto field = map.require("field");
    target.field = static_cast<ReportField>(field.one_of(report_field_words()) + 1);
  }
  if (type.target == TargetKind::topics) {
    target.topic = static_cast<NetworkTopic>(map.require("topic").one_of(words<NetworkTopic>()));
  }
  if (names_agents(type) && read_single_process(map, target)) {
    map.finish();
  } else {
    read_where(map, type, context, target);
  }
  return target;
}

void write_target(YamlWriter& yaml, const Fault& fault) {
  const FaultType& type = fault_type(fault.type);
  yaml.begin_map(YamlWriter::Layout::one_line);
  if (fault.process != ProcessRole::agent) {
    yaml.key(fault.process == ProcessRole::coordinator ? "coordinator" : "injector").boolean(true).end_map();
    return;
  }
  if (type.target == TargetKind::topics) {
    yaml.key("topic").word(std::string(word(fault.topic)));
  }
  yaml.key(list_key(type)).begin_list();
  for (const int region : fault.regions) {
    yaml.number(region);
  }
  yaml.end_list();
  if (type.target == TargetKind::sensors) {
    yaml.key("field").word(std::string(word(fault.field)));
  }
  yaml.end_map();
}

std::string place_name(const Fault& fault, int region) {
  switch (fault_type(fault.type).target) {
    case TargetKind::engine:
      return "the coordinator";
    case TargetKind::hosts:
      return "agent " + std::to_string(region);
    case TargetKind::processes:
      return fault.process == ProcessRole::agent         ? "agent " + std::to_string(region)
             : fault.process == ProcessRole::coordinator ? "the coordinator"
                                                         : "the injector";
    default:
      return "region " + std::to_string(region);
  }
}

}  // namespace evbal
