#include "experiments/study/design/tuned.hpp"

#include "common/yaml_writer.hpp"
#include "experiments/study/design/study_file.hpp"

namespace evbal {

Tuned read_tuned(const std::filesystem::path& file) {
  Tuned tuned;
  YamlMap map(YamlValue::load(file));
  map.require("schema").integer(1, 1);
  YamlMap scenarios(map.require("tuned"));
  map.finish();
  for (const auto& scenario : scenarios.keys()) {
    YamlMap variants(scenarios.require(scenario));
    for (const auto& name : variants.keys()) {
      YamlMap variant(variants.require(name));
      TunedVariant& entry = tuned[{scenario, name}];
      entry.controller = read_chosen(variant);
      YamlMap settings(variant.require("settings"));
      variant.finish();
      for (const auto& path : settings.keys()) {
        entry.settings.push_back({path, settings.require(path)});
        refuse_path(entry.settings.back().value, path);
      }
    }
  }
  return tuned;
}

std::string tuned_yaml(const Tuned& tuned) {
  constexpr auto one_line = YamlWriter::Layout::one_line;
  YamlWriter yaml;
  yaml.key("schema").number(1).key("tuned").begin_map();
  for (auto variant = tuned.begin(); variant != tuned.end();) {
    const std::string& scenario = variant->first.first;
    yaml.key(scenario).begin_map();
    for (; variant != tuned.end() && variant->first.first == scenario; ++variant) {
      yaml.key(variant->first.second).begin_map(one_line).key("controller").word(variant->second.controller.name);
      write_coordinator(yaml, variant->second.controller.coordinator);
      yaml.key("settings").begin_map();
      for (const auto& [path, value] : variant->second.settings) {
        yaml.key(path).value(value);
      }
      yaml.end_map().end_map();
    }
    yaml.end_map();
  }
  return yaml.end_map().finish();
}

}  // namespace evbal
