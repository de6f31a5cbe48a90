#include "tools/ingest/ingest_command.hpp"

#include "agents/city/synthetic.hpp"
#include "common/error.hpp"
#include "tools/ingest/ingest_trips.hpp"

#include <CLI/CLI.hpp>

#include <iostream>
#include <memory>

namespace evbal {
namespace {

void add_synthetic(CLI::App& ingest) {
  struct Arguments {
    SyntheticOptions options;
    std::string out;
  };
  const auto arguments = std::make_shared<Arguments>();
  SyntheticOptions& options = arguments->options;
  CLI::App* command = ingest.add_subcommand("synthetic", "Generate a city from a seed");
  command->add_option("--out", arguments->out, "Folder of the new pack")->required();
  command->add_option("--name", options.name, "Name of the city")->capture_default_str();
  command->add_option("--regions", options.regions, "Number of regions")
      ->capture_default_str()
      ->check(CLI::Range(1, 1000));
  command->add_option("--train-days", options.train_days)->capture_default_str()->check(CLI::Range(0, 366));
  command->add_option("--test-days", options.test_days)->capture_default_str()->check(CLI::Range(1, 366));
  command->add_option("--seed", options.seed)->capture_default_str();
  command->add_option("--trips", options.trips_per_day, "Mean trips a day")
      ->capture_default_str()
      ->check(CLI::Range(0.0, 1e6));
  command->add_option("--vehicles", options.vehicles)->capture_default_str()->check(CLI::Range(0, 100'000));
  command->add_option("--battery-kwh", options.battery_kwh)->capture_default_str()->check(CLI::Range(1.0, 1000.0));
  command->add_option("--stations", options.stations, "At most one a region")
      ->capture_default_str()
      ->check(CLI::Range(0, 1000));
  command->add_option("--points", options.points, "Charging points of all stations")
      ->capture_default_str()
      ->check(CLI::Range(0, 100'000));
  command->callback([arguments] {
    const SyntheticOptions& wanted = arguments->options;
    if (wanted.stations > wanted.regions || wanted.points < wanted.stations) {
      throw bad_input("--stations must be at most --regions, and --points at least --stations");
    }
    const SyntheticCity made = synthetic_city(wanted);
    write_city(made.city, made.days, arguments->out);
    std::cout << "wrote " << arguments->out << ": " << made.city.size() << " regions, " << made.days.size()
              << " days\n";
  });
}

void add_trips(CLI::App& ingest) {
  struct Arguments {
    TripSources sources;
    std::string out;
  };
  const auto arguments = std::make_shared<Arguments>();
  TripSources& sources = arguments->sources;
  CLI::App* command = ingest.add_subcommand("trips", "Make a city of trip records and polygons");
  command->add_option("--trips", sources.trips, "Folder of trip tables, .csv or .csv.gz")->required();
  command->add_option("--zones", sources.zones, "GeoJSON of the polygons to merge, plain or .gz")->required();
  command->add_option("--sessions", sources.sessions, "Folder of charging sessions")->required();
  command->add_option("--notes", sources.notes, "YAML of what the records do not say: days, fleet, chargers, limits")
      ->required();
  command->add_option("--regions", sources.regions, "Number of regions")
      ->capture_default_str()
      ->check(CLI::Range(1, 5000));
  command->add_option("--out", arguments->out, "Folder of the new pack")->required();
  command->callback([arguments] {
    const IngestedCity made = ingest_trips(arguments->sources);
    write_city(made.city, made.days, arguments->out);
    std::cout << made.report << "wrote " << arguments->out << "\n";
  });
}

}  // namespace

void add_ingest_command(CLI::App& app) {
  CLI::App* ingest = app.add_subcommand("ingest", "Make a city pack from raw records or from a seed");
  ingest->require_subcommand(1);
  add_trips(*ingest);
  add_synthetic(*ingest);
}

}  // namespace evbal
