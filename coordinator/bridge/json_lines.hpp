#pragma once

#include "agents/protocol/messages.hpp"
#include "agents/world/world.hpp"
#include "coordinator/planning/settings.hpp"

#include <string>
#include <vector>

/// What evbal and a controller in a child process say to one another, each line one JSON object; the fields of reports,
/// effects, moves and provenance are those of agents/protocol/messages.hpp. docs/your-own-controller.md shows the
/// lines.
namespace evbal {

/// The first line to the child: what it may know of city, day, clock and rules, its parameters, and `scenario`, the
/// text of the resolved scenario.
std::string opening_line(const World& world, const PlanningSettings& settings, const std::string& scenario);

/// The effects in a tick that controllers are told of: demand that is announced, and faults of their solver.
std::vector<Effect> told_effects(const Tick& tick);

/// A plan is due: the reports that came, without their origin, and told_effects.
std::string question_line(const Tick& tick, const std::vector<Report>& reports);

/// The plan in the child's answer, with moves by (errand, from, to), and provenance if the child gives one. Throws
/// Error{bad_input} as "place: field: what would be right" if the line is no such object, names a region that is none
/// of the city's, sends more vehicles than a region reported, or tops up where the city does not know that.
Plan read_answer(const std::string& line, const std::string& place, const std::vector<Report>& reports,
                 const City& city);

/// What a child on evbal's libraries reads of a question.
struct PlanRequest {
  Tick tick;                    ///< with the effects that a controller is told of
  std::vector<Report> reports;  ///< that came
};

/// The text of the resolved scenario in the first line. Throws Error{bad_input} if there is none.
std::string read_opening(const std::string& line);

/// Reads question_line. Throws Error{bad_input} if the line is anything else.
PlanRequest read_question(const std::string& line);

/// The answer of a child on evbal's libraries.
std::string answer_line(const Plan& plan);

}  // namespace evbal
