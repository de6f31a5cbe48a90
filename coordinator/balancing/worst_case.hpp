#pragma once

#include "coordinator/convex/convex_function.hpp"

namespace evbal {

/// Worst expected shortage of one region (docs/model.md, section 3), with two derivatives in its margin  d = supply -
/// r_hat:
///
///     psi(d) = sup E[(delta - d)_+]   over all distributions with   E[delta]^2 <= g1 sigma^2,   E[delta^2] <= g2
///     sigma^2.
///
/// sigma > 0 is the standard deviation of the demand; g1, g2 >= 0. Convex and decreasing in d, at least the plain
/// shortage max(0, -d), and equal to it where g2 = 0. A surplus is the shortage of the margin  r_hat - supply.
ConvexFunction::Expansion worst_case_shortage(double d, double sigma, double g1, double g2);

/// The same as a function of d.
ConvexFunctionPtr worst_case_shortage(double sigma, double g1, double g2);

}  // namespace evbal
