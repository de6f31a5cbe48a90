#pragma once

#include "common/eigen.hpp"
#include "coordinator/ambiguity/moment_set.hpp"

#include <string>

namespace evbal {

/// The inner problem of the paper's Theorem 1, as printed: over t, v, q and a symmetric matrix Q, with
/// Sigma = diag(deviation)^2 + factors factors',
///
///     min  v + t
///     s.t. [ v           (q - h)' / 2 ]
///          [ (q - h) / 2       Q      ]  >= 0   (so that Q >= 0)
///          t >= (g2 Sigma + mean mean') . Q + mean'q + sqrt(g1) || Sigma^(1/2) (q + 2 Q mean) ||
///
/// whose optimum is the worst expectation of h'xi over the set. Returned in SDPA's sparse format, with the second-order
/// cone as a semidefinite block and the variables in the order v, t, q, Q's upper triangle by rows.
std::string inner_problem(const MomentSet& set, const Eigen::VectorXd& h);

/// What the project uses in its place (docs/model.md, section 3):  h'mean + sqrt(min(g1, g2)) || Sigma^(1/2) h ||.
double closed_form(const MomentSet& set, const Eigen::VectorXd& h);

}  // namespace evbal
