#include "common/digest.hpp"

#include "common/error.hpp"

#include <xxhash.h>

#include <array>
#include <cstdio>
#include <fstream>

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

std::string text_digest(const std::string& text) {
  Digest digest;
  digest.update(text.data(), text.size());
  return digest.hex();
}

std::string file_digest(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  Digest digest;
  std::array<char, 65536> part{};
  while (in) {
    in.read(part.data(), part.size());
    digest.update(part.data(), static_cast<std::size_t>(in.gcount()));
  }
  if (!in.eof()) {
    throw bad_input(file.string(), 0, "cannot be read");
  }
  return digest.hex();
}

}  // namespace evbal
