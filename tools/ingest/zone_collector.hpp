#pragma once

#include "tools/ingest/zones.hpp"
#include "tools/records/dropped.hpp"

#include <map>
#include <optional>
#include <string>

namespace evbal {

/// Puts the polygons of a file together into zones: several of one name are one zone.
class ZoneCollector {
 public:
  /// `kind` is what the file calls its polygons in messages, such as "feature".
  ZoneCollector(const std::filesystem::path& file, std::string kind) : file_(file.string()), kind_(std::move(kind)) {}

  /// An error at a polygon, which is named by its position in the file, from 0.
  Error error(std::size_t position, const std::string& message) const;

  /// Counts something that is no polygon.
  void drop(std::size_t position, const std::string& reason);

  /// A polygon with its rings. `name` is empty if no field tells it; `weight` is nothing if no field tells it.
  void add(std::size_t position, Zone polygon, std::string name, std::optional<double> weight);

  /// The zones. Throws Error{bad_input} if there is none.
  ZoneFile finish();

  /// What was dropped so far.
  const Dropped& dropped() const { return dropped_; }

 private:
  struct Weights {
    double sum = 0.0;
    std::optional<double> of_each;  ///< if all polygons of the zone have the same
  };

  void join(std::size_t zone, const Zone& polygon, std::optional<double> weight);
  void cross_180();
  std::string report() const;

  std::string file_;
  std::string kind_;
  Dropped dropped_;
  std::vector<Zone> zones_;
  std::vector<std::optional<Weights>> weights_;
  std::map<std::string, std::size_t> by_name_;
  std::size_t joined_ = 0;
  std::string first_joined_;
};

}  // namespace evbal
