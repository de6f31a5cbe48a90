#include "coordinator/planning/announced.hpp"

namespace evbal {
namespace {

constexpr double least_factor = 0.1;  ///< that still shows the usual demand

}  // namespace

Eigen::VectorXd AnnouncedDemand::as_usual(const Eigen::VectorXd& counts, int minutes) const {
  const Eigen::ArrayXd own = counts - added * minutes;
  const Eigen::ArrayXd usual = (own < 0.0).select(0.0, own) / factor.array().max(least_factor);
  return (factor.array() < least_factor).select(counts.array(), usual);
}

Eigen::MatrixXd AnnouncedDemand::as_announced(const Eigen::MatrixXd& usual, int minutes) const {
  return (factor.asDiagonal() * usual).colwise() + added * minutes;
}

AnnouncedDemand announced_demand(const std::vector<Effect>& effects, int regions) {
  AnnouncedDemand told{Eigen::VectorXd::Ones(regions), Eigen::VectorXd::Zero(regions)};
  for (const Effect& effect : effects) {
    if (effect.visible && effect.type == EffectType::demand_scale) {
      told.factor(effect.region) *= effect.magnitude;
    }
    if (effect.visible && effect.type == EffectType::demand_add) {
      told.added(effect.region) += effect.magnitude / 60.0;
    }
  }
  return told;
}

}  // namespace evbal
