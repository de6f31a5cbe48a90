#include "coordinator/balancing/hinges.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace evbal {
namespace {

// A part of s, and where it begins.
struct Part {
  double from = 0.0;
  Expression amount;
};

// From 0 on, from bend to bend; the last has no end.
std::vector<Part> parts_between(const std::vector<Hinge>& hinges, const Expression& s, const Name& name,
                                ConvexProgram& program) {
  std::vector<double> bends = {0.0};
  for (const Hinge& hinge : hinges) {
    if (hinge.bend > 0.0) {
      bends.push_back(hinge.bend);
    }
  }
  std::ranges::sort(bends);
  bends.erase(std::unique(bends.begin(), bends.end()), bends.end());
  if (bends.size() == 1) {
    return {Part{0.0, s}};
  }
  std::vector<Part> parts;
  Expression sum;
  const Variables amounts = program.add_block(name, static_cast<int>(bends.size()));
  for (int m = 0; m < amounts.size(); ++m) {
    const auto at = static_cast<std::size_t>(m);
    if (at + 1 < bends.size()) {
      program.bound(amounts[m], 0.0, bends[at + 1] - bends[at]);
    }
    sum += amounts[m];
    parts.push_back({bends[at], amounts[m]});
  }
  program.add(s == sum, name);
  return parts;
}

// What the hinges of one term cost, in terms of the parts.
Expression cost_of(const std::string& term, const std::vector<Hinge>& hinges, const std::vector<Part>& parts) {
  Expression cost;
  for (const Hinge& hinge : hinges) {
    if (hinge.term == term) {
      cost += std::max(0.0, -hinge.slope * hinge.bend);
    }
  }
  for (const Part& part : parts) {
    double slope = 0.0;
    for (const Hinge& hinge : hinges) {
      const bool costs_here = hinge.slope < 0.0 ? hinge.bend > part.from : hinge.bend <= part.from;
      slope += hinge.term == term && costs_here ? hinge.slope : 0.0;
    }
    cost.add(slope, part.amount);
  }
  return cost;
}

}  // namespace

Expression minimise_hinges(ConvexProgram& program, const Expression& s, const std::vector<Hinge>& hinges,
                           const Name& name) {
  const std::vector<Part> parts = parts_between(hinges, s, name, program);
  std::vector<std::string> terms;
  for (const Hinge& hinge : hinges) {
    if (std::ranges::find(terms, hinge.term) == terms.end()) {
      terms.push_back(hinge.term);
      program.minimise(hinge.term, cost_of(hinge.term, hinges, parts));
    }
  }
  Expression sum;
  for (const Part& part : parts) {
    sum += part.amount;
  }
  return sum;
}

}  // namespace evbal
