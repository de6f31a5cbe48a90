#include "experiments/run/stepped_controller.hpp"

#include "agents/protocol/origin.hpp"
#include "common/contract.hpp"
#include "common/error.hpp"
#include "common/suggestion.hpp"
#include "coordinator/balancing/controllers.hpp"
#include "coordinator/planning/report_check.hpp"
#include "experiments/run/record_day.hpp"
#include "experiments/run/scenario_planner.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

namespace evbal {
namespace {

Scenario planned_by(const Scenario& scenario, const std::string& controller) {
  if (const auto wrong = validate_word(controller, controller_names()); !wrong.empty()) {
    throw bad_input("controller: " + wrong);
  }
  return with_controller(scenario, controller);
}

ReportBounds report_bounds(const World& world) {
  const Eigen::VectorXi points = world.city.points();
  return {world.city.fleet.vehicles, {points.begin(), points.end()}, world.clock};
}

/// Takes up to `asked` from what is left.
std::int32_t take(std::int32_t asked, std::int32_t& left) {
  const std::int32_t taken = std::clamp(asked, 0, left);
  left -= taken;
  return taken;
}

}  // namespace

SteppedController::SteppedController(const SteppedDay& day, const std::string& name)
    : day_(day), planner_(planner_of(planned_by(day.scenario(), name))) {}

void SteppedController::catch_up() {
  const auto& planned = day_.planned();
  for (; heard_ < planned.size(); ++heard_) {
    if (!plan_) {
      planner_->hear(planned[heard_].tick, planned[heard_].reports);
    }
    planner_->follow(planned[heard_].moves);
    plan_.reset();
  }
}

Plan SteppedController::plan() {
  EVBAL_EXPECT(!day_.over(), "a day that is not over");
  catch_up();
  if (!plan_) {
    plan_ = with_origin([&] { return planner_->plan(day_.tick(), day_.reports()); });
  }
  return *plan_;
}

Plan plan_within_reports(const SteppedDay& day, std::vector<Move> moves, const std::string& controller) {
  const World& world = day.scenario().world;
  const int last = day.planned().empty() ? 0 : day.planned().back().tick.tick;
  CheckedReports checked = check_reports(day.reports(), day.tick().tick, last, report_bounds(world));
  std::ranges::sort(moves, {}, [](const Move& move) { return std::tuple(move.errand, move.from, move.to); });
  for (Move& move : moves) {
    auto& report = checked.good[static_cast<std::size_t>(move.from)];
    if (!report) {
      continue;
    }
    const bool tops_up = move.errand == Errand::charge && move.from == move.to;
    if (tops_up) {
      move.count = take(std::min(move.count, report->chargeable), report->vacant);
    } else {
      move.count = take(move.count, move.errand == Errand::charge ? report->low_battery : report->vacant);
    }
  }
  std::erase_if(moves, [](const Move& move) { return move.count == 0; });
  Plan plan{.tick = day.tick().tick, .moves = std::move(moves), .provenance = {}, .origin = {}};
  plan.provenance.controller = controller;
  plan.provenance.rejected = std::move(checked.rejected);
  return plan;
}

}  // namespace evbal
