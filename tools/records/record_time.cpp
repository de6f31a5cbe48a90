#include "tools/records/record_time.hpp"

#include "tools/records/raw_numbers.hpp"

namespace evbal {
namespace {

constexpr long long kLastSecond = 253'402'300'799;  // year 9999

}  // namespace

TimeForm read_time_form(YamlMap& map) {
  return static_cast<TimeForm>(map.require("time").one_of({"unix", "utc", "local"}));
}

std::string_view example_of(TimeForm form) {
  return form == TimeForm::unix_seconds ? "number of seconds since 1970, such as 1211095865"
                                        : "time written as 2008-05-18 07:31:05";
}

std::optional<long long> parse_unix_seconds(std::string_view text) {
  const auto seconds = raw_integer(text);
  return seconds && *seconds >= 0 && *seconds <= kLastSecond ? seconds : std::nullopt;
}

TimeReading read_record_time(std::string_view text, TimeForm form, const LocalClock& clock, long long after,
                             long long& time) {
  const auto shown = form == TimeForm::unix_seconds ? parse_unix_seconds(text) : parse_time(text);
  if (!shown || *shown < 0) {
    return TimeReading::unreadable;
  }
  if (form != TimeForm::local) {
    time = *shown;
    return TimeReading::done;
  }
  const auto utc = clock.utc_after(*shown, after);
  if (!utc) {
    return TimeReading::skipped;
  }
  time = *utc;
  return TimeReading::done;
}

}  // namespace evbal
