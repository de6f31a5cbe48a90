#pragma once

#include "coordinator/planning/city_model.hpp"

#include <array>
#include <utility>

/// What both who writes a model file and who reads it have to know.
namespace evbal::model_keys {

/// Of the file.
inline constexpr int schema = 5;

/// Keys of kinds of days, by DayKind.
inline constexpr std::array<const char*, day_kinds> kind_names{"weekday", "saturday", "sunday"};

/// A key of a period, and what stands there.
using TransitionKey = std::pair<const char*, Eigen::MatrixXd Transitions::*>;
/// Of a period.
inline constexpr std::array<TransitionKey, 5> transition_keys{{
    {"vacant_to_vacant", &Transitions::vacant_to_vacant},
    {"vacant_to_occupied", &Transitions::vacant_to_occupied},
    {"vacant_to_low_battery", &Transitions::vacant_to_low_battery},
    {"occupied_to_vacant", &Transitions::occupied_to_vacant},
    {"occupied_to_occupied", &Transitions::occupied_to_occupied},
}};

}  // namespace evbal::model_keys
