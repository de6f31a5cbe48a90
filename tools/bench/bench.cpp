#include "coordinator/balancing/engine.hpp"
#include "coordinator/balancing/formulation.hpp"
#include "coordinator/balancing/linear_relaxation.hpp"
#include "tools/bench/measure.hpp"
#include "tools/samples/random_planning_data.hpp"
#include "tools/verify/inner_problem.hpp"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace evbal {
namespace {

constexpr int limit = 300;  // seconds of processor
const Switches robust = {.demand = Belief::worst_case, .supply = Belief::worst_case};

PlanningData city(int regions, int tau) {
  return random_planning_data(1, {.regions = regions, .tau = tau, .rank = 3, .out_degree = 12});
}

std::optional<Cost> by_engine(const std::string& engine, int regions, int tau) {
  const auto prepare = [&]() -> Work {
    return [engine, program = formulate({}, city(regions, tau), robust).program] {
      return solve(program, {.name = engine}).certificate.optimal;
    };
  };
  return measure(prepare, limit);
}

// The same problem without J_E: what no engine of this kind can undercut.
std::optional<Cost> by_linear_program(int regions, int tau) {
  const auto prepare = [&]() -> Work {
    BalancingParameters parameters;
    parameters.theta_0 = 0.0;
    return [program = formulate(parameters, city(regions, tau), robust).program] {
      return LinearRelaxation(program).solve().optimal;
    };
  };
  return measure(prepare, limit);
}

MomentSet at_stations(MomentSet set) {
  std::vector<Eigen::Index> entries;
  for (Eigen::Index i = 0; i < set.mean.size(); ++i) {
    if (set.mean(i) > 0.0) {
      entries.push_back(i);
    }
  }
  set.mean = set.mean(entries).eval();
  set.deviation = set.deviation(entries).eval();
  set.factors = set.factors(entries, Eigen::all).eval();
  return set;
}

// The block of the supply alone of Theorem 1's semidefinite program, by SDPA.
std::optional<Cost> by_semidefinite_program(int regions, int tau) {
  std::string folder = "/tmp/evbal-bench-XXXXXX";
  if (mkdtemp(folder.data()) == nullptr) {
    return std::nullopt;
  }
  const auto prepare = [&]() -> Work {
    const auto set = at_stations(city(regions, tau).completions);
    std::ofstream(folder + "/problem.dat-s") << inner_problem(set, Eigen::VectorXd::Ones(set.mean.size()));
    const std::string command = "cd " + folder + " && OMP_NUM_THREADS=1 sdpa -ds problem.dat-s -o out >log 2>&1" +
                                " && grep -q 'phase.value *= *pdOPT' out";
    return [command] { return std::system(command.c_str()) == 0; };
  };
  const auto cost = measure(prepare, limit);
  std::filesystem::remove_all(folder);
  return cost;
}

std::string seconds(const std::optional<Cost>& cost) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.3g", cost ? cost->seconds : 0.0);
  return cost ? text.data() : "-";
}

std::string megabytes(const std::optional<Cost>& cost) {
  return cost ? std::to_string(static_cast<int>(cost->megabytes)) : "-";
}

std::string ratio(const std::optional<Cost>& more, const std::optional<Cost>& less) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.3g", more && less ? more->seconds / less->seconds : 0.0);
  return more && less ? text.data() : "-";
}

void row(int regions, int tau) {
  constexpr int most_entries = 108;  // of a semidefinite program that ends
  const auto lp = by_linear_program(regions, tau);
  const auto cuts = by_engine("cuts", regions, tau);
  const auto ipopt = by_engine("ipopt", regions, tau);
  const auto sdp = regions * tau <= most_entries ? by_semidefinite_program(regions, tau) : std::nullopt;
  std::printf("| %d | %d | %s | %s | %s | %s | %s | %s | %s | %s | %s | %s |\n", regions, tau, seconds(lp).c_str(),
              seconds(cuts).c_str(), ratio(cuts, lp).c_str(), seconds(ipopt).c_str(), ratio(ipopt, cuts).c_str(),
              seconds(sdp).c_str(), ratio(sdp, cuts).c_str(), megabytes(lp).c_str(), megabytes(cuts).c_str(),
              megabytes(ipopt).c_str());
  std::fflush(stdout);
}

std::string processor() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    if (line.starts_with("model name")) {
      return line.substr(line.find(": ") + 2);
    }
  }
  return "a processor without a name";
}

}  // namespace
}  // namespace evbal

// evbal-bench [N]: the table of docs/performance.md, for cities of at most N regions.
int main(int argc, char** argv) {
  setenv("OPENBLAS_NUM_THREADS", "1", 1);
  const int largest = argc > 1 ? std::atoi(argv[1]) : 491;
  std::printf(R"(# What a plan costs

Made by `build/release/bin/evbal-bench %d > docs/performance.md` on %s, one thread at a time: one plan of
the controller `robust` for a random city (out-degree 12, 10 vacant cars a region, stations in two regions of five).
Seconds of processor, from the program as written to the optimum with its certificate (relative gap at most 1e-6), and the
most memory held, in MB, the city included. Ratios are of the same run. A dash: not tried, or not within %d s.

- LP: the same problem without J_E by Clp, which no method of tangent cuts can undercut.
- SDP: of the paper's Theorem 1 as printed, only the supply's block at the stations, by SDPA (package
  `sdpa`, if installed), as far as (54, 2).

| N | tau | LP s | cuts s | cuts / LP | ipopt s | ipopt / cuts | SDP s | SDP / cuts | LP MB | cuts MB | ipopt MB |
|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|
)",
              largest, evbal::processor().c_str(), evbal::limit);
  std::fflush(stdout);
  for (const int regions : {5, 12, 54, 100, 247, 491}) {
    for (const int tau : {2, 4, 6}) {
      if (regions <= largest) {
        evbal::row(regions, tau);
      }
    }
  }
}
