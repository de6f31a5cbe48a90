#include "experiments/record/day_file.hpp"

#include "experiments/record/database_table.hpp"

#include <SQLiteCpp/SQLiteCpp.h>

#include <optional>

namespace evbal {
namespace {

Row tick_key(int tick, std::size_t seq) {
  return {{"tick", std::int64_t{tick}}, {"seq", static_cast<std::int64_t>(seq)}};
}

Row region_key(int tick, int region, std::size_t seq) {
  return {{"tick", std::int64_t{tick}}, {"region", std::int64_t{region}}, {"seq", static_cast<std::int64_t>(seq)}};
}

Row event_row(int tick, std::size_t seq, const std::string& kind, const std::string& what) {
  Row row = tick_key(tick, seq);
  row.push_back({"kind", kind});
  row.push_back({"what", what});
  return row;
}

Row region_row(std::size_t region, const std::string& name, int points) {
  return {{"region", static_cast<std::int64_t>(region)}, {"name", name}, {"points", std::int64_t{points}}};
}

Row fault_row(std::size_t position, const RequestedFault& fault) {
  return {{"fault", static_cast<std::int64_t>(position)},
          {"name", fault.name},
          {"type", fault.type},
          {"start", std::int64_t{fault.start}},
          {"end", std::int64_t{fault.end}}};
}

SQLite::Database created(const std::filesystem::path& file) {
  SQLite::Database database(file.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
  // The record of a run that dies with its machine is marked incomplete anyway: no need to wait for the disk.
  database.exec("PRAGMA synchronous = OFF");
  return database;
}

}  // namespace

RequestedFault requested(const Fault& fault) {
  return {.name = fault.name, .type = word(fault.type), .start = fault.start, .end = fault.start + fault.duration};
}

struct DayFile::Tables {
  explicit Tables(const std::filesystem::path& file)
      : database(created(file)),
        transaction(std::in_place, database),
        regions(database, "regions", region_row(0, "", 0)),
        faults(database, "faults", fault_row(0, {})),
        injector(database, "injector", row_of({}, Faults{})),
        effects(database, "effects", row_of(tick_key(0, 0), Effect{})),
        observed(database, "observed", row_of(region_key(0, 0, 0), Observed{})),
        reports(database, "reports", row_of({}, Report{})),
        plans(database, "plans", row_of({}, Plan{})),
        moves(database, "moves", row_of(tick_key(0, 0), Move{})),
        costs(database, "plan_costs", row_of(tick_key(0, 0), PlanCost{})),
        rejections(database, "rejections", row_of(tick_key(0, 0), Rejection{})),
        flags(database, "sensor_flags", row_of(tick_key(0, 0), SensorFlag{})),
        innovations(database, "innovations", row_of(tick_key(0, 0), FieldInnovations{})),
        departures(database, "departures", row_of({}, Departures{})),
        vehicles(database, "vehicles", row_of(region_key(0, 0, 0), Departure{})),
        fates(database, "fates", row_of(region_key(0, 0, 0), Fate{})),
        events(database, "events", event_row(0, 0, "", "")) {}

  SQLite::Database database;
  std::optional<SQLite::Transaction> transaction;
  Table regions;
  Table faults;
  Table injector;
  Table effects;
  Table observed;
  Table reports;
  Table plans;
  Table moves;
  Table costs;
  Table rejections;
  Table flags;
  Table innovations;
  Table departures;
  Table vehicles;
  Table fates;
  Table events;
  int event_tick = -1;
  std::size_t event_seq = 0;

  /// What `change` does to the database. Throws Error{run_failed} if it cannot be written.
  template <class Change>
  void write(Change change) {
    try {
      change();
    } catch (const SQLite::Exception& error) {
      throw cannot_write(database, error);
    }
  }

  void add(const TickRecord& record);
  void add(const Plan& plan);
};

std::unique_ptr<DayFile::Tables> DayFile::created_tables(const std::filesystem::path& file) {
  try {
    return std::make_unique<Tables>(file);
  } catch (const SQLite::Exception& error) {
    throw run_failed(file.string() + ": cannot be written: " + error.what());
  }
}

DayFile::DayFile(const std::filesystem::path& file, const std::vector<std::string>& region_names,
                 const std::vector<int>& points, const std::vector<RequestedFault>& faults)
    : tables_(created_tables(file)) {
  tables_->write([&] {
    for (std::size_t i = 0; i < region_names.size(); ++i) {
      tables_->regions.add(region_row(i, region_names[i], points[i]));
    }
    for (std::size_t i = 0; i < faults.size(); ++i) {
      tables_->faults.add(fault_row(i, faults[i]));
    }
  });
  commit();
}

DayFile::~DayFile() = default;

void DayFile::Tables::add(const Plan& plan) {
  const auto add_all = [&](Table& table, const auto& messages) {
    for (std::size_t i = 0; i < messages.size(); ++i) {
      table.add(row_of(tick_key(plan.tick, i), messages[i]));
    }
  };
  plans.add(row_of({}, plan));
  add_all(moves, plan.moves);
  add_all(costs, plan.provenance.costs);
  add_all(rejections, plan.provenance.rejected);
  add_all(flags, plan.provenance.flags);
  add_all(innovations, plan.provenance.innovations);
}

void DayFile::Tables::add(const TickRecord& record) {
  const int tick = record.tick.tick;
  injector.add(row_of({}, record.faults));
  for (std::size_t i = 0; i < record.faults.effects.size(); ++i) {
    effects.add(row_of(tick_key(tick, i), record.faults.effects[i]));
  }
  for (const auto& report : record.exchange.reports) {
    reports.add(row_of({}, report));
  }
  if (record.exchange.plan) {
    add(*record.exchange.plan);
  }
  for (std::size_t i = 0; i < record.seen.size(); ++i) {
    observed.add(row_of(region_key(tick, record.seen[i].region, i), record.seen[i].observed));
  }
  const auto add_all = [tick](Table& table, int region, const auto& messages) {
    for (std::size_t i = 0; i < messages.size(); ++i) {
      table.add(row_of(region_key(tick, region, i), messages[i]));
    }
  };
  for (const auto& said : record.exchange.departures) {
    departures.add(row_of({}, said));
    add_all(vehicles, said.region, said.departures);
    add_all(fates, said.region, said.fates);
    add_all(observed, said.region, said.observed);
  }
}

void DayFile::add(const TickRecord& record) {
  tables_->write([&] { tables_->add(record); });
}

void DayFile::add_fault(std::size_t position, const RequestedFault& fault) {
  tables_->write([&] { tables_->faults.add(fault_row(position, fault)); });
}

void DayFile::event(int tick, const std::string& kind, const std::string& what) {
  tables_->event_seq = tick == tables_->event_tick ? tables_->event_seq + 1 : 0;
  tables_->event_tick = tick;
  tables_->write([&] { tables_->events.add(event_row(tick, tables_->event_seq, kind, what)); });
}

void DayFile::commit() {
  tables_->write([&] {
    tables_->transaction->commit();
    tables_->transaction.emplace(tables_->database);
  });
}

}  // namespace evbal
