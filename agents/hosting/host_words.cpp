#include "agents/hosting/host_words.hpp"

#include "common/error.hpp"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>

namespace evbal {
namespace {

constexpr std::size_t longest_prelude = 1 << 20;
constexpr std::size_t longest_frame = 1 << 30;
constexpr std::size_t longest_length = 12;  // digits

}  // namespace

bool FrameReader::greeted() {
  const auto at = bytes_.find(keeper_greeting);
  if (at != std::string::npos) {
    bytes_.erase(0, at + keeper_greeting.size());
    return true;
  }
  if (bytes_.size() > longest_prelude) {
    throw run_failed("it says `" + bytes_.substr(0, bytes_.find('\n')) + "` and more, and nothing of evbal's");
  }
  return false;
}

std::optional<std::string> FrameReader::next_frame() {
  const auto line = bytes_.find('\n');
  if (line == std::string::npos && bytes_.size() < longest_length) {
    return std::nullopt;
  }
  std::size_t size = 0;
  const char* end = bytes_.data() + std::min(line, bytes_.size());
  const auto [rest, error] = std::from_chars(bytes_.data(), end, size);
  if (error != std::errc() || rest != end || size > longest_frame) {
    throw run_failed("what it says is no frame");
  }
  if (bytes_.size() < line + 1 + size + 1) {
    return std::nullopt;
  }
  std::string frame = bytes_.substr(line + 1, size);
  bytes_.erase(0, line + 1 + size + 1);
  return frame;
}

bool write_some(int file, std::string& text) {
  const ssize_t written = write(file, text.data(), text.size());
  if (written > 0) {
    text.erase(0, static_cast<std::size_t>(written));
  }
  return written >= 0 || errno == EAGAIN || errno == EINTR;
}

}  // namespace evbal
