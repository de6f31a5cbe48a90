#pragma once

#include "agents/world/city.hpp"
#include "agents/world/geometry.hpp"

#include <map>
#include <set>
#include <string>
#include <vector>

namespace evbal {

/// The stations of a city as tables list them: several rows for one, and several of one name.
class StationList {
 public:
  /// Adds a row. A station of its name within 100 m gets its points; one further off is another station. `where` is
  /// file and line.
  void add(const Station& row, const std::string& where);

  /// In the order in which each was first listed; names differ.
  const std::vector<Station>& stations() const { return stations_; }

  /// What was joined and renamed, and stations of different names at one place, which may be one that is listed twice;
  /// a line an item.
  std::string report() const;

 private:
  /// How often something happened, and the first of it.
  struct Count {
    int times = 0;
    std::string first;
    void add(const std::string& where);
    std::string line(const std::string& what) const;
  };

  std::string free_name(const std::string& name) const;

  std::vector<Station> stations_;
  std::map<std::string, std::vector<std::size_t>> of_name_;  ///< positions, by the name that is listed
  std::set<std::string> names_;
  std::map<std::pair<long long, long long>, std::size_t> at_place_;  ///< by about a metre
  Count joined_;
  Count renamed_;
  Count same_place_;
};

/// The stations' share of their points, in whole points by the largest remainders; stations left without are dropped.
std::vector<Station> share_of_points(const std::vector<Station>& stations, double share);

}  // namespace evbal
