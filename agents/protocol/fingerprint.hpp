#pragma once

#include "agents/protocol/messages.hpp"
#include "common/digest.hpp"

namespace evbal {

/// Adds a message to a digest: every field but the Origin, in the order of the struct, as little-endian bytes. A rare
/// field (fields.hpp) that is quiet adds nothing, one that is not adds its name too: new kinds of fault leave the
/// digests of days without them alone.
void fingerprint(Digest& digest, const Faults& message);
void fingerprint(Digest& digest, const Report& message);
void fingerprint(Digest& digest, const Plan& message);
void fingerprint(Digest& digest, const Departures& message);

}  // namespace evbal
