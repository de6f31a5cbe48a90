#pragma once

#include "agents/bus/certificates.hpp"
#include "agents/bus/participant.hpp"

#include <array>
#include <cstdint>
#include <map>

namespace evbal {

/// By which the middleware tells participants apart: the first twelve bytes of what it calls a GUID.
using GuidPrefix = std::array<std::uint8_t, 12>;

/// In hexadecimal digits.
std::string text_of(const GuidPrefix& prefix);

/// Which participant of a run is which to the middleware. With security a participant's number is that of its
/// certificate, of whose subject the prefix holds a hash; everybody checks that before the participant is heard.
/// Without security it is what the participant says of itself.
class Roster {
 public:
  /// Of the run to which the address belongs.
  explicit Roster(const BusAddress& address);

  /// Whether participants have to prove who they are.
  bool secured() const { return secured_; }

  /// The participant's number, from 0; -1 if it is none of the run.
  int number_of(const GuidPrefix& prefix) const;

 private:
  int participants_;
  bool secured_;
  std::map<SubjectHash, int> by_subject_;
};

}  // namespace evbal
