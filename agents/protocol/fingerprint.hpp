#pragma once

#include "agents/protocol/messages.hpp"
#include "common/digest.hpp"

namespace evbal {

/// Adds a message to a digest: its fields in the order of the struct, as little-endian bytes, but for what the end of
/// messages.hpp excepts.
void fingerprint(Digest& digest, const Faults& message);
/// Adds a report, without its origin.
void fingerprint(Digest& digest, const Report& message);
/// Adds a plan, without its origin.
void fingerprint(Digest& digest, const Plan& message);
/// Adds departures, without their origin.
void fingerprint(Digest& digest, const Departures& message);

}  // namespace evbal
