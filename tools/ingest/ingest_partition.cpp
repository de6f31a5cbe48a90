#include "tools/ingest/ingest_partition.hpp"

#include "common/table_text.hpp"
#include "tools/ingest/merge_zones.hpp"
#include "tools/ingest/outlines.hpp"
#include "tools/ingest/rounding.hpp"
#include "tools/ingest/shared_borders.hpp"
#include "tools/records/dropped.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace evbal {
namespace {

constexpr double kBorderTolerance = 10.0;  // m

/// Centres of the regions' area.
std::vector<LatLon> centres_of(const std::vector<Zone>& zones, const std::vector<int>& region_of, int regions) {
  std::vector<LatLon> centres(regions);
  std::vector<double> area(regions, 0.0);
  const double reference = zones.front().centre.lon;
  for (std::size_t z = 0; z < zones.size(); ++z) {
    const double own = std::max(1.0, zones[z].area_m2);
    area[region_of[z]] += own;
    centres[region_of[z]].lat += own * zones[z].centre.lat;
    centres[region_of[z]].lon += own * longitude_near(zones[z].centre.lon, reference);
  }
  for (int r = 0; r < regions; ++r) {
    centres[r] = rounded({centres[r].lat / area[r], longitude_near(centres[r].lon / area[r], 0.0)});
  }
  return centres;
}

std::string report_of(const std::vector<Zone>& zones, const std::vector<int>& region_of, int regions) {
  std::vector<double> weight(regions, 0.0);
  double total = 0.0;
  for (std::size_t z = 0; z < zones.size(); ++z) {
    weight[region_of[z]] += zones[z].weight;
    total += zones[z].weight;
  }
  const double mean = total > 0.0 ? total / regions : 1.0;
  const auto [least, most] = std::minmax_element(weight.begin(), weight.end());
  std::ostringstream out;
  out.precision(3);
  out << "regions: " << regions << ", weight each from " << *least / mean << " to " << *most / mean << " of the mean\n";
  return out.str();
}

}  // namespace

ZoneFile read_bordering_zones(const std::filesystem::path& file, const ZoneFields& fields) {
  ZoneFile read = read_zones(file, fields);
  read.zones = with_shared_borders(std::move(read.zones), kBorderTolerance);
  return read;
}

Partition partition_zones(ZoneFile file, int regions) {
  Partition made;
  made.zones = std::move(file.zones);
  MergedZones merged;
  try {
    merged = merge_all_zones(made.zones, regions);
  } catch (const Error& error) {
    throw with_report(error, file.report);
  }
  made.region_of = std::move(merged.region_of);
  const auto outlines = merged_outlines(made.zones, made.region_of, regions, outline_tolerance_m);
  const auto centres = centres_of(made.zones, made.region_of, regions);
  for (int r = 0; r < regions; ++r) {
    made.regions.push_back({merged.names[r], outlines[r], centres[r]});
  }
  made.report = file.report + report_of(made.zones, made.region_of, regions);
  return made;
}

std::string zones_csv(const Partition& partition) {
  std::string out = "zone,region\n";
  for (std::size_t z = 0; z < partition.zones.size(); ++z) {
    out += csv_row({partition.zones[z].name, partition.regions[partition.region_of[z]].name});
  }
  return out;
}

}  // namespace evbal
