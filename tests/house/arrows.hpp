#pragma once

#include <string>
#include <vector>

// The include arrows of docs/architecture.md, which arrows_test.cpp holds: who may know whom, downhill only.

namespace evbal::house {

using Words = std::vector<std::string>;

struct Room {
  std::string folder;
  Words knows;  ///< rooms above it in the table, besides itself
};

// A program's `main` lies in the folder above its libraries, so "agents" is the room of evbal-agent alone. A row names
// what the room includes today and nothing more.
inline const std::vector<Room>& rooms() {
  static const std::vector<Room> table = {
      {"common", {}},
      {"agents/protocol", {"common"}},
      {"agents/world", {"common", "agents/protocol"}},
      {"agents/region", {"common", "agents/protocol", "agents/world"}},
      {"agents/bus", {"common", "agents/protocol"}},
      {"agents/hosting", {"common", "agents/protocol", "agents/bus"}},
      {"agents", {"agents/protocol", "agents/region", "agents/hosting"}},
      {"faults/schedule", {"common", "agents/protocol"}},
      {"faults", {"agents/world", "agents/hosting", "faults/schedule"}},
      {"coordinator/filter", {"common", "agents/protocol"}},
      {"coordinator/forecast", {"common"}},
      {"coordinator/ambiguity", {"common", "coordinator/forecast"}},
      {"coordinator/convex", {"common"}},
      {"coordinator/balancing", {"common", "coordinator/forecast", "coordinator/ambiguity", "coordinator/convex"}},
      {"coordinator/planning",
       {"common", "agents/protocol", "agents/world", "coordinator/filter", "coordinator/forecast",
        "coordinator/ambiguity", "coordinator/convex", "coordinator/balancing"}},
      {"coordinator/bridge",
       {"common", "agents/protocol", "agents/world", "agents/hosting", "coordinator/balancing",
        "coordinator/planning"}},
      {"coordinator/serving",
       {"common", "agents/protocol", "agents/world", "agents/hosting", "faults/schedule", "coordinator/balancing",
        "coordinator/planning", "coordinator/bridge"}},
      {"coordinator", {"coordinator/bridge", "coordinator/serving"}},
      {"experiments/scenario",
       {"common", "agents/world", "faults/schedule", "coordinator/convex", "coordinator/balancing",
        "coordinator/planning"}},
      {"experiments/conductor",
       {"common", "agents/protocol", "agents/world", "agents/region", "agents/bus", "agents/hosting",
        "experiments/scenario"}},
      {"experiments/bound",
       {"common", "agents/protocol", "agents/world", "faults/schedule", "experiments/scenario",
        "experiments/conductor"}},
      {"experiments/metrics", {"common", "agents/protocol"}},
      {"experiments/record",
       {"common", "agents/protocol", "faults/schedule", "experiments/scenario", "experiments/metrics"}},
      {"experiments/progress", {"common", "agents/protocol"}},
      {"experiments/run",
       {"common", "agents/protocol", "agents/world", "faults/schedule", "coordinator/balancing", "coordinator/planning",
        "coordinator/bridge", "experiments/scenario", "experiments/conductor", "experiments/metrics",
        "experiments/record"}},
      {"experiments/study/design", {"common", "coordinator/planning", "experiments/scenario", "experiments/metrics"}},
      {"experiments/study/store", {"common", "experiments/metrics", "experiments/record", "experiments/study/design"}},
      {"experiments/study/statistics", {"common", "experiments/metrics", "experiments/study/design"}},
      {"experiments/study/executors",
       {"common", "agents/protocol", "faults/schedule", "experiments/scenario", "experiments/record", "experiments/run",
        "experiments/study/design", "experiments/study/store", "experiments/study/statistics"}},
      {"experiments/search",
       {"common", "agents/protocol", "faults/schedule", "experiments/scenario", "experiments/metrics",
        "experiments/study/design", "experiments/study/store", "experiments/study/executors"}},
      {"tools/records", {"common", "agents/world"}},
      {"tools/fit",
       {"common", "agents/world", "coordinator/forecast", "coordinator/convex", "coordinator/balancing",
        "coordinator/planning", "experiments/conductor"}},
      {"tools/gps", {"common", "agents/world", "tools/records", "tools/fit"}},
      {"tools/ingest", {"common", "agents/world", "tools/records"}},
      {"tools/report",
       {"common", "agents/world", "coordinator/forecast", "experiments/bound", "experiments/record",
        "experiments/study/store", "experiments/study/statistics"}},
      {"tools/console",
       {"common", "agents/protocol", "faults/schedule", "experiments/scenario", "experiments/record", "experiments/run",
        "tools/report"}},
      {"tools/samples", {"common", "coordinator/balancing"}},
      {"tools/verify",
       {"common", "coordinator/ambiguity", "coordinator/convex", "coordinator/balancing", "coordinator/planning",
        "experiments/bound", "tools/samples"}},
      {"tools/bench", {"common", "coordinator/convex", "coordinator/balancing", "tools/samples", "tools/verify"}},
      {"tools/python",
       {"common", "agents/protocol", "agents/world", "coordinator/balancing", "experiments/scenario",
        "experiments/metrics", "experiments/record", "experiments/run", "experiments/study/design",
        "experiments/study/store"}},
      {"tools/evbal",
       {"common",
        "agents/protocol",
        "agents/world",
        "faults/schedule",
        "coordinator/convex",
        "coordinator/balancing",
        "coordinator/planning",
        "experiments/scenario",
        "experiments/conductor",
        "experiments/bound",
        "experiments/record",
        "experiments/progress",
        "experiments/run",
        "experiments/study/design",
        "experiments/study/store",
        "experiments/study/statistics",
        "experiments/study/executors",
        "experiments/search",
        "tools/fit",
        "tools/gps",
        "tools/ingest",
        "tools/report",
        "tools/console",
        "tools/verify"}},
  };
  return table;
}

struct Reserved {
  std::string include;  ///< beginning of what stands between the quotes or angle brackets
  Words rooms;          ///< the rooms that may include it
};

// Third-party names that stay in one place.
inline const std::vector<Reserved>& reserved() {
  static const std::vector<Reserved> table = {
      {"fastdds/", {"agents/bus"}},
      {"fastrtps/", {"agents/bus"}},
      {"fastcdr/", {"agents/bus"}},
      // Certificates are made where they are used.
      {"openssl/", {"agents/bus"}},
      {"Ip", {"coordinator/convex"}},
      {"Clp", {"coordinator/convex", "tools/verify"}},
      {"Coin", {"coordinator/convex"}},
      {"mrpt/bayes", {"coordinator/filter"}},
      {"mrpt/math", {"agents/world"}},
      {"mrpt/system", {"common"}},
      {"yaml-cpp/", {"common"}},
      {"Random123/", {"common"}},
      {"nlopt", {"coordinator/forecast"}},
      {"pybind11/", {"tools/python"}},
      {"httplib", {"tools/console"}},
      {"SQLiteCpp/", {"experiments/record", "experiments/study/store"}},
  };
  return table;
}

struct Ban {
  std::string folder;
  Words includes;
};

// The problem is mathematics: values in, values out.
inline const std::vector<Ban>& bans() {
  static const std::vector<Ban> table = {
      {"coordinator/balancing", {"common/clock.hpp", "common/yaml.hpp", "chrono", "filesystem", "fstream", "thread"}},
  };
  return table;
}

}  // namespace evbal::house
