#include "coordinator/convex/engine.hpp"

#include "common/contract.hpp"
#include "coordinator/convex/cuts_engine.hpp"
#include "coordinator/convex/ipopt_engine.hpp"
#include "coordinator/convex/linear_program.hpp"

#include <algorithm>
#include <array>

namespace evbal {
namespace {

struct NamedEngine {
  const char* name;
  Solution (*solve)(const ConvexProgram&, const EngineSettings&, const Start&);
};

Solution afresh_with_ipopt(const ConvexProgram& program, const EngineSettings& settings, const Start& /*start*/) {
  return solve_with_ipopt(program, settings);
}

constexpr std::array engines = {NamedEngine{"ipopt", afresh_with_ipopt}, NamedEngine{"cuts", solve_with_cuts}};

// Why no engine may be given this program; empty if any may.
std::string unfit(const ConvexProgram& program) {
  for (std::size_t n = 0; n < program.norms().size(); ++n) {
    const NormTerm& norm = program.norms()[n];
    if (!is_fit(norm.weight) || !std::ranges::all_of(norm.deviation, is_fit) ||
        !std::ranges::all_of(norm.factors.reshaped(), is_fit)) {
      return "norm " + std::to_string(n) + ": has a number that is not finite or too large";
    }
  }
  const auto variable = [&](int index) { return program.name_of({index}).text(); };
  for (const CurveRow& curve : program.curves()) {
    const auto lowest = curve.function->around(program.lower()[static_cast<std::size_t>(curve.of)]);
    if (!is_fit(lowest.value) || !is_fit(lowest.slope) || !is_fit(lowest.curvature)) {
      return "curve of " + variable(curve.of) + ": not finite or too steep at its lower bound";
    }
  }
  return linear_part(program).unfit(variable, [&](int row) { return program.name_of_row(row).text(); });
}

}  // namespace

Solution solve(const ConvexProgram& program, const EngineSettings& settings, const Start& start) {
  if (settings.own) {
    return settings.own(program, settings);
  }
  const auto* engine = std::ranges::find_if(engines, [&](const auto& e) { return e.name == settings.name; });
  EVBAL_EXPECT(engine != engines.end(), "the name of an engine");
  if (const std::string why_not = unfit(program); !why_not.empty()) {
    return {{}, refusal(why_not, SolveStatus::refused)};
  }
  return engine->solve(program, settings, start);
}

std::vector<std::string> engine_names() {
  std::vector<std::string> names;
  names.reserve(engines.size());
  for (const auto& engine : engines) {
    names.emplace_back(engine.name);
  }
  return names;
}

}  // namespace evbal
