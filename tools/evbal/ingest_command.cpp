#include "tools/evbal/ingest_command.hpp"

#include "agents/world/regions_file.hpp"
#include "agents/world/stations_yaml.hpp"
#include "agents/world/synthetic.hpp"
#include "common/error.hpp"
#include "common/files.hpp"
#include "common/new_folder.hpp"
#include "tools/gps/ingest_gps.hpp"
#include "tools/ingest/ingest_counts.hpp"
#include "tools/ingest/ingest_od.hpp"
#include "tools/ingest/ingest_partition.hpp"
#include "tools/ingest/ingest_rl4amod.hpp"
#include "tools/ingest/ingest_stations.hpp"
#include "tools/ingest/ingest_trips.hpp"

#include <CLI/CLI.hpp>
#include <unistd.h>

#include <cstdio>
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

void add_od(CLI::App& ingest) {
  struct Arguments {
    OdSources sources;
    std::string out;
  };
  const auto arguments = std::make_shared<Arguments>();
  OdSources& sources = arguments->sources;
  CLI::App* command = ingest.add_subcommand("od", "Make a city of one day's trips without their time of day");
  command->add_option("--trips", sources.trips, "Table of trips between cells, .csv, plain or compressed")->required();
  command->add_option("--zones", sources.zones, "Polygons to merge: GeoJSON or a shapefile")->required();
  command
      ->add_option("--stations", sources.stations,
                   "List of stations, .csv or Open Charge Map's .json, plain or compressed")
      ->required();
  command->add_option("--like", sources.like, "Pack of the city that lends its days")->required();
  command->add_option("--notes", sources.notes, "YAML of what the tables do not say")->required();
  command->add_option("--regions", sources.regions, "Number of regions")
      ->capture_default_str()
      ->check(CLI::Range(1, 5000));
  command->add_option("--out", arguments->out, "Folder of the new pack")->required();
  command->callback([arguments] {
    const OdCity made = ingest_od(arguments->sources);
    write_city(made.city, {}, arguments->out);
    std::cout << made.report << "wrote " << arguments->out << "\n";
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
  command->add_option("--trips", sources.trips, "Folder of trip tables, .csv or .txt, plain or compressed")->required();
  command->add_option("--format", sources.format,
                      "YAML of where their columns are and what they mean; without it, as `ingest gps` writes them");
  command->add_option("--zones", sources.zones, "Polygons to merge: GeoJSON, plain or compressed, or a shapefile")
      ->required();
  command->add_option("--sessions", sources.sessions, "Folder of charging sessions")->required();
  command->add_option("--session-format", sources.session_format,
                      "YAML of where their columns are; without it, as Dundee City Council publishes them");
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

void add_counts(CLI::App& ingest) {
  struct Arguments {
    CountSources sources;
    std::string out;
  };
  const auto arguments = std::make_shared<Arguments>();
  CountSources& sources = arguments->sources;
  CLI::App* command = ingest.add_subcommand("counts", "Make a city of trip counts by date, time and pair of zones");
  command->add_option("--counts", sources.counts, "Folder of tables of counts, .csv, plain, .gz or .xz")->required();
  command->add_option("--zones", sources.zones, "Polygons to merge: GeoJSON, plain or compressed, or a shapefile")
      ->required();
  command->add_option("--trips", sources.trips, "Table of single trips, for travel: .csv, plain or compressed")
      ->required();
  command
      ->add_option("--stations", sources.stations,
                   "List of stations, .csv or Open Charge Map's .json, plain or compressed")
      ->required();
  command->add_option("--sessions", sources.sessions, "Folder of charging sessions")->required();
  command->add_option("--notes", sources.notes, "YAML of what the tables do not say, and how they are laid out")
      ->required();
  command->add_option("--regions", sources.regions, "Number of regions, as many as zones at most")
      ->required()
      ->check(CLI::Range(1, 5000));
  command->add_option("--out", arguments->out, "Folder of the new pack")->required();
  command->callback([arguments] {
    const IngestedCity made = ingest_counts(arguments->sources);
    write_city(made.city, made.days, arguments->out);
    std::cout << made.report << "wrote " << arguments->out << "\n";
  });
}

void add_partition(CLI::App& ingest) {
  struct Arguments {
    std::string zones;
    ZoneFields fields;
    int regions = 0;
    std::string out;
  };
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command = ingest.add_subcommand("partition", "Merge polygons into regions");
  command->add_option("--zones", arguments->zones, "Polygons: GeoJSON, plain or .gz, or a shapefile")->required();
  command->add_option("--regions", arguments->regions, "Number of regions")->required()->check(CLI::Range(1, 5000));
  command->add_option("--weight", arguments->fields.weight, "Field of the polygons that is balanced; else their area");
  command->add_option("--name", arguments->fields.name,
                      "Field that names them, those of one name as one; else their position");
  command->add_option("--out", arguments->out, "New folder for regions.geojson and zones.csv")->required();
  command->callback([arguments] {
    NewFolder folder(arguments->out);
    const Partition made =
        partition_zones(read_bordering_zones(arguments->zones, arguments->fields), arguments->regions);
    write_file(folder.path() / "regions.geojson", regions_geojson(made.regions));
    write_file(folder.path() / "zones.csv", zones_csv(made));
    folder.keep();
    std::cout << made.report << "wrote " << arguments->out << "\n";
  });
}

void add_rl4amod(CLI::App& ingest) {
  struct Arguments {
    std::string scenario;
    std::string notes;
    std::string out;
  };
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command = ingest.add_subcommand("rl4amod", "Make a city of a scenario file of RL4AMOD");
  command->add_option("FILE", arguments->scenario, "scenario_CITY.json, plain or compressed")->required();
  command
      ->add_option("--notes", arguments->notes, "YAML of what it does not say: days, speed, fleet, chargers, patience")
      ->required();
  command->add_option("--out", arguments->out, "Folder of the new pack")->required();
  command->callback([arguments] {
    const Rl4amodCity city = ingest_rl4amod(arguments->scenario, arguments->notes);
    NewFolder folder(arguments->out);
    write_city(city.made.city, city.made.days, folder.path());
    write_file(folder.path() / "prices.csv", city.prices);
    folder.keep();
    std::cout << city.made.report << "wrote " << arguments->out << "\n";
  });
}

void add_stations(CLI::App& ingest) {
  struct Arguments {
    std::string table;
    std::string format;
    std::string regions;
    double snap_m = 500.0;
    std::string out;
  };
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command = ingest.add_subcommand("stations", "Put charging stations into the regions that they lie in");
  command
      ->add_option("--stations", arguments->table,
                   "List of stations, .csv or Open Charge Map's .json, plain or compressed")
      ->required();
  command->add_option("--format", arguments->format, "YAML of how it is laid out")->required();
  command->add_option("--regions", arguments->regions, "regions.geojson of a pack or of `ingest partition`")
      ->required();
  command->add_option("--snap", arguments->snap_m, "Metres outside all regions up to which the nearest takes a station")
      ->capture_default_str()
      ->check(CLI::Range(0.0, 1e5));
  command->add_option("--out", arguments->out, "New YAML file with the list `stations`")->required();
  command->callback([arguments] {
    if (std::filesystem::exists(arguments->out)) {
      throw bad_input(arguments->out, 0, "exists; give a new file");
    }
    const std::vector<Region> regions = read_regions(arguments->regions);
    YamlMap map(YamlValue::load(arguments->format));
    const StationFormat format = read_station_format(map);
    map.finish();
    const IngestedStations made = ingest_stations(arguments->table, format, regions, arguments->snap_m);
    write_file(arguments->out, stations_yaml(made.stations, regions));
    std::cout << made.report << "wrote " << arguments->out << "\n";
  });
}

/// How far the reading has come: one line that renews itself on a terminal, else a line every ten files.
void show_progress(const FixProgress& progress) {
  const bool terminal = isatty(STDERR_FILENO) == 1;
  if (terminal || progress.file % 10 == 1) {
    std::fprintf(stderr, "%sfile %d of %d, %lld fixes%s", terminal ? "\r\033[K" : "", progress.file, progress.files,
                 progress.rows, terminal ? "" : "\n");
  }
}

void add_gps(CLI::App& ingest) {
  struct Arguments {
    GpsSources sources;
    bool quiet = false;
    std::string out;
  };
  const auto arguments = std::make_shared<Arguments>();
  GpsSources& sources = arguments->sources;
  CLI::App* command = ingest.add_subcommand("gps", "Make trips, charging stops and transitions of GPS fixes");
  command->add_option("--gps", sources.gps, "Folder of tables of fixes, .csv or .txt, plain or compressed")->required();
  command->add_option("--format", sources.format, "YAML of where their columns are and what they mean")->required();
  command->add_option("--regions", sources.regions, "regions.geojson: for transitions between regions");
  command->add_option("--stations", sources.stations, "YAML with a list `stations`: for charging stops");
  command->add_option("--out", arguments->out, "New folder for the tables")->required();
  command->add_flag("--quiet", arguments->quiet, "No progress");
  command->callback([arguments] {
    NewFolder folder(arguments->out);
    const bool quiet = arguments->quiet;
    const std::string report = ingest_gps(arguments->sources, folder.path(), [quiet](const FixProgress& progress) {
      if (!quiet) {
        show_progress(progress);
      }
    });
    if (!quiet && isatty(STDERR_FILENO) == 1) {
      std::fputs("\n", stderr);
    }
    folder.keep();
    std::cout << report << "wrote " << arguments->out << "\n";
  });
}

}  // namespace

void add_ingest_command(CLI::App& app) {
  CLI::App* ingest = app.add_subcommand("ingest", "Make a city pack from raw records or from a seed");
  ingest->require_subcommand(1);
  add_counts(*ingest);
  add_gps(*ingest);
  add_od(*ingest);
  add_partition(*ingest);
  add_rl4amod(*ingest);
  add_stations(*ingest);
  add_trips(*ingest);
  add_synthetic(*ingest);
}

}  // namespace evbal
