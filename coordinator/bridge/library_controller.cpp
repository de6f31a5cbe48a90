#include "coordinator/bridge/library_controller.hpp"

#include "common/decimal.hpp"
#include "common/error.hpp"
#include "coordinator/bridge/evbal_controller.h"
#include "coordinator/bridge/json_lines.hpp"
#include "coordinator/bridge/move_check.hpp"
#include "coordinator/planning/coordinator_command.hpp"

#include <dlfcn.h>

#include <cstdint>
#include <limits>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

namespace evbal {
namespace {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Names a controller's answers for messages.
std::string place_of(const Command& words, int answer) {
  return "plan " + std::to_string(answer) + " of `" + shown(words) + "`";
}

struct Close {
  void operator()(void* library) const { dlclose(library); }
};

/// A function of the library.
template <class Function>
Function* find(void* library, const char* name, const Command& words) {
  void* const found = dlsym(library, name);
  if (found == nullptr) {
    throw bad_input("`" + shown(words) + "` has no function `" + name +
                    "`; evbal_controller.h says what it is to define");
  }
  return reinterpret_cast<Function*>(found);
}

std::string text_of(const std::variant<bool, double, std::string>& value) {
  if (const auto* const number = std::get_if<double>(&value)) {
    return decimal(*number);
  }
  const auto* const text = std::get_if<std::string>(&value);
  return text != nullptr ? *text : std::get<bool>(value) ? "true" : "false";
}

double number_of(const std::variant<bool, double, std::string>& value) {
  if (const auto* const number = std::get_if<double>(&value)) {
    return *number;
  }
  const auto* const truth = std::get_if<bool>(&value);
  return truth != nullptr ? static_cast<double>(*truth) : std::numeric_limits<double>::quiet_NaN();
}

/// What a report's pointers lead to.
struct Reports {
  std::vector<std::vector<evbal_bound>> bound;
  std::vector<evbal_report> all;

  explicit Reports(const std::vector<Report>& reports) {
    for (const Report& report : reports) {
      auto& cars = bound.emplace_back();
      for (const UnderWay& under_way : report.bound) {
        cars.push_back({under_way.minute, static_cast<std::int32_t>(under_way.errand), under_way.count});
      }
    }
    for (std::size_t i = 0; i < reports.size(); ++i) {
      all.push_back(as_c(reports[i], bound[i]));
    }
  }

 private:
  static evbal_report as_c(const Report& report, const std::vector<evbal_bound>& cars) {
    return {.region = report.region,
            .vacant = report.vacant,
            .low_battery = report.low_battery,
            .plugged = report.plugged,
            .points = report.points,
            .waiting = report.waiting,
            .demand = report.demand,
            .completions = report.completions,
            .chargeable = report.chargeable,
            .plugged_count = static_cast<std::int32_t>(report.plugged_since.size()),
            .plugged_since = report.plugged_since.data(),
            .reach_count = static_cast<std::int32_t>(report.reach_m.size()),
            .reach_m = report.reach_m.data(),
            .bound_count = static_cast<std::int32_t>(cars.size()),
            .bound = cars.data()};
  }
};

std::vector<evbal_effect> as_c(const std::vector<Effect>& effects) {
  std::vector<evbal_effect> all;
  for (const Effect& effect : effects) {
    all.push_back({static_cast<std::int32_t>(effect.type), effect.region, effect.magnitude});
  }
  return all;
}

class LibraryController : public ExternalController {
 public:
  LibraryController(const World& world, const PlanningSettings& settings)
      : world_(world),
        name_(settings.controller),
        words_(own_words(settings.coordinator)),
        library_(open(words_)),
        plan_(find<decltype(evbal_plan)>(library_.get(), "evbal_plan", words_)),
        destroy_(find<decltype(evbal_destroy)>(library_.get(), "evbal_destroy", words_)),
        moves_(static_cast<std::size_t>(2 * world.city.size() * world.city.size())) {
    controller_ = create(settings);
    if (controller_ == nullptr) {
      throw run_failed("`" + shown(words_) + "`: evbal_create made no controller");
    }
  }

  ~LibraryController() override {
    if (controller_ != nullptr) {
      destroy_(controller_);
    }
  }
  LibraryController(const LibraryController&) = delete;
  LibraryController& operator=(const LibraryController&) = delete;

