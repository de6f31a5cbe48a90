#include "experiments/scenario/bus_security.hpp"

namespace evbal {

std::optional<BusSecurity> read_security(const YamlValue& value) {
  if (!value.is_map()) {
    return value.one_of({"off", "on"}) == 0 ? std::nullopt : std::optional(BusSecurity{});
  }
  YamlMap map(value);
  const YamlValue ca = map.require("ca");
  map.finish();
  return BusSecurity{.ca = std::filesystem::absolute(ca.file()).parent_path() / ca.text()};
}

void write_security(YamlWriter& yaml, const BusSecurity& security) {
  if (security.ca.empty()) {
    yaml.word("on");
  } else {
    yaml.begin_map(YamlWriter::Layout::one_line).key("ca").text(security.ca.string()).end_map();
  }
}

}  // namespace evbal
