#include "agents/world/pack_text.hpp"

#include "agents/world/pack_table.hpp"
#include "common/error.hpp"

#include <fstream>

namespace evbal {

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      out += '\\';
    }
    out += c == '\n' ? ' ' : c;
  }
  return out + "\"";
}

std::string position(LatLon point) {
  return "[" + decimal(point.lon) + ", " + decimal(point.lat) + "]";
}

std::string stations_yaml(const std::vector<Station>& stations, const std::vector<Region>& regions) {
  std::string out = std::string("stations:") + (stations.empty() ? " []" : "") + "\n";
  for (const auto& station : stations) {
    out += "  - {name: " + quoted(station.name) + ", region: " + quoted(regions[station.region].name) +
           ", points: " + std::to_string(station.points) + ", lat: " + decimal(station.place.lat) +
           ", lon: " + decimal(station.place.lon) + "}\n";
  }
  return out;
}

void write_text(const std::filesystem::path& file, const std::string& text) {
  std::ofstream out(file, std::ios::binary);
  out << text;
  out.close();
  if (!out) {
    throw run_failed(file.string() + ": cannot be written");
  }
}

}  // namespace evbal
