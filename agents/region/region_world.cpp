#include "agents/region/region_world.hpp"

#include "agents/protocol/bytes.hpp"
#include "common/error.hpp"
#include "common/files.hpp"

#include <string>
#include <utility>

namespace evbal {
namespace {

std::vector<double> row(const Eigen::MatrixXd& matrix, int region) {
  const Eigen::VectorXd values = matrix.row(region);
  return {values.begin(), values.end()};
}

}  // namespace

std::vector<RegionWorld> region_worlds(const World& world) {
  const City& city = world.city;
  const std::vector<int> stations = city.nearest_station();
  const Eigen::VectorXi points = city.points();
  std::vector<double> km_to_station;
  for (int from = 0; from < city.size(); ++from) {
    const int to = stations[from];
    km_to_station.push_back(to < 0 || to == from ? 0.0 : city.km(from, to));
  }
  std::vector<std::vector<Vehicle>> fleet = draw_fleet(world);
  std::vector<RegionWorld> regions;
  for (int region = 0; region < city.size(); ++region) {
    regions.push_back({.region = region,
                       .points = points[region],
                       .station = stations[region],
                       .seed = world.seed,
                       .clock = world.clock,
                       .fleet = city.fleet,
                       .charging = city.charging,
                       .patience = city.passengers,
                       .km = row(city.km, region),
                       .km_to_station = km_to_station,
                       .minutes = row(city.minutes, region),
                       .passengers = draw_passengers(world, region),
                       .vehicles = std::move(fleet[region])});
  }
  return regions;
}

void write_agent_world(const std::filesystem::path& file, const World& world, const std::vector<RegionWorld>& regions,
                       int first, int last) {
  write_file(file, to_bytes(AgentWorld{bounds_of(world), {regions.begin() + first, regions.begin() + last + 1}}));
}

AgentWorld read_agent_world(const std::filesystem::path& file) {
  const std::string bytes = text_of_file(file);
  if (bytes.empty()) {
    throw run_failed(file.string() + ": cannot be read");
  }
  try {
    return from_bytes<AgentWorld>(bytes);
  } catch (const Error& error) {
    throw run_failed(file.string() + ": " + error.what());
  }
}

}  // namespace evbal
