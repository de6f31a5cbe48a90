#include "coordinator/planning/car_worth.hpp"

#include "coordinator/planning/freed_cars.hpp"

namespace evbal {

CarWorth car_worth(const PlanningData& data, const CityModel& model, DayKind kind, int minute,
                   const BalancingParameters& parameters) {
  if (model.car_values[static_cast<std::size_t>(kind)].size() == 0) {
    return {};
  }
  const Eigen::Index n = data.km.rows();
  const Eigen::VectorXd fit = share_fit(data);
  const double end = minute + static_cast<double>(data.freed.mean.cols() * parameters.flow_slot);
  CarWorth worth{Eigen::VectorXd::Zero(n), Eigen::VectorXd::Zero(n)};
  for (int i = 0; i < n; ++i) {
    worth.vacant(i) = model.car_value(kind, i, end);
  }
  for (const auto& [from, to, share] : model.trips_at(minute)) {
    const double free_again = end + parameters.flow_pickup + data.minutes(from, to);
    worth.serving(from) += share * fit(to) * model.car_value(kind, to, free_again);
  }
  return worth;
}

}  // namespace evbal
