#include "agents/protocol/fingerprint.hpp"

#include "agents/protocol/bytes.hpp"

namespace evbal {
namespace {

template <class Message>
void add(Digest& digest, const Message& message) {
  ByteWriter writer([&](const void* data, std::size_t size) { digest.update(data, size); }, Detail::digest);
  writer.write(message);
}

}  // namespace

void fingerprint(Digest& digest, const Faults& message) {
  add(digest, message);
}

void fingerprint(Digest& digest, const Report& message) {
  add(digest, message);
}

void fingerprint(Digest& digest, const Plan& message) {
  add(digest, message);
}

void fingerprint(Digest& digest, const Departures& message) {
  add(digest, message);
}

}  // namespace evbal
