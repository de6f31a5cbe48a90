#pragma once

#include "agents/protocol/tick_record.hpp"
#include "faults/schedule/schedule.hpp"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace evbal {

/// A fault as requested, for the record.
struct RequestedFault {
  std::string name;  ///< of the fault
  std::string type;  ///< in a schedule's words
  int start = 0;     ///< minute
  int end = 0;       ///< minute
};

/// A fault of a schedule, as it is recorded.
RequestedFault requested(const Fault& fault);

/// Writes run.sqlite: everything that was said in a day, in tables named after the messages, with one column per
/// number, enum or text of the message and the names of its fields. A field that is itself a message gives columns
/// `<field>_<part>`; `from` and `to`, which SQL reserves, are `from_region` and `to_region`; a list of numbers is a
/// text of them, separated by spaces.
///
///     regions     region, name, points                       as installed
///     faults      fault, name, type, start, end              requested: the resolved schedule, in minutes
///     injector    tick, ...                                  who said the effects of the tick
///     effects     tick, seq, fault, type, region, ...        requested, tick by tick, as the injector said
///     observed    tick, region, seq, fault, amount, evicted  what each fault was seen to do
///     reports     tick, region, vacant, ..., bound, ...      bound: "minute:errand:count" of the cars on their way
///     plans       tick, provenance_controller, ...
///     moves       tick, seq, from_region, to_region, count, errand      what plans ask for
///     plan_costs  tick, seq, term, cost                      the plan's objective by term
///     rejections  tick, seq, region, reason                  reports that the plan was not made from
///     sensor_flags  tick, seq, region, field, kind, reported, estimate, isolated   fields that were found to lie
///     innovations   tick, seq, field, counts, squares, within, expected_within     how well reports were foreseen
///     departures  tick, region, refused, demand, ...         what became of the region in the tick
///     vehicles    tick, region, seq, minute, to_region, errand, vehicle_id, km, ...      who set off
///     fates       tick, region, seq, appeared, waited, served, ...      passengers
///     events      tick, seq, kind, what                      a fault begins or ends, a plan falls back, a report is
///                                                            rejected, a process ended unasked or is back, a host
///                                                            is gone
///
/// `seq` counts the like entries of one message. Columns `origin_process_id` and `origin_seconds` of
/// injector, reports, plans and departures name the writer of a message and its CPU seconds. They, and events of the
/// kinds "process ...", "host gone", "sample refused" and "stranger kept out", may differ between two runs; nothing
/// else does.
///
/// All members throw Error{run_failed} if the file cannot be written.
class DayFile {
 public:
  /// Creates the file, which must not exist.
  DayFile(const std::filesystem::path& file, const std::vector<std::string>& region_names,
          const std::vector<int>& points, const std::vector<RequestedFault>& faults);
  ~DayFile();

  /// Adds a tick; it is durable after the next commit().
  void add(const TickRecord& record);

  /// Adds a fault that was asked for while the day went on, at this position of the schedule.
  void add_fault(std::size_t position, const RequestedFault& fault);

  /// Notes an event of a tick.
  void event(int tick, const std::string& kind, const std::string& what);

  /// Ends the transaction that is open and begins another.
  void commit();

 private:
  struct Tables;
  static std::unique_ptr<Tables> created_tables(const std::filesystem::path& file);
  std::unique_ptr<Tables> tables_;
};

}  // namespace evbal
