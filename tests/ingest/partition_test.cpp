#include "tools/ingest/partition.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <numeric>

namespace evbal {
namespace {

/// Square zones of 100 m in rows.
ZoneGraph grid(int columns, int rows) {
  ZoneGraph graph;
  for (int zone = 0; zone < columns * rows; ++zone) {
    const int column = zone % columns;
    const int row = zone / columns;
    graph.weight.push_back(1.0);
    graph.area.push_back(1e4);
    graph.centre.push_back({100.0 * column, 100.0 * row});
    auto& near = graph.neighbours.emplace_back();
    if (row > 0) {
      near.push_back(zone - columns);
    }
    if (column > 0) {
      near.push_back(zone - 1);
    }
    if (column + 1 < columns) {
      near.push_back(zone + 1);
    }
    if (row + 1 < rows) {
      near.push_back(zone + columns);
    }
  }
  return graph;
}

std::vector<double> weights_of(const ZoneGraph& graph, const std::vector<int>& part, int parts) {
  std::vector<double> weights(parts, 0.0);
  for (std::size_t zone = 0; zone < part.size(); ++zone) {
    weights[part[zone]] += graph.weight[zone];
  }
  return weights;
}

RC_GTEST_PROP(Partition, PartsAreConnectedAndNoneIsEmpty, ()) {
  const int columns = *rc::gen::inRange(1, 9);
  const int rows = *rc::gen::inRange(1, 9);
  ZoneGraph graph = grid(columns, rows);
  for (double& weight : graph.weight) {
    weight = *rc::gen::inRange(0, 50);
  }
  const int parts = *rc::gen::inRange(1, columns * rows + 1);
  const auto part = partition(graph, parts);
  for (int p = 0; p < parts; ++p) {
    std::vector<bool> member;
    std::transform(part.begin(), part.end(), std::back_inserter(member), [&](int of) { return of == p; });
    const auto first = std::find(member.begin(), member.end(), true);
    RC_ASSERT(first != member.end());
    RC_ASSERT(reachable(graph.neighbours, static_cast<int>(first - member.begin()), member) == member);
  }
  RC_ASSERT(part == partition(graph, parts));
}

TEST(Partition, BalancesEvenWeights) {
  const ZoneGraph graph = grid(20, 20);
  const auto weights = weights_of(graph, partition(graph, 16), 16);
  EXPECT_GE(*std::min_element(weights.begin(), weights.end()), 20.0);
  EXPECT_LE(*std::max_element(weights.begin(), weights.end()), 30.0);
}

TEST(Partition, MakesPartsSmallWhereWeightIs) {
  ZoneGraph graph = grid(20, 20);
  for (int zone = 0; zone < 400; ++zone) {
    graph.weight[zone] = zone % 20 < 10 ? 9.0 : 1.0;
  }
  const auto part = partition(graph, 10);
  const auto weights = weights_of(graph, part, 10);
  EXPECT_LE(*std::max_element(weights.begin(), weights.end()), 1.5 * 200.0);
  EXPECT_GE(*std::min_element(weights.begin(), weights.end()), 0.5 * 200.0);
}

TEST(Partition, PrefersRoundParts) {
  // Two squares side by side cost less border than any other two halves.
  const auto part = partition(grid(8, 4), 2);
  for (int zone = 0; zone < 32; ++zone) {
    EXPECT_EQ(part[zone] == part[0], zone % 8 < 4) << zone;
  }
}

}  // namespace
}  // namespace evbal
