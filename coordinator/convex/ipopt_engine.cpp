#include "coordinator/convex/ipopt_engine.hpp"

#include "common/contract.hpp"
#include "coordinator/convex/certificate.hpp"
#include "coordinator/convex/ipopt_nlp.hpp"
#include "coordinator/convex/linear_program.hpp"

#include <ClpSimplex.hpp>
#include <IpIpoptApplication.hpp>
#include <IpSolveStatistics.hpp>
#include <IpoptConfig.h>

#include <atomic>
#include <string>

// MUMPS comes without MPI here, also where Debian's Ipopt was built for one with it: Ipopt is told that MPI was started
// and ended by others, and leaves it alone.
extern "C" int MPI_Initialized(int* flag) {
  *flag = 1;
  return 0;
}

extern "C" int MPI_Finalized(int* flag) {
  *flag = 1;
  return 0;
}

namespace evbal {
namespace {

// MUMPS keeps its state in globals.
class OneSolveAtATime {
 public:
  OneSolveAtATime() {
    const bool was_busy = busy_.exchange(true);
    EVBAL_EXPECT(!was_busy, "one solve by Ipopt at a time in a process");
  }
  OneSolveAtATime(const OneSolveAtATime&) = delete;
  OneSolveAtATime& operator=(const OneSolveAtATime&) = delete;
  ~OneSolveAtATime() { busy_ = false; }

 private:
  static inline std::atomic<bool> busy_ = false;
};

// Measured on this problem: Mehrotra's predictor-corrector takes about half the iterations of the default, and the
// fill-in of MUMPS's approximate minimum fill (2) is the least of its orderings.
void configure(Ipopt::IpoptApplication& application, const char* mehrotra, int max_iterations) {
  auto& options = *application.Options();
  options.SetStringValue("sb", "yes");
  options.SetIntegerValue("print_level", 0);
  options.SetStringValue("mu_strategy", "adaptive");
  options.SetStringValue("mehrotra_algorithm", mehrotra);
  options.SetStringValue("linear_solver", "mumps");
  options.SetIntegerValue("mumps_pivot_order", 2);
  options.SetNumericValue("mumps_pivtol", 1e-2);  // at the default 1e-6 one solve in a hundred never settles
  options.SetNumericValue("tol", 1e-9);
  options.SetNumericValue("bound_relax_factor", 1e-10);  // the default lets a row with many cars be off by 6e-7
  options.SetNumericValue("constr_viol_tol", 1e-8);
  options.SetNumericValue("dual_inf_tol", 1e-7);
  options.SetNumericValue("compl_inf_tol", 1e-7);
  options.SetIntegerValue("acceptable_iter", 0);  // only the full tolerance counts
  options.SetIntegerValue("max_iter", max_iterations);
}

struct Attempt {
  Ipopt::ApplicationReturnStatus status = Ipopt::Internal_Error;
  Eigen::VectorXd x;
  int iterations = 0;
};

Attempt attempt(const ConvexProgram& program, const char* mehrotra, int max_iterations) {
  Ipopt::SmartPtr<IpoptNlp> nlp = new IpoptNlp(program);
  Ipopt::SmartPtr<Ipopt::IpoptApplication> application = IpoptApplicationFactory();
  configure(*application, mehrotra, max_iterations);
  application->Initialize("");
  const auto status = application->OptimizeTNLP(nlp);
  const int iterations = IsValid(application->Statistics()) ? application->Statistics()->IterationCount() : 0;
  return {status, nlp->point(), iterations};
}

// Mehrotra's method has no line search and may run away where a curve bends sharply; the method that has one then
// spends what is left of the iterations.
Attempt safeguarded(const ConvexProgram& program, int max_iterations) {
  Attempt first = attempt(program, "yes", max_iterations);
  const int left = max_iterations - first.iterations;
  if (first.status == Ipopt::Solve_Succeeded || left <= 0) {
    return first;
  }
  Attempt second = attempt(program, "no", left);
  second.iterations += first.iterations;
  return second;
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

// The optimum of the linear program with every curve and norm at its tangent at x; -infinity if there is none.
double lower_bound(const ConvexProgram& program, const Eigen::VectorXd& x) {
  LinearProgram lp = linear_part(program);
  for (const auto& norm : program.norms()) {
    lp.add_column(0.0, ConvexProgram::infinity, norm.weight);
  }
  for (const auto& curve : program.curves()) {
    const auto expansion = curve.function->around(x(curve.of));
    lp.add(curve.above, 1.0);
    lp.add(curve.of, -expansion.slope);
    lp.end_row(expansion.value - expansion.slope * x(curve.of));
  }
  int above = program.variables();
  for (const auto& norm : program.norms()) {
    const Eigen::VectorXd gradient = norm.gradient(values_of(norm.variables, x));
    for (std::size_t i = 0; i < norm.variables.size(); ++i) {
      lp.add(norm.variables[i], -gradient(static_cast<Eigen::Index>(i)));
    }
    lp.add(above++, 1.0);
    lp.end_row(0.0);
  }
  if (!lp.unfit().empty()) {
    return -ConvexProgram::infinity;
  }
  const auto clp = lp.load();
  clp->dual();
  return clp->isProvenOptimal() ? lp.lower_bound(*clp) : -ConvexProgram::infinity;
}

}  // namespace

Solution solve_with_ipopt(const ConvexProgram& program, const EngineSettings& settings) {
  const OneSolveAtATime alone;
  const Attempt found = safeguarded(program, settings.max_iterations);
  Solution solution;
  if (found.status == Ipopt::Solve_Succeeded) {
    solution.x = cleaned(program, found.x);
    solution.certificate = certify(program, solution.x, lower_bound(program, solution.x));
  } else {
    const bool spent = found.status == Ipopt::Maximum_Iterations_Exceeded;
    solution.certificate =
        refusal(reason(found.status, found.iterations), spent ? SolveStatus::iteration_limit : SolveStatus::failed);
  }
  solution.certificate.iterations = found.iterations;
  return solution;
}

std::string ipopt_version() {
  return IPOPT_VERSION;
}

}  // namespace evbal
