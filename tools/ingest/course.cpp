#include "tools/ingest/course.hpp"

#include "common/contract.hpp"
#include "tools/records/local_clock.hpp"

#include <cmath>

namespace evbal {
namespace {

bool is_workday(const DemandDay& day) {
  const auto midnight = parse_time(day.date + " 00:00:00");
  EVBAL_EXPECT(midnight, "a date");
  const long long weekday = (*midnight / (24 * 3600) + 4) % 7;  // 1970-01-01 was a Thursday; Sunday is 0
  return !day.holiday && weekday >= 1 && weekday <= 5;
}

/// Relative variance of the counts (regions x days) around each region's share of the day, less that of a Poisson law.
double excess_variance(const Eigen::MatrixXd& counts) {
  const Eigen::VectorXd share = counts.rowwise().sum() / counts.sum();
  const Eigen::MatrixXd expected = share * counts.colwise().sum();
  return ((counts - expected).squaredNorm() - expected.sum()) / expected.squaredNorm();
}

}  // namespace

Course course_of(const std::vector<DemandDay>& days, int regions) {
  EVBAL_EXPECT(!days.empty(), "at least one day");
  const auto steps = static_cast<Eigen::Index>(days.front().steps.size());
  Course course{Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(days.size()), steps), 0.0};
  Eigen::MatrixXd pickups(regions, 0);  // of the workdays
  for (std::size_t d = 0; d < days.size(); ++d) {
    Eigen::VectorXd of_day = Eigen::VectorXd::Zero(regions);
    for (Eigen::Index step = 0; step < steps; ++step) {
      for (const TripCount& pair : days[d].steps[step]) {
        course.share(static_cast<Eigen::Index>(d), step) += pair.trips;
        of_day[pair.origin] += pair.trips;
      }
    }
    if (is_workday(days[d])) {
      pickups.conservativeResize(regions, pickups.cols() + 1);
      pickups.rightCols(1) = of_day;
    }
  }
  const double mean_day = course.share.sum() / static_cast<double>(days.size());
  if (mean_day > 0.0) {
    course.share /= mean_day;
  }
  if (pickups.cols() > 1 && pickups.sum() > 0.0) {
    course.region_deviation = std::sqrt(std::max(0.0, excess_variance(pickups)));
  }
  return course;
}

}  // namespace evbal
