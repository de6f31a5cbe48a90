#include "tools/records/text_lines.hpp"

#include <archive.h>
#include <archive_entry.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

namespace evbal {

struct LineReader::Stream {
  struct Free {
    void operator()(archive* done) const { archive_read_free(done); }
  };
  std::unique_ptr<archive, Free> opened{archive_read_new()};
  std::array<char, 1 << 16> buffer{};
  std::size_t size = 0;
  std::size_t at = 0;
  bool empty = false;
  char line_end = '\0';  ///< known from the first buffer on

  std::string complaint() const {
    const char* text = archive_error_string(opened.get());
    return text == nullptr ? "is it damaged?" : text;
  }

  /// False at the end of the file.
  bool refill(const LineReader& reader) {
    if (empty) {
      return false;
    }
    const la_ssize_t bytes = archive_read_data(opened.get(), buffer.data(), buffer.size());
    if (bytes < 0) {
      throw reader.error("cannot be read on: " + complaint());
    }
    size = static_cast<std::size_t>(bytes);
    at = 0;
    if (line_end == '\0' && size > 0) {
      line_end = ends_lines_in_cr() ? '\r' : '\n';
    }
    return bytes > 0;
  }

  /// Whether lines end in a carriage return alone, as on old Macintoshes.
  bool ends_lines_in_cr() const {
    const std::string_view text(buffer.data(), size);
    return text.find('\n') == std::string_view::npos && text.find('\r') < size - 1;
  }
};

LineReader::LineReader(const std::filesystem::path& file, std::size_t longest)
    : stream_(std::make_unique<Stream>()), file_(file.string()), longest_(longest) {
  archive* opened = stream_->opened.get();
  // Not all filters that libarchive has: some start another program.
  archive_read_support_filter_gzip(opened);
  archive_read_support_filter_xz(opened);
  archive_read_support_filter_bzip2(opened);
  archive_read_support_filter_zstd(opened);
  archive_read_support_format_raw(opened);
  archive_read_support_format_empty(opened);
  archive_entry* entry = nullptr;
  if (archive_read_open_filename(opened, file_.c_str(), 1 << 16) != ARCHIVE_OK) {
    throw error("cannot be read: " + stream_->complaint());
  }
  const int header = archive_read_next_header(opened, &entry);
  stream_->empty = header == ARCHIVE_EOF;
  if (!stream_->empty && header != ARCHIVE_OK) {
    throw error("cannot be read: " + stream_->complaint());
  }
}

LineReader::~LineReader() = default;

bool LineReader::next(std::string& line) {
  line.clear();
  ++line_;
  Stream& in = *stream_;
  while (in.at < in.size || in.refill(*this)) {
    const char* begin = in.buffer.data() + in.at;
    const char* end = in.buffer.data() + in.size;
    const char* newline = std::find(begin, end, in.line_end);
    line.append(begin, newline);
    if (line.size() > longest_) {
      throw error("is longer than " + std::to_string(longest_) + " bytes; this is no table");
    }
    in.at = static_cast<std::size_t>(newline - in.buffer.data());
    if (newline != end) {
      ++in.at;
      if (in.line_end == '\n' && line.ends_with('\r')) {
        line.pop_back();
      }
      return true;
    }
  }
  return !line.empty();
}

Error LineReader::error(const std::string& message) const {
  return bad_input(file_, line_, message);
}

std::string unpacked_text(const std::filesystem::path& file) {
  LineReader lines(file);
  std::string text;
  std::string line;
  while (lines.next(line)) {
    text += line + "\n";
  }
  return text;
}

namespace {

/// The ending of a file's name in small letters, without that of a compression.
std::string unpacked_ending(std::filesystem::path file) {
  const auto ending = [&] {
    std::string text = file.extension().string();
    std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
    return text;
  };
  const std::string last = ending();
  if (last == ".gz" || last == ".xz" || last == ".bz2" || last == ".zst") {
    file.replace_extension();
  }
  return ending();
}

/// The files of a folder with one of these endings, plain or compressed, by name.
std::vector<std::filesystem::path> files_of(const std::filesystem::path& folder,
                                            const std::vector<std::string>& kinds) {
  if (!std::filesystem::is_directory(folder)) {
    throw bad_input(folder.string(), 0, "is no folder");
  }
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string kind = unpacked_ending(entry.path());
    if (std::find(kinds.begin(), kinds.end(), kind) != kinds.end()) {
      files.push_back(entry.path());
    }
  }
  if (files.empty()) {
    throw bad_input(folder.string(), 0,
                    "has no file that ends in " + kinds.front() + ", plain or .gz, .xz, .bz2 or .zst");
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

std::vector<std::filesystem::path> csv_files(const std::filesystem::path& folder) {
  return files_of(folder, {".csv"});
}

std::vector<std::filesystem::path> text_files(const std::filesystem::path& folder) {
  return files_of(folder, {".csv", ".txt"});
}

}  // namespace evbal
