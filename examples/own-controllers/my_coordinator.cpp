// A coordinator with two controllers more than evbal's own.

#include "coordinator/serving/run_coordinator.hpp"

namespace {

using namespace evbal;

// `nominal` that counts those who wait now as passengers of the first step: own demand, in a problem that evbal has.
BalancingResult attentive(const BalancingParameters& parameters, PlanningData data, const EngineSettings& engine) {
  data.demand.mean.head(data.km.rows()) += data.state.waiting;
  return optimum({.shortage = Shortage::band})(parameters, data, engine);
}

// Passengers wait the longer, the fewer vehicles there are:  r_hat_i^2 / (S_i + 1)  in every region, an own shortage.
void wait(int k, const Variables& S, const UncertaintyModel& model, ConvexProgram& program) {
  for (int i = 0; i < S.size(); ++i) {
    const double r_hat = model.r_hat(i, k);
    if (r_hat > 0.0) {
      program.minimise_curve("wait", r_hat * r_hat, S[i], inverse_power(1.0, 1.0), {"wait", k, i});
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  return run_coordinator(argc, argv,
                         {{"attentive", attentive}, {"wait", optimum({.shortage = Shortage::own, .own = wait})}});
}
