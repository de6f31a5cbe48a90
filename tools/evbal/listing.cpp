#include "tools/evbal/listing.hpp"

#include "agents/world/world.hpp"
#include "common/files.hpp"
#include "common/installation.hpp"
#include "common/plain_text.hpp"
#include "coordinator/balancing/controllers.hpp"
#include "tools/evbal/metric_meanings.hpp"

#include <utility>

namespace evbal {
namespace {

Listing cities() {
  Listing listing{{"city", "regions", "vehicles", "points", "first day", "last day"}, {}};
  for (const auto& name : pack_names()) {
    const City city = find_city(name);
    const bool recorded = !city.days.empty();
    listing.rows.push_back({name, std::int64_t{city.size()}, std::int64_t{city.fleet.vehicles},
                            std::int64_t{city.points().sum()}, recorded ? city.days.front() : "",
                            recorded ? city.days.back() : ""});
  }
  return listing;
}

Listing own_controllers() {
  Listing listing{{"controller", "about"}, {}};
  for (const auto& controller : controllers()) {
    listing.rows.push_back({controller.name, controller.about});
  }
  return listing;
}

Listing metrics() {
  Listing listing{{"metric", "unit", "meaning"}, {}};
  for (const auto& [name, unit, meaning] : metric_meanings()) {
    listing.rows.push_back({name, unit, meaning});
  }
  return listing;
}

/// The files that are shipped in the folder of that name.
Listing files(const std::string& folder) {
  Listing listing{{"file", "about"}, {}};
  for (const auto& name : shipped_names(folder)) {
    listing.rows.push_back({name, first_sentence(text_of_file(shipped_folder(folder) / name))});
  }
  return listing;
}

}  // namespace

std::vector<std::string> listed_kinds() {
  return {"cities", "scenarios", "controllers", "metrics", "faults", "studies", "benchmarks"};
}

Listing listing_of(const std::string& kind) {
  if (kind == "cities") {
    return cities();
  }
  if (kind == "controllers") {
    return own_controllers();
  }
  return kind == "metrics" ? metrics() : files(kind);
}

std::string first_sentence(const std::string& yaml) {
  std::string text;
  for (const auto& line : lines_of(yaml)) {
    if (!line.starts_with("# ")) {
      break;
    }
    text += (text.empty() ? "" : " ") + line.substr(2);
  }
  text = text.substr(0, text.find(". "));
  return text.ends_with('.') ? text.substr(0, text.size() - 1) : text;
}

}  // namespace evbal
