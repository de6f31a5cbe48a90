#pragma once

#include "agents/protocol/messages.hpp"
#include "agents/world/world.hpp"

#include <string>
#include <vector>

/// What evbal-bridge and a child process say to one another, each line one JSON object; the fields of reports and moves
/// are those of agents/protocol/messages.hpp. docs/your-own-controller.md shows the lines.
namespace evbal {

/// The first line to the child: what it may know of city, day, clock and rules.
std::string opening_line(const World& world, const std::string& controller);

/// A plan is due: the reports that came, without their origin, which would differ between runs.
std::string question_line(int tick, const std::vector<Report>& reports);

/// The child's moves, by (errand, from, to). Throws Error{bad_input} as "place: field: what would be right" if the line
/// is no such object, names a region that is none of the city's, sends more vehicles than a region reported, or tops up
/// where the city does not know that.
std::vector<Move> read_answer(const std::string& line, const std::string& place, const std::vector<Report>& reports,
                              const City& city);

}  // namespace evbal
