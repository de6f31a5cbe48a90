#include "tools/ingest/station_list.hpp"

#include <algorithm>
#include <cmath>

namespace evbal {
namespace {

constexpr double kOneStation = 100.0;     // m between rows of one name
constexpr double kDegreeParts = 100'000;  // of a degree: about a metre

}  // namespace

void StationList::Count::add(const std::string& where) {
  first = times == 0 ? where : first;
  ++times;
}

std::string StationList::Count::line(const std::string& what) const {
  return times == 0 ? "" : "  " + what + ": " + std::to_string(times) + " (first: " + first + ")\n";
}

std::string StationList::free_name(const std::string& name) const {
  std::string free = name;
  for (int number = 2; names_.count(free) > 0; ++number) {
    free = name + " " + std::to_string(number);
  }
  return free;
}

void StationList::add(const Station& row, const std::string& where) {
  std::vector<std::size_t>& same_name = of_name_[row.name];
  const LocalFrame around(row.place);
  for (const std::size_t s : same_name) {
    if (distance(around.local(stations_[s].place), {}) <= kOneStation) {
      stations_[s].points += row.points;
      joined_.add(where + ": `" + row.name + "`");
      return;
    }
  }
  Station station = row;
  station.name = free_name(row.name);
  if (station.name != row.name) {
    renamed_.add(where + ": `" + row.name + "` is `" + station.name + "`");
  }
  const std::pair place(std::llround(row.place.lat * kDegreeParts), std::llround(row.place.lon * kDegreeParts));
  const auto [there, is_new] = at_place_.try_emplace(place, stations_.size());
  if (!is_new) {
    same_place_.add(where + ": `" + station.name + "` beside `" + stations_[there->second].name + "`");
  }
  names_.insert(station.name);
  same_name.push_back(stations_.size());
  stations_.push_back(station);
}

std::string StationList::report() const {
  return joined_.line("further rows of a station, points added up") +
         renamed_.line("of a name that another station has, numbered") +
         same_place_.line("at the very place of another station; listed twice?");
}

std::vector<Station> share_of_points(const std::vector<Station>& stations, double share) {
  struct Part {
    std::size_t station = 0;
    double rest = 0.0;
  };
  std::vector<Station> kept = stations;
  std::vector<Part> parts;
  double total = 0.0;
  int given = 0;
  for (std::size_t s = 0; s < kept.size(); ++s) {
    const double exact = share * kept[s].points;
    total += exact;
    kept[s].points = static_cast<int>(exact);
    given += kept[s].points;
    parts.push_back({s, exact - kept[s].points});
  }
  std::stable_sort(parts.begin(), parts.end(), [](const Part& a, const Part& b) { return a.rest > b.rest; });
  const auto left = static_cast<std::size_t>(std::lround(total) - given);
  for (std::size_t p = 0; p < std::min(left, parts.size()); ++p) {
    ++kept[parts[p].station].points;
  }
  std::erase_if(kept, [](const Station& station) { return station.points == 0; });
  return kept;
}

}  // namespace evbal
