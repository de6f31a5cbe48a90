#pragma once

#include <vector>

namespace evbal {

/// A region whose cars are estimated, because it is taken to lie about them.
struct Suspect {
  int region = 0;         ///< its number
  double more = 0.0;      ///< cars that it says to have beyond its estimate
  double variance = 0.0;  ///< of the estimate
  double price = 0.0;     ///< -ln of the odds that it tells the truth, whatever the city has
};

/// The regions that are to be believed again, in the order of `suspects`. The city has `surplus` cars beyond its fleet
/// if none of them is, with this variance; each that is believed adds what it says more and takes its variance away.
/// Of all sets of suspects, the likeliest is the one whose prices, with -ln of the normal density of the surplus that
/// it leaves, are the least; it is sought by changes of one and two suspects, from none and from all of them.
std::vector<int> likeliest_innocents(double surplus, double variance, const std::vector<Suspect>& suspects);

}  // namespace evbal
