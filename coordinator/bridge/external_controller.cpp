#include "coordinator/bridge/external_controller.hpp"

#include "agents/hosting/child_process.hpp"
#include "common/error.hpp"
#include "coordinator/balancing/controllers.hpp"
#include "coordinator/bridge/json_lines.hpp"
#include "coordinator/bridge/library_controller.hpp"
#include "coordinator/planning/coordinator_command.hpp"

#include <algorithm>
#include <utility>

namespace evbal {
namespace {

/// Only a program on evbal's libraries, which says what made a plan, may take a name of theirs.
void check_name(const std::string& controller) {
  if (std::ranges::find(controllers(), controller, &Controller::name) != controllers().end()) {
    throw bad_input("`" + controller + "` is a controller of evbal's own; name yours by --controller NAME");
  }
}

/// A child process that speaks in lines of JSON.
class LineController : public ExternalController {
 public:
  LineController(const World& world, const PlanningSettings& settings, const std::string& scenario, int errors)
      : city_(world.city), name_(settings.controller), child_(own_words(settings.coordinator), errors) {
    child_.write(opening_line(world, settings, scenario));
  }

  Plan plan(const Tick& tick, const std::vector<Report>& reports) override {
    child_.write(question_line(tick, reports));
    const std::string answer = child_.read("the plan of tick " + std::to_string(tick.tick));
    Plan plan = read_answer(answer, child_.place(), reports, city_);
    if (plan.provenance.controller.empty()) {
      check_name(name_);
      plan.provenance.controller = name_;
    }
    plan.tick = tick.tick;
    return plan;
  }

  void end() override { child_.end(); }

 private:
  const City& city_;
  std::string name_;
  ChildProcess child_;
};

}  // namespace

std::unique_ptr<ExternalController> start_controller(const World& world, const PlanningSettings& settings,
                                                     const std::string& scenario, int errors) {
  if (is_library(own_words(settings.coordinator))) {
    check_name(settings.controller);
    return load_library(world, settings);
  }
  return std::make_unique<LineController>(world, settings, scenario, errors);
}

}  // namespace evbal
