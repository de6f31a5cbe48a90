#include "tools/gps/fixes.hpp"

#include "agents/world/pack_table.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace evbal {
namespace {

constexpr long long kTellEvery = 100'000;  // rows
constexpr long long kRowsToJudge = 100;    // if so many first rows are malformed, the format is wrong

using LastTimes = std::map<std::string, long long, std::less<>>;  ///< of each vehicle's last fix

/// The vehicle that a file is named after.
std::string vehicle_of(const std::filesystem::path& file, const GpsFormat& format) {
  std::string name = file.filename().string();
  for (const std::string packed : {".gz", ".xz"}) {
    if (name.ends_with(packed)) {
      name.resize(name.size() - packed.size());
      break;
    }
  }
  const std::size_t around = format.file_prefix.size() + format.file_suffix.size();
  if (name.size() <= around || !name.starts_with(format.file_prefix) || !name.ends_with(format.file_suffix)) {
    throw bad_input(
        file.string(), 0,
        "is not named like `" + format.file_prefix + "*" + format.file_suffix + "`, which tells the vehicle");
  }
  return name.substr(format.file_prefix.size(), name.size() - around);
}

/// Whether a name needs no quotes in a table.
bool is_plain(std::string_view name) {
  return !name.empty() &&
         std::all_of(name.begin(), name.end(), [](char c) { return c > ' ' && c <= '~' && c != ',' && c != '"'; });
}

/// Reads the rows of one file.
class FixReader {
 public:
  FixReader(const GpsFormat& format, LastTimes& last) : format_(format), last_(last) {}

  /// The vehicle of the rows that follow.
  void begin_vehicle(std::string_view name) {
    if (at_ == last_.end() || at_->first != name) {
      at_ = last_.find(name);
      if (at_ == last_.end()) {
        at_ = last_.emplace(name, std::numeric_limits<long long>::min()).first;
      }
    }
  }

  const std::string& vehicle() const { return at_->first; }

  /// Null if `fix` was filled in, else the reason.
  const char* read(const RawTable& row, Fix& fix) {
    if (!row.whole()) {
      return malformed_row;
    }
    if (format_.vehicle) {
      const std::string_view name = row.text(*format_.vehicle);
      if (!is_plain(name)) {
        return malformed_row;
      }
      begin_vehicle(name);
    }
    const auto lat = parse_number(row.text(format_.lat));
    const auto lon = parse_number(row.text(format_.lon));
    const std::string_view flag = row.text(format_.occupied);
    if (!lat || !lon || std::abs(*lat) > 90.0 || std::abs(*lon) > 180.0 ||
        (flag != format_.occupied_word && flag != format_.free_word)) {
      return malformed_row;
    }
    if (const char* reason =
            read_record_time(row.text(format_.time), format_.time_form, format_.clock, at_->second, fix.time)) {
      return reason;
    }
    if (fix.time <= at_->second) {
      return fix.time == at_->second ? "same time as the fix before" : "older than the fix before";
    }
    at_->second = fix.time;
    fix.place = {*lat, *lon};
    fix.occupied = flag == format_.occupied_word;
    return nullptr;
  }

 private:
  const GpsFormat& format_;
  LastTimes& last_;
  LastTimes::iterator at_ = last_.end();
};

}  // namespace

FixCount for_each_fix(const std::filesystem::path& folder, const GpsFormat& format,
                      const std::function<void(const std::string& vehicle, const Fix&)>& use,
                      const std::function<void(const FixProgress&)>& tell) {
  const auto files = text_files(folder);
  FixCount count;
  LastTimes last;
  for (const auto& file : files) {
    ++count.files;
    RawTable table(file, format.table);
    FixReader reader(format, last);
    if (!format.vehicle) {
      reader.begin_vehicle(vehicle_of(file, format));
    }
    tell({count.files, static_cast<int>(files.size()), count.read});
    long long rows = 0;
    long long malformed = 0;
    Fix fix;
    while (table.next()) {
      ++rows;
      ++count.read;
      if (const char* reason = reader.read(table, fix)) {
        ++count.dropped[reason];
        malformed += std::string_view(reason) == malformed_row ? 1 : 0;
        if (rows == kRowsToJudge && malformed == rows) {
          throw table.error("and all rows before it are malformed; is the description of this table?");
        }
      } else {
        use(reader.vehicle(), fix);
      }
      if (count.read % kTellEvery == 0) {
        tell({count.files, static_cast<int>(files.size()), count.read});
      }
    }
  }
  return count;
}

}  // namespace evbal
