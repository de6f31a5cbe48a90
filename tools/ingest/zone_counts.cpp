#include "tools/ingest/zone_counts.hpp"

#include "common/random.hpp"
#include "tools/ingest/time_pattern.hpp"
#include "tools/ingest/zone_places.hpp"
#include "tools/records/row_tally.hpp"
#include "tools/records/text_lines.hpp"

#include <algorithm>
#include <chrono>
#include <map>
#include <sstream>

namespace evbal {
namespace {

constexpr long long kMostInARow = 1'000'000;  // of a row
constexpr long long kSecondsOfDay = 24 * 3600;

/// Seconds since 1970 of an ISO date.
long long midnight(const std::string& date) {
  return time_like("%Y-%m-%d", date).value_or(0);
}

auto key(const ZoneCount& cell) {
  return std::tie(cell.day, cell.step, cell.from, cell.to);
}

class CountReader {
 public:
  CountReader(const CountFormat& format, const std::vector<Zone>& zones, const CountChoice& choice)
      : format_(format),
        choice_(choice),
        zones_(zones),
        names_(zones, format.table.decimal_comma ? ',' : '.'),
        no_time_("no time like " + time_example(format.pattern)),
        no_zone_(names_.no_zone()) {
    for (std::size_t d = 0; d < choice.days.size(); ++d) {
      day_of_[midnight(choice.days[d])] = static_cast<int>(d);
    }
  }

  void read(const std::filesystem::path& file) {
    RawTable table(file, format_.table);
    RowTally tally(table, dropped);
    for (; table.next(); ++rows) {
      ZoneCount cell;
      if (tally.keeps(read(table, cell)) && cell.trips > 0) {
        cells.push_back(cell);
      }
    }
    tally.finish();
  }

  std::vector<ZoneCount> cells;
  Dropped dropped;
  long long rows = 0;

 private:
  RowFault read(const RawTable& row, ZoneCount& cell) {
    if (!row.whole()) {
      return row.fault();
    }
    RowFault fault = read_time(row, cell);
    fault = fault ? fault : read_zone(row.text(format_.from), cell.from);
    fault = fault ? fault : read_zone(row.text(format_.to), cell.to);
    if (fault) {
      return fault;
    }
    const auto trips = row.integer(format_.trips);
    if (!trips || *trips < 0 || *trips > kMostInARow) {
      return {"no number of trips, 0 to 1000000", row.text(format_.trips)};
    }
    cell.trips = static_cast<int>(*trips);
    return {};
  }

  RowFault read_time(const RawTable& row, ZoneCount& cell) {
    const auto time = time_in(row, format_.time, format_.pattern, text_);
    if (!time) {
      return {no_time_, text_};
    }
    const auto day = day_of_.find(*time / kSecondsOfDay * kSecondsOfDay);
    if (day == day_of_.end() || *time < 0) {
      return {"on another day", text_, false};
    }
    const int minute = static_cast<int>(*time % kSecondsOfDay / 60) - choice_.day_start;
    if (minute < 0) {
      return {"before the day's start", text_, false};
    }
    cell.day = day->second;
    cell.step = minute / choice_.step_minutes;
    return {};
  }

  RowFault read_zone(std::string_view name, int& zone) const {
    const Zone* found = names_.zone_of(name);
    if (found == nullptr) {
      return {no_zone_, name, false};
    }
    zone = static_cast<int>(found - zones_.data());
    return {};
  }

  const CountFormat& format_;
  const CountChoice& choice_;
  const std::vector<Zone>& zones_;
  ZonePlaces names_;
  std::string no_time_;
  std::string no_zone_;
  std::map<long long, int> day_of_;
  std::string text_;
};

/// Adds up cells of the same key; returns how many more rows than cells there were.
long long add_up(std::vector<ZoneCount>& cells) {
  std::sort(cells.begin(), cells.end(), [](const ZoneCount& a, const ZoneCount& b) { return key(a) < key(b); });
  std::size_t kept = 0;
  for (std::size_t i = 1; i < cells.size(); ++i) {
    if (key(cells[i]) == key(cells[kept])) {
      cells[kept].trips += cells[i].trips;
    } else {
      cells[++kept] = cells[i];
    }
  }
  const std::size_t before = cells.size();
  cells.resize(cells.empty() ? 0 : kept + 1);
  return static_cast<long long>(before - cells.size());
}

/// Draws for each trip whether it is taken.
void thin(std::vector<ZoneCount>& cells, const CountChoice& choice) {
  if (choice.share >= 1.0) {
    return;
  }
  const int steps = 24 * 60 / choice.step_minutes;
  for (ZoneCount& cell : cells) {
    RandomStream random(choice.seed, Purpose::thinned_count,
                        {.region = static_cast<std::uint64_t>(cell.from),
                         .tick = static_cast<std::uint64_t>(cell.day) * steps + cell.step,
                         .index = static_cast<std::uint64_t>(cell.to)});
    int taken = 0;
    for (int trip = 0; trip < cell.trips; ++trip) {
      taken += random.uniform() < choice.share ? 1 : 0;
    }
    cell.trips = taken;
  }
  std::erase_if(cells, [](const ZoneCount& cell) { return cell.trips == 0; });
}

long long total(const std::vector<ZoneCount>& cells) {
  long long sum = 0;
  for (const ZoneCount& cell : cells) {
    sum += cell.trips;
  }
  return sum;
}

void expect_all_days_and_steps(const std::string& folder, const std::vector<ZoneCount>& cells,
                               const CountChoice& choice) {
  std::vector<bool> days(choice.days.size());
  std::vector<bool> steps((24 * 60 - choice.day_start) / choice.step_minutes);
  for (const ZoneCount& cell : cells) {
    days[cell.day] = true;
    steps[std::min<std::size_t>(cell.step, steps.size() - 1)] = true;
  }
  const auto day = std::find(days.begin(), days.end(), false);
  if (day != days.end()) {
    throw bad_input(folder, 0, "has no trip of " + choice.days[day - days.begin()]);
  }
  const auto step = std::find(steps.begin(), steps.end(), false);
  if (step != steps.end()) {
    const auto minute = choice.day_start + (step - steps.begin()) * choice.step_minutes;
    throw bad_input(folder, 0,
                    "has no trip in the step from minute " + std::to_string(minute) +
                        " of any day; are the counts by longer steps? `step` is " +
                        std::to_string(choice.step_minutes) + " min");
  }
}

}  // namespace

ZoneCounts read_counts(const std::filesystem::path& folder, const CountFormat& format, const std::vector<Zone>& zones,
                       const CountChoice& choice) {
  CountReader reader(format, zones, choice);
  try {
    for (const auto& file : csv_files(folder)) {
      reader.read(file);
    }
    expect_all_days_and_steps(folder.string(), reader.cells, choice);
  } catch (const Error& error) {
    throw with_report(error, reader.dropped.report());
  }
  std::ostringstream out;
  out << "count rows read: " << reader.rows << "\n" << reader.dropped.report();
  ZoneCounts counts{std::move(reader.cells), ""};
  if (const long long more = add_up(counts.cells); more > 0) {
    out << "  of a day, step and pair of zones given before, added up: " << more << "\n";
  }
  out << "trips: " << total(counts.cells) << " on " << choice.days.size() << " days\n";
  thin(counts.cells, choice);
  out << "trips drawn, each with a chance of " << choice.share << ": " << total(counts.cells) << "\n";
  counts.report = out.str();
  return counts;
}

}  // namespace evbal
