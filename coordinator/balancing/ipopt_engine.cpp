#include "coordinator/balancing/ipopt_engine.hpp"

#include "coordinator/balancing/certificate.hpp"
#include "coordinator/balancing/ipopt_nlp.hpp"
#include "coordinator/balancing/linear_relaxation.hpp"

#include <coin/IpIpoptApplication.hpp>
#include <coin/IpSolveStatistics.hpp>

#include <string>

namespace evbal {
namespace {

// Measured on this problem: Mehrotra's predictor-corrector takes about half the iterations of the default, and the
// fill-in of MUMPS's approximate minimum fill (2) is the least of its orderings.
void configure(Ipopt::IpoptApplication& application, const EngineSettings& settings) {
  auto& options = *application.Options();
  options.SetStringValue("sb", "yes");
  options.SetIntegerValue("print_level", 0);
  options.SetStringValue("mehrotra_algorithm", "yes");
  options.SetStringValue("linear_solver", "mumps");
  options.SetIntegerValue("mumps_pivot_order", 2);
  options.SetNumericValue("mumps_pivtol", 1e-2);  // at the default 1e-6 one solve in a hundred never settles
  options.SetNumericValue("tol", 1e-9);
  options.SetNumericValue("bound_relax_factor", 1e-10);  // the default lets a row with many cars be off by 6e-7
  options.SetNumericValue("constr_viol_tol", 1e-8);
  options.SetNumericValue("dual_inf_tol", 1e-7);
  options.SetNumericValue("compl_inf_tol", 1e-7);
  options.SetIntegerValue("acceptable_iter", 0);  // only the full tolerance counts
  options.SetIntegerValue("max_iter", settings.max_iterations);
}

std::string reason(Ipopt::ApplicationReturnStatus status, int iterations) {
  switch (status) {
    case Ipopt::Maximum_Iterations_Exceeded:
      return "no optimum within " + std::to_string(iterations) + " iterations";
    case Ipopt::Infeasible_Problem_Detected:
      return "Ipopt finds the problem infeasible";
    case Ipopt::Invalid_Number_Detected:
      return "Ipopt met a number that is not finite";
    default:
      return "Ipopt stopped with status " + std::to_string(static_cast<int>(status));
  }
}

double lower_bound(const ConvexProgram& program, const Eigen::VectorXd& x) {
  constexpr int max_simplex_iterations = 200000;
  LinearRelaxation relaxation(program);
  relaxation.add_tangents(x);
  const auto outcome = relaxation.solve(max_simplex_iterations);
  return outcome.optimal ? outcome.lower_bound : -ConvexProgram::infinity;
}

}  // namespace

Solution solve_with_ipopt(const ConvexProgram& program, const EngineSettings& settings) {
  Ipopt::SmartPtr<IpoptNlp> nlp = new IpoptNlp(program);
  Ipopt::SmartPtr<Ipopt::IpoptApplication> application = IpoptApplicationFactory();
  configure(*application, settings);
  application->Initialize("");
  const auto status = application->OptimizeTNLP(nlp);

  const int iterations = IsValid(application->Statistics()) ? application->Statistics()->IterationCount() : 0;
  Solution solution;
  if (status == Ipopt::Solve_Succeeded) {
    solution.x = cleaned(program, nlp->point());
    solution.certificate = certify(program, solution.x, lower_bound(program, solution.x));
  } else {
    solution.certificate = refusal(reason(status, iterations));
  }
  solution.certificate.iterations = iterations;
  return solution;
}

}  // namespace evbal
