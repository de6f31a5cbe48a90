#include "common/digest.hpp"

#include <xxhash.h>

#include <array>
#include <cstdio>

namespace evbal {

void Digest::Free::operator()(XXH3_state_s* state) const {
  XXH3_freeState(state);
}

Digest::Digest() : state_(XXH3_createState()) {
  XXH3_128bits_reset(state_.get());
}

void Digest::update(const void* data, std::size_t bytes) {
  XXH3_128bits_update(state_.get(), data, bytes);
}

std::string Digest::hex() const {
  XXH128_canonical_t canonical;
  XXH128_canonicalFromHash(&canonical, XXH3_128bits_digest(state_.get()));
  std::string text;
  for (const unsigned char byte : canonical.digest) {
    std::array<char, 3> digits{};
    std::snprintf(digits.data(), digits.size(), "%02x", byte);
    text += digits.data();
  }
  return text;
}

}  // namespace evbal
