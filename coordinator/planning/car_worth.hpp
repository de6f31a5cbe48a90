#pragma once

#include "coordinator/balancing/problem.hpp"
#include "coordinator/planning/city_model.hpp"

namespace evbal {

/// What a car is worth at the end of the slots of `data.freed`, which start at `minute` after midnight, on a day of
/// this kind, by the model's values: of one that is vacant then, and of one that takes a passenger then, is free again
/// `flow_pickup` and the minutes of the way later where the region's trips go, and is not low on battery. None, if the
/// model has no values.
CarWorth car_worth(const PlanningData& data, const CityModel& model, DayKind kind, int minute,
                   const BalancingParameters& parameters);

}  // namespace evbal
