#include "agents/hosting/journal.hpp"

#include "common/digest.hpp"
#include "common/error.hpp"
#include "common/text_of_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstring>
#include <string_view>
#include <utility>

namespace evbal {
namespace {

// An entry is `<bytes> <digest>\n`, then its bytes.

std::string digest_of(std::string_view entry) {
  Digest digest;
  digest.update(entry.data(), entry.size());
  return digest.hex();
}

Error failure(const std::filesystem::path& file, const std::string& what) {
  return run_failed(file.string() + ": " + what + ": " + std::strerror(errno));
}

}  // namespace

Journal::Journal(std::filesystem::path file) : path_(std::move(file)) {
  file_ = open(path_.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
  if (file_ < 0) {
    throw failure(path_, "cannot be opened");
  }
  read_all();
}

Journal::~Journal() {
  close(file_);
}

void Journal::read_all() {
  const std::string text = text_of_file(path_);
  std::string_view rest = text;
  for (std::size_t head = 0; (head = rest.find('\n')) != std::string_view::npos;) {
    std::size_t size = 0;
    const char* space = std::from_chars(rest.data(), rest.data() + head, size).ptr;
    if (rest.size() - head - 1 < size) {
      break;
    }
    const std::string_view digest(space, static_cast<std::size_t>(rest.data() + head - space));
    const std::string_view entry = rest.substr(head + 1, size);
    if (digest != " " + digest_of(entry)) {
      throw run_failed(path_.string() + ": entry " + std::to_string(entries_.size() + 1) + " is damaged");
    }
    entries_.emplace_back(entry);
    rest.remove_prefix(head + 1 + size);
  }
  if (!rest.empty() && ftruncate(file_, static_cast<off_t>(text.size() - rest.size())) != 0) {
    throw failure(path_, "the last entry cannot be cut off");
  }
}

void Journal::append(const std::string& entry) {
  const std::string bytes = std::to_string(entry.size()) + " " + digest_of(entry) + "\n" + entry;
  std::string_view rest = bytes;
  while (!rest.empty()) {
    const ssize_t written = write(file_, rest.data(), rest.size());
    if (written < 0) {
      throw failure(path_, "cannot be written");
    }
    rest.remove_prefix(static_cast<std::size_t>(written));
  }
  if (fdatasync(file_) != 0) {
    throw failure(path_, "cannot be made durable");
  }
}

}  // namespace evbal
