#include "common/files.hpp"
#include "common/scratch_folder.hpp"
#include "coordinator/balancing/formulation.hpp"
#include "coordinator/convex/engine.hpp"
#include "coordinator/convex/linear_relaxation.hpp"
#include "tools/bench/measure.hpp"
#include "tools/samples/random_planning_data.hpp"
#include "tools/verify/inner_problem.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

namespace evbal {
namespace {

constexpr int limit = 300;  // seconds of processor
const FormulationOptions robust = {.demand = Uncertainty::worst_case, .supply = Uncertainty::worst_case};

PlanningData city(int regions, int tau) {
  return random_planning_data(1, {.regions = regions, .tau = tau, .rank = 3, .out_degree = 12});
}

std::optional<Cost> by_engine(const std::string& engine, int regions, int tau) {
  const auto prepare = [&]() -> Work {
    return [engine, program = formulate({}, city(regions, tau), robust).program] {
      return solve(program, {.name = engine}).certificate.optimal();
    };
  };
  return measure(prepare, limit);
}

// The same problem without J_E.
std::optional<Cost> by_linear_program(int regions, int tau) {
  const auto prepare = [&]() -> Work {
    BalancingParameters parameters;
    parameters.theta_0 = 0.0;
    return [program = formulate(parameters, city(regions, tau), robust).program] {
      return LinearRelaxation(program).solve().why_not.empty();
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

// Theorem 1's semidefinite program for one of the two uncertain vectors, whatever multiplies it, by SDPA.
std::optional<Cost> by_semidefinite_program(const MomentSet& set) {
  const ScratchFolder folder;
  const auto prepare = [&]() -> Work {
    write_file(folder.path() / "problem.dat-s", inner_problem(set, Eigen::VectorXd::Ones(set.mean.size())));
    const std::string command = "cd " + folder.path().string() +
                                " && OMP_NUM_THREADS=1 sdpa -ds problem.dat-s -o out >log 2>&1" +
                                " && grep -q 'phase.value *= *pdOPT' out";
    return [command] { return std::system(command.c_str()) == 0; };
  };
  return measure(prepare, limit);
}

std::optional<Cost> sum(const std::optional<Cost>& one, const std::optional<Cost>& other) {
  if (!one || !other) {
    return std::nullopt;
  }
  return Cost{one->seconds + other->seconds, std::max(one->megabytes, other->megabytes), one->ended && other->ended};
}

std::string shown(double value, bool at_least) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%s%.3g", at_least ? "> " : "", value);
  return text.data();
}

std::string seconds(const std::optional<Cost>& cost) {
  return cost ? shown(cost->seconds, !cost->ended) : "-";
}

std::string megabytes(const std::optional<Cost>& cost) {
  return cost && cost->ended ? std::to_string(static_cast<int>(cost->megabytes)) : "-";
}

std::string ratio(const std::optional<Cost>& more, const std::optional<Cost>& less) {
  return more && less && less->ended ? shown(more->seconds / less->seconds, !more->ended) : "-";
}

void row(int regions, int tau) {
  const auto lp = by_linear_program(regions, tau);
  const auto cuts = by_engine("cuts", regions, tau);
  const auto ipopt = by_engine("ipopt", regions, tau);
  const auto data = city(regions, tau);
  constexpr int most_entries = 108;  // of demand, where a semidefinite program may still end
  const bool small = regions * tau <= most_entries;
  const auto supply = small ? by_semidefinite_program(at_stations(data.completions)) : std::nullopt;
  const auto both = small ? sum(supply, by_semidefinite_program(data.demand)) : std::nullopt;
  for (const auto& cell : {std::to_string(regions), std::to_string(tau), seconds(lp), seconds(cuts), ratio(cuts, lp),
                           seconds(ipopt), ratio(ipopt, cuts), seconds(supply), seconds(both), ratio(both, cuts),
                           megabytes(lp), megabytes(cuts), megabytes(ipopt)}) {
    std::printf("| %s ", cell.c_str());
  }
  std::printf("|\n");
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

// evbal-bench: the table of docs/performance.md.
int main(int argc, char** argv) {
  setenv("OPENBLAS_NUM_THREADS", "1", 1);
  CLI::App app("Times one plan for cities of several sizes; the tables of docs/performance.md", "evbal-bench");
  std::vector<int> sizes = {5, 12, 54, 100, 247, 491};
  app.add_option("N", sizes, "Numbers of regions")->check(CLI::Range(2, 1000))->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  std::printf(R"(# Solver time and memory

Made by `build/release/bin/evbal-bench > docs/performance.md` on %s, one thread at a time: one plan of the
controller `robust` for a random city (out-degree 12, 10 vacant cars a region, stations in two regions of five).
Seconds of processor, from the program as written to the optimum with its certificate (relative gap at most 1e-6), the
least of five measurements (one, beyond two seconds), and the most memory held, in MB, the city included. Ratios are of the
same run. ">": stopped there. A dash: not tried, or failed.

- LP: the same problem without J_E by Clp, to compare with.
- SDP: the semidefinite program of the paper's Theorem 1 as printed, by SDPA (package `sdpa`, if installed) with its
  default parameters: the supply's block at the stations alone; then with the demand's block, of N tau entries. The decisions
  are held, so that the two blocks are solved one after the other; the printed problem would decide as well.

| N | tau | LP s | cuts s | cuts / LP | ipopt s | ipopt / cuts | SDP supply s | SDP s | SDP / cuts | LP MB | cuts MB | ipopt MB |
|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|
)",
              evbal::processor().c_str());
  std::fflush(stdout);
  for (const int regions : sizes) {
    for (const int tau : {2, 4, 6}) {
      evbal::row(regions, tau);
    }
  }
}
