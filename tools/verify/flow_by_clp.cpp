#include "tools/verify/flow_by_clp.hpp"

#include "common/error.hpp"
#include "experiments/bound/normal_equations.hpp"

#include <ClpSimplex.hpp>

#include <array>

namespace evbal {

double flow_by_clp(const TimeNetwork& network, double price) {
  const int nodes = network.nodes();
  ClpSimplex clp;
  clp.setLogLevel(0);
  clp.resize(nodes + static_cast<int>(network.groups.size()), 0);
  for (int node = 0; node < nodes; ++node) {
    clp.setRowBounds(node, network.cars[node], network.cars[node]);
  }
  for (std::size_t group = 0; group < network.groups.size(); ++group) {
    const double passengers = network.groups[group].passengers;
    clp.setRowBounds(nodes + static_cast<int>(group), passengers, passengers);
  }
  const std::vector<NetworkColumn> columns = columns_of(network);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const auto& [from, to, group] = columns[i];
    std::array<int, 3> rows{};
    std::array<double, 3> entries{};
    int count = 0;
    for (const auto& [row, entry] : {std::pair(from, 1.0), {to, -1.0}, {group < 0 ? -1 : nodes + group, 1.0}}) {
      if (row >= 0) {
        rows[static_cast<std::size_t>(count)] = row;
        entries[static_cast<std::size_t>(count++)] = entry;
      }
    }
    const double cost = i < network.ways.size() ? network.ways[i].km : from < 0 ? price : 0.0;
    clp.addColumn(count, rows.data(), entries.data(), 0.0, COIN_DBL_MAX, cost);
  }
  clp.dual();
  if (!clp.isProvenOptimal()) {
    throw run_failed("Clp finds no flow of a day's cars");
  }
  return clp.objectiveValue();
}

}  // namespace evbal
