#include "tools/gps/transition_table.hpp"

#include "common/decimal.hpp"
#include "common/files.hpp"
#include "common/table_text.hpp"

#include <array>
#include <numeric>
#include <sstream>

namespace evbal {
namespace {

constexpr double kPriorCars = 50.0;

std::string time_of_day(int minute) {
  const auto two = [](int number) { return (number < 10 ? "0" : "") + std::to_string(number); };
  return two(minute / 60) + ":" + two(minute % 60);
}

/// The rows of one period, and how many of them are thin.
class PeriodRows {
 public:
  explicit PeriodRows(const std::vector<Region>& regions) : regions_(regions) {}

  /// Adds the row of `region` in `state`: shares of becoming each of `next`.
  void add(const std::string& from, Eigen::Index region, const char* state, double cars,
           const std::vector<std::pair<const char*, const Eigen::MatrixXd*>>& next) {
    ++rows;
    thin += cars < kPriorCars ? 1 : 0;
    for (const auto& [becomes, shares] : next) {
      for (Eigen::Index i = 0; i < shares->cols(); ++i) {
        if ((*shares)(region, i) > 0.0) {
          text += csv_row({from, regions_[region].name, state, decimal(std::llround(cars)), becomes, regions_[i].name,
                           decimal((*shares)(region, i))});
        }
      }
    }
  }

  std::string text = "from,region,state,cars,becomes,in_region,share\n";
  int rows = 0;
  int thin = 0;

 private:
  const std::vector<Region>& regions_;
};

}  // namespace

std::string write_transitions(const TransitionCounter& counter, const std::vector<Region>& regions,
                              const std::filesystem::path& file) {
  const auto& periods = counter.periods();
  const TransitionCounts none(static_cast<int>(regions.size()));
  const TransitionCounts day = std::accumulate(periods.begin(), periods.end(), none,
                                               [](TransitionCounts sum, const auto& one) { return sum += one; });
  PeriodRows out(regions);
  for (std::size_t p = 0; p < periods.size(); ++p) {
    const std::string from = time_of_day(TransitionCounter::period_starts()[p]);
    const Transitions shares = transitions_of(periods[p], day, kPriorCars);
    for (Eigen::Index region = 0; region < day.vacant.rows(); ++region) {
      out.add(from, region, "vacant", periods[p].vacant.row(region).sum(),
              {{"vacant", &shares.vacant_to_vacant},
               {"occupied", &shares.vacant_to_occupied},
               {"low_battery", &shares.vacant_to_low_battery}});
      out.add(from, region, "occupied", periods[p].occupied.row(region).sum(),
              {{"vacant", &shares.occupied_to_vacant}, {"occupied", &shares.occupied_to_occupied}});
    }
  }
  write_file(file, out.text);
  std::ostringstream report;
  report << "transitions counted: " << std::llround(day.vacant.sum() + day.occupied.sum()) << "\n"
         << "  rows of fewer than " << kPriorCars << " cars, drawn towards the day's mean: " << out.thin << " of "
         << out.rows << "\n";
  return report.str();
}

}  // namespace evbal
