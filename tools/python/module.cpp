#include "common/error.hpp"
#include "common/heap.hpp"
#include "common/pin.hpp"
#include "common/suggestion.hpp"
#include "coordinator/balancing/controllers.hpp"
#include "experiments/run/stepped_controller.hpp"
#include "experiments/scenario/scenario.hpp"
#include "tools/python/arrays.hpp"
#include "tools/python/environment.hpp"
#include "tools/python/records.hpp"

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace evbal {
namespace {

namespace py = pybind11;

/// A plan, and how large a city it is for.
struct SizedPlan {
  Plan plan;
  int regions = 0;
};

/// A controller, and the day that it hears.
struct HearingController {
  std::shared_ptr<SteppedDay> day;
  SteppedController controller;
};

Environment open_environment(const std::string& scenario, const std::map<std::string, double>& reward,
                             const std::optional<std::string>& day, const std::optional<std::string>& faults,
                             const std::vector<std::string>& settings) {
  Overrides overrides;
  overrides.day = day;
  if (faults) {
    overrides.faults = *faults;
  }
  overrides.settings = settings;
  return {read_scenario(find_scenario(scenario), overrides), reward};
}

/// Throws Error{bad_input} if evbal has no controller of this name.
void check_controller(const std::string& name) {
  if (const auto wrong = validate_word(name, controller_names()); !wrong.empty()) {
    throw bad_input("controller: " + wrong);
  }
}

void bind_plan(py::module_& module) {
  py::class_<SizedPlan>(module, "Plan")
      .def_property_readonly("controller", [](const SizedPlan& p) { return p.plan.provenance.controller; })
      .def_property_readonly("fallback",
                             [](const SizedPlan& p) { return static_cast<int>(p.plan.provenance.fallback); })
      .def_property_readonly("objective", [](const SizedPlan& p) { return p.plan.provenance.objective; })
      .def("action", [](const SizedPlan& p) { return action_of(p.plan, p.regions); });
}

void bind_environment(py::module_& module) {
  py::class_<Environment>(module, "Environment")
      .def(py::init(&open_environment), py::arg("scenario"), py::arg("reward"), py::arg("day"), py::arg("faults"),
           py::arg("settings"))
      .def("begin", &Environment::begin, py::arg("seed"), py::arg("date"))
      .def("step",
           [](Environment& e, const SizedPlan& plan) {
             if (plan.plan.tick != e.day()->tick().tick) {
               throw bad_input("action: the plan is of another moment than the newest observation");
             }
             e.step(plan.plan);
           })
      .def("step",
           [](Environment& e, const py::array& action) {
             e.step(plan_within_reports(*e.day(), moves_of(action, e.scenario()), "own"));
           })
      .def("observation", [](const Environment& e) { return observation_of(*e.day()); })
      .def("info", &info_of)
      .def_property_readonly("over", [](const Environment& e) { return e.day()->over(); })
      .def_property_readonly("reward", &Environment::reward)
      .def_property_readonly("minute", [](const Environment& e) { return minute_of(*e.day()); })
      .def_property_readonly("seed", [](const Environment& e) { return e.scenario().world.seed; })
      .def_property_readonly("regions", [](const Environment& e) { return e.scenario().world.city.size(); })
      .def_property_readonly("vehicles", [](const Environment& e) { return e.scenario().world.city.fleet.vehicles; })
      .def_property_readonly("points",
                             [](const Environment& e) {
                               const Eigen::VectorXi points = e.scenario().world.city.points();
                               return py::array_t<int>(points.size(), points.data());
                             })
      .def_property_readonly("km", [](const Environment& e) { return table_of(e.scenario().world.city.km); })
      .def_property_readonly("travel_minutes",
                             [](const Environment& e) { return table_of(e.scenario().world.city.minutes); })
      .def_property_readonly("minutes", [](const Environment& e) { return e.scenario().world.clock.minutes(); })
      .def_property_readonly("days", [](const Environment& e) { return e.scenario().world.city.days; });
}

void bind_controller(py::module_& module) {
  py::class_<HearingController>(module, "Controller")
      .def(py::init([](const Environment& e, const std::string& name) {
             return std::unique_ptr<HearingController>(new HearingController{e.day(), {*e.day(), name}});
           }),
           py::arg("environment"), py::arg("name"))
      .def("plan",
           [](HearingController& c) {
             if (c.day->over()) {
               throw run_failed("controller: the day is over; begin another one by reset()");
             }
             return SizedPlan{c.controller.plan(), c.day->scenario().world.city.size()};
           })
      .def("hears", [](const HearingController& c, const Environment& e) { return c.day == e.day(); });
}

}  // namespace
}  // namespace evbal

PYBIND11_MODULE(_evbal, module) {
  evbal::keep_heap_pages();
  pybind11::register_exception<evbal::Error>(module, "Error", PyExc_RuntimeError);
  evbal::bind_plan(module);
  evbal::bind_environment(module);
  evbal::bind_controller(module);
  module.def("reward_metrics", &evbal::reward_metrics);
  module.def("observation_names", &evbal::observation_names);
  module.def("controller_names", &evbal::controller_names);
  module.def("check_controller", &evbal::check_controller);
  module.def("read_run", &evbal::run_of);
  module.def("read_sweep", &evbal::sweep_of);
  module.attr("pinned_environment") = [] {
    std::map<std::string, std::string> variables(evbal::pinned_environment.begin(), evbal::pinned_environment.end());
    return pybind11::cast(variables);
  }();
}
