#include "agents/hosting/journal.hpp"

#include "common/digest.hpp"
#include "common/error.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <optional>
#include <string_view>
#include <utility>

namespace evbal {
namespace {

// An entry is a header, `<bytes> <digest of the bytes> <digest of the header so far>\n`, and its bytes. As a header has
// a fixed length and a digest of its own, an entry that is cut short is told from one that is damaged.
constexpr std::size_t size_digits = 16;
constexpr std::size_t digest_digits = 32;
constexpr std::size_t header_length = size_digits + 1 + digest_digits + 1 + digest_digits + 1;

std::string digest_of(std::string_view text) {
  Digest digest;
  digest.update(text.data(), text.size());
  return digest.hex();
}

std::string header(std::size_t size, std::string_view digest) {
  std::string number = std::to_string(size);
  number.insert(0, size_digits - number.size(), '0');
  const std::string text = number + " " + std::string(digest);
  return text + " " + digest_of(text) + "\n";
}

/// The length of an entry, by its header; none if that is damaged.
std::optional<std::size_t> size_by(std::string_view given) {
  std::size_t size = 0;
  std::from_chars(given.data(), given.data() + size_digits, size);
  const bool whole = given == header(size, given.substr(size_digits + 1, digest_digits));
  return whole ? std::optional(size) : std::nullopt;
}

Error failure(const std::filesystem::path& file, const std::string& what) {
  return run_failed(file.string() + ": " + what + ": " + std::strerror(errno));
}

}  // namespace

Journal::Journal(std::filesystem::path file) : path_(std::move(file)), file_(path_, O_RDWR | O_CREAT | O_APPEND) {
  take_entries(whole_text());
}

std::string Journal::whole_text() const {
  std::string text;
  std::array<char, 1 << 16> part{};
  ssize_t length = 0;
  while ((length = read(file_.number(), part.data(), part.size())) > 0) {
    text.append(part.data(), static_cast<std::size_t>(length));
  }
  if (length < 0) {
    throw failure(path_, "cannot be read");
  }
  return text;
}

void Journal::take_entries(std::string_view text) {
  std::size_t at = 0;
  while (text.size() - at >= header_length) {
    const std::string_view given = text.substr(at, header_length);
    const auto size = size_by(given);
    if (size && text.size() - at - header_length < *size) {
      break;
    }
    const std::string_view entry = text.substr(at + header_length, size.value_or(0));
    if (!size || given != header(*size, digest_of(entry))) {
      throw run_failed(path_.string() + ": entry " + std::to_string(entries_.size() + 1) + ", at byte " +
                       std::to_string(at) + ", is damaged");
    }
    entries_.emplace_back(entry);
    at += header_length + entry.size();
  }
  if (at < text.size() && ftruncate(file_.number(), static_cast<off_t>(at)) != 0) {
    throw failure(path_, "the last entry cannot be cut off");
  }
}

void Journal::append(const std::string& entry) {
  const std::string bytes = journal_text(entry);
  std::string_view rest = bytes;
  while (!rest.empty()) {
    const ssize_t written = write(file_.number(), rest.data(), rest.size());
    if (written < 0) {
      throw failure(path_, "cannot be written");
    }
    rest.remove_prefix(static_cast<std::size_t>(written));
  }
}

std::string journal_text(const std::string& entry) {
  return header(entry.size(), digest_of(entry)) + entry;
}

}  // namespace evbal
