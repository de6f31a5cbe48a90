#include "coordinator/convex/engine.hpp"

#include "common/contract.hpp"
#include "coordinator/convex/certificate.hpp"
#include "coordinator/convex/cuts_engine.hpp"
#include "coordinator/convex/ipopt_engine.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace evbal {
namespace {

struct Engine {
  const char* name;
  Solution (*solve)(const ConvexProgram&, const EngineSettings&);
};

constexpr std::array engines = {Engine{"ipopt", solve_with_ipopt}, Engine{"cuts", solve_with_cuts}};

}  // namespace

Solution solve(const ConvexProgram& program, const EngineSettings& settings) {
  if (settings.fails) {
    return {{}, refusal("the engine fails, by a fault")};
  }
  const auto* engine = std::ranges::find_if(engines, [&](const auto& e) { return e.name == settings.name; });
  EVBAL_EXPECT(engine != engines.end(), "the name of an engine");
  return engine->solve(program, settings);
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
