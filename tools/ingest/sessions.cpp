#include "tools/ingest/sessions.hpp"

#include "agents/world/pack_table.hpp"
#include "common/contract.hpp"
#include "common/table_text.hpp"
#include "tools/records/text_lines.hpp"

#include <algorithm>
#include <chrono>
#include <optional>

namespace evbal {
namespace {

/// Minutes since 1970 of "dd/mm/yyyy", "hh:mm".
std::optional<long long> parse_minute(const std::string& date, const std::string& time) {
  if (date.size() != 10 || date[2] != '/' || date[5] != '/' || time.size() != 5 || time[2] != ':') {
    return std::nullopt;
  }
  const auto day = parse_integer(date.substr(0, 2));
  const auto month = parse_integer(date.substr(3, 2));
  const auto year = parse_integer(date.substr(6));
  const auto hour = parse_integer(time.substr(0, 2));
  const auto minute = parse_integer(time.substr(3));
  if (!day || !month || !year || !hour || !minute) {
    return std::nullopt;
  }
  const std::chrono::year_month_day calendar(std::chrono::year(static_cast<int>(*year)),
                                             std::chrono::month(static_cast<unsigned>(*month)),
                                             std::chrono::day(static_cast<unsigned>(*day)));
  if (!calendar.ok()) {
    return std::nullopt;
  }
  return std::chrono::sys_days(calendar).time_since_epoch().count() * 24LL * 60LL + *hour * 60 + *minute;
}

struct Columns {
  std::size_t start_date = 0;
  std::size_t start_time = 0;
  std::size_t end_date = 0;
  std::size_t end_time = 0;
  std::size_t model = 0;
  std::size_t count = 0;
};

/// Nothing if the table is not one of sessions.
std::optional<Columns> find_columns(const std::vector<std::string>& header) {
  Columns columns;
  columns.count = header.size();
  const std::vector<std::pair<std::string, std::size_t*>> wanted{{"Start Date", &columns.start_date},
                                                                 {"Start Time", &columns.start_time},
                                                                 {"End Date", &columns.end_date},
                                                                 {"End Time", &columns.end_time},
                                                                 {"Model", &columns.model}};
  for (const auto& [name, column] : wanted) {
    const auto found = std::find(header.begin(), header.end(), name);
    if (found == header.end()) {
      return std::nullopt;
    }
    *column = static_cast<std::size_t>(found - header.begin());
  }
  return columns;
}

}  // namespace

SessionSample read_sessions(const std::filesystem::path& folder, const std::string& model, double shortest,
                            double longest) {
  SessionSample sample;
  std::string line;
  for (const auto& file : csv_files(folder)) {
    LineReader lines(file);
    const auto columns = lines.next(line) ? find_columns(split_csv(line)) : std::nullopt;
    while (columns && lines.next(line)) {
      const auto fields = split_csv(line);
      ++sample.read;
      if (fields.size() != columns->count) {
        ++sample.unfinished;
        continue;
      }
      if (fields[columns->model].find(model) == std::string::npos) {
        ++sample.other_model;
        continue;
      }
      const auto start = parse_minute(fields[columns->start_date], fields[columns->start_time]);
      const auto end = parse_minute(fields[columns->end_date], fields[columns->end_time]);
      if (!start || !end) {
        ++sample.unfinished;
        continue;
      }
      const auto minutes = static_cast<double>(*end - *start);
      if (minutes < shortest || minutes > longest) {
        ++sample.out_of_range;
        continue;
      }
      sample.minutes.push_back(minutes);
    }
  }
  if (sample.minutes.empty()) {
    throw bad_input(folder.string(), 0, "has no session of a charger of model `" + model + "` and of allowed length");
  }
  std::sort(sample.minutes.begin(), sample.minutes.end());
  return sample;
}

std::vector<double> quantiles(const std::vector<double>& ascending, int n) {
  EVBAL_EXPECT(!ascending.empty() && n >= 2, "at least one value and two quantiles");
  std::vector<double> values;
  for (int q = 0; q < n; ++q) {
    const double at = static_cast<double>(ascending.size() - 1) * q / (n - 1);
    const auto below = static_cast<std::size_t>(at);
    const std::size_t above = std::min(below + 1, ascending.size() - 1);
    const double share = at - static_cast<double>(below);
    values.push_back((1.0 - share) * ascending[below] + share * ascending[above]);
  }
  return values;
}

}  // namespace evbal
