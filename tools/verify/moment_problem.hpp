#pragma once

namespace evbal {

/// The worst expected shortage of one region by linear programming, for comparison with worst_case_shortage():
///
///     sup E[(delta - d)_+]   over all distributions with   |E[delta]| <= sqrt(g1) sigma,   E[delta^2] <= g2 sigma^2.
///
/// A distribution is weights on points; the multipliers of its moments say where the next point must lie (column
/// generation), until none anywhere on the line can improve it by more than 1e-8 sigma. sigma > 0, g1 >= 0, g2 > 0, |d|
/// <= 1e6 sigma. Throws Error{run_failed} if it does not settle.
double moment_problem(double d, double sigma, double g1, double g2);

}  // namespace evbal
