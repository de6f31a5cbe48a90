#include "tools/gps/fixes.hpp"

#include "common/decimal.hpp"
#include "tools/gps/drivable.hpp"
#include "tools/gps/fix_rows.hpp"
#include "tools/records/row_tally.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <vector>

namespace evbal {
namespace {

constexpr long long kTellEvery = 100'000;     // rows
constexpr long long kFewDisordered = 100;     // rows out of order that any table may have
constexpr std::size_t kFewWaiting = 250'000;  // rows that are looked at together, at least
constexpr std::size_t kLookAhead = 60;        // rows of a vehicle that wait for those after them
constexpr std::string_view kDisordered = "out of the order of time";
constexpr std::string_view kNoDrive = "where or when no car can have driven";

/// The rows of a vehicle that were read and not yet handed over.
struct Waiting {
  std::vector<Fix> fixes;
  std::vector<int> lines;
  std::size_t ordered = 0;  ///< at the front: in the order of recording, and of UTC
  std::optional<Fix> last;  ///< handed over before

  void resize(std::size_t rows) {
    fixes.resize(rows);
    lines.resize(rows);
  }
};

/// Puts rows in the order of time and hands over what vehicles can have driven.
class Sorter {
 public:
  Sorter(const GpsFormat& format, const UseFix& use, FixCount& count) : format_(format), use_(use), count_(count) {}

  void begin_file(std::string file) {
    file_ = std::move(file);
    disordered_before_ = count_.dropped.rows(kDisordered);
    read_before_ = count_.read;
    backwards_ = false;
  }

  void begin_vehicle(std::string_view name) {
    if (at_ == vehicles_.end() || at_->first != name) {
      at_ = vehicles_.find(name);
      if (at_ == vehicles_.end()) {
        at_ = vehicles_.emplace(name, Waiting()).first;
      }
    }
  }

  /// A row of the vehicle that was begun.
  void add(const Fix& fix, int line) {
    Waiting& rows = at_->second;
    if (rows.fixes.size() > rows.ordered) {
      steps_ += fix.time > rows.fixes.back().time ? 1 : fix.time < rows.fixes.back().time ? -1 : 0;
    }
    rows.fixes.push_back(fix);
    rows.lines.push_back(line);
    if (++waiting_ > most_waiting_) {
      hand_over(kLookAhead);
      most_waiting_ = std::max(kFewWaiting, 2 * waiting_);  // of many vehicles many rows wait on
    }
  }

  void end_file() {
    hand_over(0);
    count_.backwards += backwards_ ? 1 : 0;
    const long long disordered = count_.dropped.rows(kDisordered) - disordered_before_;
    const long long read = count_.read - read_before_;
    if (disordered > kFewDisordered && 10 * disordered > read) {
      throw bad_input(file_, 0,
                      std::to_string(disordered) + " of its " + std::to_string(read) +
                          " rows are not in the order of time, or older than an earlier file's of the same vehicle; "
                          "sort them by time and give each once");
    }
  }

 private:
  /// Hands over all rows that wait but the last `keep` of each vehicle.
  void hand_over(std::size_t keep) {
    backwards_ |= steps_ < 0;
    waiting_ = 0;
    for (auto& [name, rows] : vehicles_) {
      if (!rows.fixes.empty()) {
        put_in_order(rows);
        pass_on(name, rows, keep);
        waiting_ += rows.fixes.size();
      }
    }
    steps_ = 0;
  }

  void put_in_order(Waiting& rows) {
    const auto begin = static_cast<std::ptrdiff_t>(rows.ordered);
    if (steps_ < 0) {
      std::reverse(rows.fixes.begin() + begin, rows.fixes.end());
      std::reverse(rows.lines.begin() + begin, rows.lines.end());
    }
    if (format_.time_form == TimeForm::local) {
      tell_utc(rows);
    }
    rows.ordered = rows.fixes.size();
  }

  /// Turns local times into UTC and leaves out those that the clocks skipped.
  void tell_utc(Waiting& rows) {
    std::size_t kept = rows.ordered;
    long long before = kept > 0    ? rows.fixes[kept - 1].time
                       : rows.last ? rows.last->time
                                   : std::numeric_limits<long long>::min();
    for (std::size_t i = kept; i < rows.fixes.size(); ++i) {
      const auto utc = format_.clock.utc_after(rows.fixes[i].time, before);
      if (!utc) {
        drop("at a local time that the clocks skipped", rows, i, std::to_string(rows.fixes[i].time));
        continue;
      }
      rows.fixes[kept] = rows.fixes[i];
      rows.lines[kept] = rows.lines[i];
      before = rows.fixes[kept++].time = *utc;
    }
    rows.resize(kept);
  }

