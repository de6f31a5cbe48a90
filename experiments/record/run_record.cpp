#include "experiments/record/run_record.hpp"

#include "agents/protocol/fingerprint.hpp"
#include "common/contract.hpp"
#include "common/error.hpp"
#include "common/files.hpp"
#include "experiments/record/csv.hpp"
#include "experiments/record/events.hpp"
#include "experiments/record/summary.hpp"

#include <algorithm>
#include <iterator>
#include <set>
#include <system_error>

namespace evbal {
namespace {

namespace fs = std::filesystem;

/// Whether a record can be made there: in a directory without files. That of the twin may be there already.
bool is_free(const fs::path& folder) {
  const fs::directory_iterator entries(folder);
  return std::all_of(begin(entries), end(entries), [](const auto& entry) { return entry.is_directory(); });
}

/// Makes `folder`, with its mark before anything else is in it, and says whether it was not there before.
bool prepare(const fs::path& folder) {
  std::error_code error;
  if (fs::exists(folder, error) && !(fs::is_directory(folder, error) && is_free(folder))) {
    throw bad_input(folder.string() + ": is there and not an empty directory; give a new one with --out");
  }
  const bool created = fs::create_directories(folder, error);
  if (error) {
    throw bad_input(folder.string() + ": cannot be made (" + error.message() + "); give another one with --out");
  }
  write_file(folder / "INCOMPLETE", "recorded nothing\n");
  return created;
}

void add_to(Digest& digest, const TickRecord& record) {
  fingerprint(digest, record.faults);
  for (const auto& report : record.exchange.reports) {
    fingerprint(digest, report);
  }
  if (record.exchange.plan) {
    fingerprint(digest, *record.exchange.plan);
  }
  for (const auto& said : record.exchange.departures) {
    fingerprint(digest, said);
  }
}

}  // namespace

std::string digest_of(const std::vector<TickRecord>& ticks) {
  Digest digest;
  for (const auto& record : ticks) {
    add_to(digest, record);
  }
  return digest.hex();
}

RunRecord::RunRecord(fs::path folder, RunHeader header)
    : folder_(std::move(folder)),
      header_(std::move(header)),
      created_folder_(prepare(folder_)),
      file_(folder_ / "run.sqlite", header_.region_names, header_.frame.points, header_.faults),
      start_(Clock::now()),
      last_(start_) {
  write_file(folder_ / "scenario.resolved.yaml", header_.resolved);
  mark_incomplete();
}

RunRecord::~RunRecord() {
  std::error_code ignored;
  if (finished_) {
    return;
  }
  if (ticks_.empty()) {
    for (const char* name : {"run.sqlite", "run.sqlite-journal", "scenario.resolved.yaml"}) {
      fs::remove(folder_ / name, ignored);
    }
    // What the processes of the run printed stays, and so does the mark.
    if (std::distance(fs::directory_iterator(folder_), {}) == 1) {
      fs::remove(folder_ / "INCOMPLETE", ignored);
      if (created_folder_) {
        fs::remove(folder_, ignored);
      }
    }
    return;
  }
  try {
    file_.commit();
    mark_incomplete();
  } catch (const std::exception&) {
    // The mark of the last step is still there.
  }
}

void RunRecord::mark_incomplete() const {
  const DayClock& clock = header_.frame.clock;
  const int done = static_cast<int>(ticks_.size());
  write_file(folder_ / "INCOMPLETE", "recorded " + std::to_string(done) + " of " + std::to_string(clock.ticks()) +
                                         " ticks, until " + time_of_day(clock, clock.minute_of(done)) + "\n");
}

void RunRecord::note_events(const TickRecord& record) {
  std::vector<std::string> names;
  for (const auto& fault : header_.faults) {
    names.push_back(fault.name);
  }
  for (const auto& [kind, what] : events_of(record, ticks_.empty() ? nullptr : &ticks_.back(), names)) {
    file_.event(record.tick.tick, kind, what);
  }
}

void RunRecord::add(const TickRecord& record) {
  EVBAL_EXPECT(record.tick.tick == static_cast<int>(ticks_.size()), "the tick after the last one");
  tick_seconds_.push_back(std::chrono::duration<double>(Clock::now() - last_).count());
  note_events(record);
  file_.add(record);
  add_to(digest_, record);
  ticks_.push_back(record);
  const DayClock& clock = header_.frame.clock;
  if (clock.minute_of(static_cast<int>(ticks_.size())) % clock.step == 0) {
    file_.commit();
    mark_incomplete();
  }
  last_ = Clock::now();
}

void RunRecord::amend(const std::string& resolved, const RequestedFault& fault) {
  file_.add_fault(header_.faults.size(), fault);
  header_.faults.push_back(fault);
  header_.resolved = resolved;
  write_file(folder_ / "scenario.resolved.yaml", resolved);
}

void RunRecord::break_off(const std::string& why) {
  try {
    file_.event(static_cast<int>(ticks_.size()), "run failed", why);
  } catch (const Error&) {
    // The file cannot be written, which may be why the run breaks off. The caller says so, and the mark stays.
  }
}

void RunRecord::note_not_injected() {
  std::set<int> injected;
  for (const auto& record : ticks_) {
    injected.merge(active_faults(record));
  }
  for (int fault = 0; fault < static_cast<int>(header_.faults.size()); ++fault) {
    if (!injected.contains(fault)) {
      file_.event(static_cast<int>(ticks_.size()), "fault not injected", header_.faults[fault].name);
    }
  }
}

void mark_complete(const fs::path& folder) {
  fs::remove(folder / "INCOMPLETE");
}

RunResult RunRecord::finish(const std::vector<ProcessLegs>& timings, const std::optional<CrossChecked>& cross_check) {
  const DayClock& clock = header_.frame.clock;
  EVBAL_EXPECT(static_cast<int>(ticks_.size()) == clock.ticks(), "every tick of the day");
  note_not_injected();
  file_.commit();
  const DayMetrics day = measure(header_.frame, ticks_);
  const RunResult result{.folder = folder_,
                         .controller = header_.controller,
                         .digest = digest_.hex(),
                         .totals = day.totals,
                         .fallbacks = count_fallbacks(ticks_),
                         .wall_seconds = std::chrono::duration<double>(last_ - start_).count(),
                         .cross_check = cross_check};
  write_file(folder_ / "steps.csv", steps_csv(clock, day));
  write_file(folder_ / "regions.csv", regions_csv(clock, day));
  write_file(folder_ / "summary.json", summary_json(header_, day, result, ticks_, tick_seconds_, timings));
  finished_ = true;
  return result;
}

}  // namespace evbal
