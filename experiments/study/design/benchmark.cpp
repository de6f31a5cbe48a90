#include "experiments/study/design/benchmark.hpp"

#include "common/digest.hpp"
#include "common/files.hpp"
#include "common/yaml_writer.hpp"
#include "experiments/study/design/study_file.hpp"

#include <algorithm>

namespace evbal {
namespace {

namespace fs = std::filesystem;

/// The settings of a map, lists as they are.
std::vector<Setting> read_plain_settings(const std::optional<YamlValue>& value) {
  std::vector<Setting> settings;
  if (value) {
    YamlMap map(*value);
    for (const auto& path : map.keys()) {
      settings.push_back({path, map.require(path)});
      refuse_path(settings.back().value, path);
    }
  }
  return settings;
}

BenchmarkPart read_part(const std::string& name, const YamlValue& value) {
  YamlMap map(value);
  const YamlValue scenario = map.require("scenario");
  BenchmarkPart part{.name = name,
                     .scenario = fs::absolute(fs::path(scenario.file()).parent_path() / scenario.text()),
                     .days = map.require("days"),
                     .seeds = map.require("seeds"),
                     .faults = map.require("faults"),
                     .reference = map.require("reference"),
                     .training = map.require("training")};
  if (const auto bound = map.find("bound")) {
    part.bound = read_bound_wish(*bound);
  }
  map.finish();
  return part;
}

void write_settings(YamlWriter& yaml, const std::vector<Setting>& settings) {
  yaml.begin_map();
  for (const auto& setting : settings) {
    yaml.key(setting.path).value(setting.value);
  }
  yaml.end_map();
}

/// A file's beginning: what its days start from.
void write_days(YamlWriter& yaml, const BenchmarkPart& part, const YamlValue& days, const YamlValue& seeds,
                const YamlValue& faults) {
  yaml.key("schema").number(1).key("scenario").text(part.scenario.string());
  yaml.key("days").value(days).key("seeds").value(seeds).key("faults").value(faults);
}

}  // namespace

Benchmark read_benchmark(const fs::path& file) {
  YamlMap map(YamlValue::load(file));
  map.require("schema").integer(1, 1);
  Benchmark benchmark{.name = plain_name(map.require("name")),
                      .digest = file_digest(file),
                      .objective = map.require("objective"),
                      .candidates = map.require("candidates").integer(2, 1000),
                      .parts = {},
                      .entries = {}};
  YamlMap parts(map.require("parts"));
  for (const auto& name : parts.keys()) {
    benchmark.parts.push_back(read_part(name, parts.require(name)));
    benchmark.digest = text_digest(benchmark.digest + file_digest(benchmark.parts.back().scenario));
  }
  YamlMap entries(map.require("entries"));
  for (const auto& controller : entries.keys()) {
    benchmark.entries.emplace(controller, read_entry_settings(entries.require(controller)));
  }
  map.finish();
  if (benchmark.parts.empty()) {
    throw map.value().error("a benchmark needs a part at least");
  }
  return benchmark;
}

EntrySettings read_entry_settings(const YamlValue& value) {
  YamlMap map(value);
  EntrySettings entry{.settings = read_plain_settings(map.find("settings")),
                      .search = map.find("search"),
                      .factors = read_plain_settings(map.find("factors"))};
  map.finish();
  return entry;
}

std::string tuning_yaml(const Benchmark& benchmark, const BenchmarkPart& part, const Entry& entry) {
  YamlMap training(part.training);
  YamlWriter yaml;
  write_days(yaml, part, training.require("days"), training.require("seeds"), training.require("faults"));
  training.finish();
  yaml.key("objective").value(benchmark.objective).key("candidates").number(benchmark.candidates);
  yaml.key("variants").begin_list().begin_map();
  yaml.key("name").word(entry_variant).key("controller").text(entry.controller);
  write_coordinator(yaml, entry.coordinator);
  yaml.key("settings");
  write_settings(yaml, entry.settings.settings);
  yaml.key("search").value(*entry.settings.search);
  yaml.end_map().end_list();
  return yaml.finish();
}

std::string examined_settings(const EntrySettings& entry, const std::vector<Setting>& tuned) {
  std::vector<Setting> settings = entry.settings;
  for (const auto& setting : tuned) {
    put(settings, setting);
  }
  const std::vector<Setting> base = settings;
  for (const auto& [path, factors] : entry.factors) {
    const auto one = std::find_if(base.begin(), base.end(), [&p = path](const auto& s) { return s.path == p; });
    if (one == base.end()) {
      throw factors.error("`" + path + "` is neither set nor searched, so it has no factors");
    }
    std::string values;
    for (const auto& factor : distinct_items(factors)) {
      values +=
          (values.empty() ? "" : ", ") + rounded_setting(one->value.number() * factor.number(), factor.file()).text();
    }
    put(settings, {path, YamlValue::parse("[" + values + "]", factors.file())});
  }
  YamlWriter yaml;
  yaml.key("settings");
  write_settings(yaml, settings);
  return yaml.finish();
}

std::string sweep_yaml(const BenchmarkPart& part, const Entry& entry, const std::string& settings) {
  YamlMap reference(part.reference);
  YamlMap examined(YamlValue::parse(settings, "settings of the entry"));
  YamlWriter yaml;
  write_days(yaml, part, part.days, part.seeds, part.faults);
  yaml.key("variants").begin_list().begin_map().key("name").word(reference_variant);
  yaml.key("controller").value(reference.require("controller")).key("settings").value(reference.require("settings"));
  yaml.end_map().begin_map().key("name").word(entry_variant).key("controller").text(entry.controller);
  write_coordinator(yaml, entry.coordinator);
  yaml.key("settings").value(examined.require("settings"));
  yaml.end_map().end_list();
  reference.finish();
  examined.finish();
  return yaml.finish();
}

}  // namespace evbal
