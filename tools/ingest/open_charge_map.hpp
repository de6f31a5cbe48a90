#pragma once

#include "agents/world/city.hpp"
#include "tools/records/raw_table.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace evbal {

/// Reads the entries of a JSON list as Open Charge Map exports it.
class ChargeMapEntry {
 public:
  /// Reads name, place and points of an entry into `station`, or says what is wrong with it. Its points are
  /// NumberOfPoints, or where that is null or 0 the sum of the Quantity of its Connections.
  RowFault read(const nlohmann::json& entry, Station& station);

  /// Connections of the last entry whose number is not told and not known otherwise.
  int untold() const { return untold_; }

 private:
  RowFault read_place(const nlohmann::json& address, LatLon& place);
  RowFault read_points(const nlohmann::json& entry, int& points);
  RowFault fault(std::string_view reason, const nlohmann::json& value);

  std::string name_;
  std::string value_;  ///< of the fault
  int untold_ = 0;
};

}  // namespace evbal
