#include "experiments/record/recorded_fault.hpp"

#include <SQLiteCpp/SQLiteCpp.h>

namespace evbal {

std::vector<RecordedFault> read_faults(const std::filesystem::path& file) {
  const SQLite::Database database(file.string());
  std::vector<RecordedFault> faults;
  SQLite::Statement requested(database, "SELECT name, type, start, end FROM faults ORDER BY fault");
  while (requested.executeStep()) {
    faults.push_back({{.name = requested.getColumn(0).getString(),
                       .type = requested.getColumn(1).getString(),
                       .start = requested.getColumn(2).getInt(),
                       .end = requested.getColumn(3).getInt()}});
  }
  const auto fault = [&faults](int position) -> RecordedFault& {
    return faults.at(static_cast<std::size_t>(position));
  };
  SQLite::Statement effects(database, "SELECT fault, tick, region FROM effects");
  while (effects.executeStep()) {
    fault(effects.getColumn(0).getInt()).said[effects.getColumn(1).getInt()].insert(effects.getColumn(2).getInt());
  }
  SQLite::Statement observed(database, "SELECT fault, tick, region, amount, evicted FROM observed");
  while (observed.executeStep()) {
    auto& seen = fault(observed.getColumn(0).getInt());
    seen.amount[observed.getColumn(1).getInt()] += observed.getColumn(3).getDouble();
    seen.seen_regions.insert(observed.getColumn(2).getInt());
    seen.evicted += observed.getColumn(4).getInt();
  }
  SQLite::Statement fallen(database, "SELECT tick FROM plans WHERE provenance_fallback <> 'none'");
  while (fallen.executeStep()) {
    for (auto& seen : faults) {
      if (const int tick = fallen.getColumn(0).getInt(); seen.type.starts_with("solver.") && seen.said.contains(tick)) {
        seen.amount[tick] = 1.0;
      }
    }
  }
  return faults;
}

}  // namespace evbal