  void pass_on(const std::string& vehicle, Waiting& rows, std::size_t keep) {
    const std::vector<std::size_t> drive = longest_drive(rows.fixes, rows.last);
    const std::size_t end = rows.fixes.size() - std::min(keep, rows.fixes.size());
    auto next = drive.begin();
    for (std::size_t i = 0; i < end; ++i) {
      if (next == drive.end() || *next != i) {
        explain(rows, i, next == drive.end() ? nullptr : &rows.fixes[*next]);
        continue;
      }
      const bool goes_on = rows.last && can_drive(*rows.last, rows.fixes[i]);
      rows.last = rows.fixes[i];
      ++count_.used;
      use_(vehicle, rows.fixes[i], goes_on);
      ++next;
    }
    // New vectors: a vehicle whose file is read needs no memory any more.
    rows.fixes = std::vector<Fix>(rows.fixes.begin() + static_cast<std::ptrdiff_t>(end), rows.fixes.end());
    rows.lines = std::vector<int>(rows.lines.begin() + static_cast<std::ptrdiff_t>(end), rows.lines.end());
    rows.ordered = rows.fixes.size();
  }

  /// Counts row `i`, which comes after rows.last and before `next`, where there is one.
  void explain(const Waiting& rows, std::size_t i, const Fix* next) {
    const Fix& fix = rows.fixes[i];
    const long long before = rows.last ? rows.last->time : std::numeric_limits<long long>::min();
    const long long after = next ? next->time : std::numeric_limits<long long>::max();
    const std::string time = std::to_string(fix.time);
    if (fix.time == before || fix.time == after) {
      drop("of the same time as another fix", rows, i, time);
    } else if (fix.time < before || fix.time > after) {
      drop(kDisordered, rows, i, time);
    } else {
      drop(kNoDrive, rows, i, decimal(fix.place.lat) + " " + decimal(fix.place.lon) + " at " + time);
    }
  }

  void drop(std::string_view reason, const Waiting& rows, std::size_t i, const std::string& value) {
    count_.dropped.add(reason, file_, rows.lines[i], value);
  }

  const GpsFormat& format_;
  const UseFix& use_;
  FixCount& count_;
  std::map<std::string, Waiting, std::less<>> vehicles_;
  decltype(vehicles_)::iterator at_ = vehicles_.end();
  std::string file_;
  std::size_t waiting_ = 0;
  std::size_t most_waiting_ = kFewWaiting;
  long long steps_ = 0;  ///< ahead in time, less those back, from a vehicle's row to its next
  bool backwards_ = false;
  long long disordered_before_ = 0;
  long long read_before_ = 0;
};

/// Reads the tables one after the other.
class Reader {
 public:
  Reader(const GpsFormat& format, const UseFix& use, const std::function<void(const FixProgress&)>& tell)
      : format_(format), rows_(format), sorter_(format, use, count), tell_(tell) {}

  void read(const std::filesystem::path& file, int files) {
    ++count.files;
    RawTable table(file, format_.table);
    sorter_.begin_file(file.string());
    if (!format_.vehicle) {
      sorter_.begin_vehicle(vehicle_of(file, format_));
    }
    tell_({count.files, files, count.read});
    RowTally tally(table, count.dropped);
    while (table.next()) {
      take(table, tally);
      if (++count.read % kTellEvery == 0) {
        tell_({count.files, files, count.read});
      }
    }
    tally.finish();
    sorter_.end_file();
  }

  FixCount count;

 private:
  void take(const RawTable& table, RowTally& tally) {
    Fix fix;
    if (!tally.keeps(rows_.read(table, fix))) {
      return;
    }
    if (format_.vehicle) {
      sorter_.begin_vehicle(table.text(*format_.vehicle));
    }
    sorter_.add(fix, table.line());
  }

  const GpsFormat& format_;
  FixRows rows_;
  Sorter sorter_;
  const std::function<void(const FixProgress&)>& tell_;
};

}  // namespace

FixCount for_each_fix(const std::filesystem::path& folder, const GpsFormat& format, const UseFix& use,
                      const std::function<void(const FixProgress&)>& tell) {
  const auto files = text_files(folder);
  Reader reader(format, use, tell);
  try {
    for (const auto& file : files) {
      reader.read(file, static_cast<int>(files.size()));
    }
    if (reader.count.used == 0) {
      throw bad_input(folder.string(), 0, "has no fix that counts");
    }
    if (reader.count.dropped.rows(kNoDrive) > reader.count.used) {
      throw bad_input(folder.string(), 0,
                      "has more fixes where or when no car can have driven than others; are the columns of place, time "
                      "and vehicle the right ones?");
    }
  } catch (const Error& error) {
    throw with_report(error, reader.count.dropped.report());
  }
  return std::move(reader.count);
}

}  // namespace evbal