  Plan plan(const Tick& tick, const std::vector<Report>& reports) override {
    const std::string place = place_of(words_, ++answers_);
    const Reports said(reports);
    const std::vector<evbal_effect> effects = as_c(told_effects(tick));
    const evbal_question question{.tick = tick.tick,
                                  .minute = world_.clock.minute_of(tick.tick),
                                  .report_count = static_cast<std::int32_t>(said.all.size()),
                                  .reports = said.all.data(),
                                  .effect_count = static_cast<std::int32_t>(effects.size()),
                                  .effects = effects.data()};
    const std::int32_t count = plan_(controller_, &question, moves_.data());
    if (count < 0) {
      throw run_failed(place + ": evbal_plan gave " + std::to_string(count) + " for tick " + std::to_string(tick.tick));
    }
    if (static_cast<std::size_t>(count) > moves_.size()) {
      throw bad_input(place + ": there is room for " + std::to_string(moves_.size()) + " moves, not " +
                      std::to_string(count));
    }
    Plan plan;
    plan.tick = tick.tick;
    plan.moves = checked(count, place, reports);
    plan.provenance.controller = name_;
    return plan;
  }

 private:
  static void* open(const Command& words) {
    void* const library = dlopen(file_of(words).c_str(), RTLD_NOW | RTLD_LOCAL);
    if (library == nullptr) {
      throw bad_input("`" + shown(words) + "` is no library that can be loaded: " + dlerror());
    }
    return library;
  }

  void* create(const PlanningSettings& settings) const {
    const City& city = world_.city;
    const DayClock& clock = world_.clock;
    const Eigen::VectorXi points = city.points();
    const RowMajor km = city.km;
    const RowMajor minutes = city.minutes;
    std::vector<std::string> texts;
    for (const auto& [name, value] : settings.parameters) {
      texts.push_back(text_of(value));
    }
    std::vector<evbal_parameter> parameters;
    for (const auto& [name, value] : settings.parameters) {
      parameters.push_back({name.c_str(), texts[parameters.size()].c_str(), number_of(value)});
    }
    const evbal_day day{.controller = name_.c_str(),
                        .city = city.name.c_str(),
                        .date = world_.day.date.c_str(),
                        .regions = city.size(),
                        .points = points.data(),
                        .km = km.data(),
                        .minutes = minutes.data(),
                        .start = clock.start,
                        .end = clock.end,
                        .tick = clock.tick,
                        .step = clock.step,
                        .plan_every = clock.plan_every,
                        .top_up = city.charging.top_up ? 1 : 0,
                        .parameter_count = static_cast<std::int32_t>(parameters.size()),
                        .parameters = parameters.data()};
    return find<decltype(evbal_create)>(library_.get(), "evbal_create", words_)(&day);
  }

  std::vector<Move> checked(std::int32_t count, const std::string& place, const std::vector<Report>& reports) const {
    MoveCheck check(reports, {}, world_.city);
    std::vector<Move> moves;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
      const evbal_move& given = moves_[i];
      // An errand that there is none of becomes one that is refused.
      const bool known = given.errand == EVBAL_REBALANCE || given.errand == EVBAL_CHARGE;
      moves.push_back(
          {given.from, given.to, given.count, known ? static_cast<Errand>(given.errand) : Errand::passenger});
      if (const auto wrong = check.take(moves.back())) {
        throw bad_input(place + ": moves[" + std::to_string(i) + "]." + wrong->field + ": " + wrong->words);
      }
    }
    if (const auto twice = sort_moves(moves); !twice.empty()) {
      throw bad_input(place + ": moves: " + twice);
    }
    return moves;
  }

  const World& world_;
  std::string name_;
  Command words_;
  std::unique_ptr<void, Close> library_;
  std::add_pointer_t<decltype(evbal_plan)> plan_;
  std::add_pointer_t<decltype(evbal_destroy)> destroy_;
  std::vector<evbal_move> moves_;
  void* controller_ = nullptr;
  int answers_ = 0;
};

}  // namespace

std::unique_ptr<ExternalController> load_library(const World& world, const PlanningSettings& settings) {
  return std::make_unique<LibraryController>(world, settings);
}

}  // namespace evbal
