#include "common/files.hpp"

#include "common/error.hpp"

#include <cassert>
#include <cerrno>
#include <fstream>
#include <random>
#include <sstream>
#include <system_error>

namespace evbal {
namespace {

namespace fs = std::filesystem;

Error cannot_write(const fs::path& file, int reason) {
  return run_failed(file.string() + ": cannot be written: " + std::generic_category().message(reason));
}

/// `file` with a suffix that nobody can guess, so that no link can wait there.
fs::path beside(const fs::path& file) {
  std::ostringstream suffix;
  suffix << '.' << std::hex << std::random_device()() << ".partial";
  return file.string() + suffix.str();
}

/// The file that a chain of links leads to.
fs::path without_links(const fs::path& file) {
  std::error_code none;
  return fs::is_symlink(file, none) ? fs::weakly_canonical(file, none) : file;
}

}  // namespace

std::string text_of_file(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

void write_file(const fs::path& file, std::string_view text) {
  NewFile written(file);
  written.write(text);
  written.keep();
}

NewFile::NewFile(const fs::path& file) : file_(without_links(file)) {
  std::error_code none;
  const fs::file_status there = fs::status(file, none);
  if (fs::exists(there) && fs::is_directory(there)) {
    throw cannot_write(file, EISDIR);
  }
  if (fs::exists(there) && !fs::is_regular_file(there)) {
    file_ = file;
    stream_.reset(std::fopen(file_.c_str(), "we"));
  } else {
    do {
      partial_ = beside(file_);
      stream_.reset(std::fopen(partial_.c_str(), "wxe"));
    } while (!stream_ && errno == EEXIST);
  }
  if (!stream_) {
    throw cannot_write(file, errno);
  }
}

NewFile::~NewFile() {
  if (!kept_ && !partial_.empty()) {
    std::error_code ignored;
    fs::remove(partial_, ignored);
  }
}

void NewFile::write(std::string_view text) {
  assert(stream_);
  if (std::fwrite(text.data(), 1, text.size(), stream_.get()) != text.size()) {
    throw cannot_write(file_, errno);
  }
}

void NewFile::keep() {
  assert(stream_);
  if (std::fclose(stream_.release()) != 0) {
    throw cannot_write(file_, errno);
  }
  if (!partial_.empty() && std::rename(partial_.c_str(), file_.c_str()) != 0) {
    throw cannot_write(file_, errno);
  }
  kept_ = true;
}

}  // namespace evbal
