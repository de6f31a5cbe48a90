#include "experiments/scenario/network_conditions.hpp"

#include "common/decimal.hpp"

#include <cmath>

namespace evbal {

NetworkConditions read_network(const YamlValue& value) {
  constexpr double most_loss = 0.5;
  constexpr double longest_delay = 1000.0;
  constexpr double microseconds_a_minute = 60e6;
  YamlMap map(value);
  NetworkConditions network;
  if (const auto loss = map.find("loss")) {
    network.loss = loss->number(0.0, most_loss);
  }
  if (const auto delay = map.find("delay")) {
    network.delay_ms = std::round(delay->duration() * microseconds_a_minute) / 1000.0;
    if (network.delay_ms > longest_delay) {
      throw delay->error("`" + delay->text() + "` must be from 0ms to 1s");
    }
  }
  map.finish();
  return network;
}

void write_network(YamlWriter& yaml, const NetworkConditions& network) {
  yaml.begin_map(YamlWriter::Layout::one_line).key("loss").number(network.loss);
  yaml.key("delay").word(decimal(network.delay_ms) + "ms").end_map();
}

}  // namespace evbal
