#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>

struct XXH3_state_s;

namespace evbal {

/// Running 128-bit fingerprint (XXH3) of bytes: two runs with the same digest said and did the same.
class Digest {
 public:
  Digest();

  /// Adds bytes.
  void update(const void* data, std::size_t bytes);

  /// Fingerprint of all bytes so far, as 32 lower-case hexadecimal digits.
  std::string hex() const;

 private:
  struct Free {
    void operator()(XXH3_state_s* state) const;
  };
  std::unique_ptr<XXH3_state_s, Free> state_;
};

/// Fingerprint of a text.
std::string text_digest(const std::string& text);

/// Fingerprint of a file's content. Throws Error{bad_input} if it cannot be read.
std::string file_digest(const std::filesystem::path& file);

}  // namespace evbal
