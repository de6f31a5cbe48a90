#pragma once

#include "coordinator/convex/convex_program.hpp"

#include <string>
#include <vector>

namespace evbal {

/// The cost  max(0, slope (s - bend))  of a quantity s: it falls up to the bend, or rises from there on.
struct Hinge {
  std::string term;    ///< of the objective, such as "shortage"
  double slope = 0.0;  ///< falls if negative, else rises
  double bend = 0.0;   ///< the value of s where the cost is zero on one side
};

/// Adds the sum of hinges of `s`, which is at least zero, to the objective: at most one row, called `name`. It divides
/// s into parts between one bend and the next, each priced by the slope there. Slopes rise from part to part, so that
/// an optimum fills them in turn, and each term gets its own hinges. Gives the sum of the parts, which is s in terms of
/// variables of its own.
Expression minimise_hinges(ConvexProgram& program, const Expression& s, const std::vector<Hinge>& hinges,
                           const Name& name);

}  // namespace evbal
