#include "tools/gps/fix_rows.hpp"

#include "tools/records/raw_numbers.hpp"
#include "tools/records/record_place.hpp"
#include "tools/records/text_lines.hpp"

#include <algorithm>
#include <limits>

namespace evbal {
namespace {

/// Whether a name needs no quotes in a table.
bool is_plain(std::string_view name) {
  return !name.empty() &&
         std::all_of(name.begin(), name.end(), [](char c) { return c > ' ' && c <= '~' && c != ',' && c != '"'; });
}

const char* unreadable_time(std::string_view text, TimeForm form) {
  if (form != TimeForm::unix_seconds) {
    return "no time like 2008-05-18 07:31:05";
  }
  return raw_integer(text).value_or(0) > 0 ? "no unix time in seconds; milliseconds?" : "no unix time in seconds";
}

}  // namespace

FixRows::FixRows(const GpsFormat& format)
    : format_(format),
      occupied_number_(raw_integer(format.occupied_word)),
      free_number_(raw_integer(format.free_word)),
      no_flag_("neither `" + format.occupied_word + "` (occupied) nor `" + format.free_word + "` (free)") {}

RowFault FixRows::read(const RawTable& row, Fix& fix) const {
  if (!row.whole()) {
    return row.fault();
  }
  if (format_.vehicle && !is_plain(row.text(*format_.vehicle))) {
    return {"no vehicle's name without blanks, commas and quotes", row.text(*format_.vehicle)};
  }
  if (const RowFault fault = read_place(row, format_.lat, format_.lon, fix.place)) {
    return fault;
  }
  const std::string_view flag = row.text(format_.occupied);
  const auto is = [&](const std::string& word, std::optional<long long> number) {
    return flag == word || (number && raw_integer(flag) == number);
  };
  fix.occupied = is(format_.occupied_word, occupied_number_);
  if (!fix.occupied && !is(format_.free_word, free_number_)) {
    return {no_flag_, flag};
  }
  const std::string_view time = row.text(format_.time);
  const TimeForm form = format_.time_form == TimeForm::local ? TimeForm::utc : format_.time_form;
  if (read_record_time(time, form, format_.clock, std::numeric_limits<long long>::min(), fix.time) !=
      TimeReading::done) {
    return {unreadable_time(time, form), time};
  }
  if (fix.place.lat == 0.0 && fix.place.lon == 0.0) {
    return {"at 0,0, which receivers write that know no place", time, false};
  }
  return {};
}

std::string vehicle_of(const std::filesystem::path& file, const GpsFormat& format) {
  const std::string name = without_packing(file.filename()).string();
  const std::size_t around = format.file_prefix.size() + format.file_suffix.size();
  if (name.size() <= around || !name.starts_with(format.file_prefix) || !name.ends_with(format.file_suffix)) {
    throw bad_input(
        file.string(), 0,
        "is not named like `" + format.file_prefix + "*" + format.file_suffix + "`, which tells the vehicle");
  }
  return name.substr(format.file_prefix.size(), name.size() - around);
}

}  // namespace evbal
