#include "tools/records/text_lines.hpp"

#include <archive.h>
#include <archive_entry.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <string_view>

namespace evbal {
namespace {

/// What ends the lines of a text; nothing if that does not show yet.
std::optional<char> line_end_in(std::string_view text) {
  if (text.find('\n') != std::string_view::npos) {
    return '\n';
  }
  // As on old Macintoshes; but at the end of `text` it may be half of CR LF.
  return text.substr(0, text.size() - 1).find('\r') != std::string_view::npos ? std::optional('\r') : std::nullopt;
}

}  // namespace

struct LineReader::Stream {
  struct Free {
    void operator()(archive* done) const { archive_read_free(done); }
  };
  std::unique_ptr<archive, Free> opened{archive_read_new()};
  std::array<char, 1 << 16> buffer{};
  std::size_t size = 0;
  std::size_t at = 0;
  bool empty = false;
  std::optional<char> line_end;  ///< once the text shows it

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
    if (!line_end && size > 0) {
      line_end = line_end_in({buffer.data(), size});
    }
    return bytes > 0;
  }

  /// Begins to read.
  void begin(const LineReader& reader) {
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
    refill(reader);
    const std::string_view text(buffer.data(), size);
    if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) {
      throw reader.error("is UTF-16; save it as UTF-8");
    }
    if (text.starts_with("PK\x03\x04")) {
      throw reader.error("is a zip archive, as spreadsheets are; unpack it, or save its table as CSV");
    }
    at = text.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0;
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
  stream_->begin(*this);
}

LineReader::~LineReader() = default;

namespace {

/// Takes off a carriage return where lines end in CR LF, or where the file breaks off between the two.
void drop_half_end(std::string& line) {
  if (line.ends_with('\r')) {
    line.pop_back();
  }
}

}  // namespace

bool LineReader::next(std::string& line) {
  line.clear();
  ++line_;
  Stream& in = *stream_;
  while (in.at < in.size || in.refill(*this)) {
    const char* begin = in.buffer.data() + in.at;
    const char* end = in.buffer.data() + in.size;
    const char* newline = in.line_end ? std::find(begin, end, *in.line_end) : end;
    line.append(begin, newline);
    if (line.size() > longest_) {
      throw error("is longer than " + std::to_string(longest_) + " bytes; is this text?");
    }
    in.at = static_cast<std::size_t>(newline - in.buffer.data());
    if (newline != end) {
      ++in.at;
      drop_half_end(line);
      return true;
    }
  }
  drop_half_end(line);
  return !line.empty();
}

Error LineReader::error(const std::string& message) const {
  return bad_input(file_, line_, message);
}

std::string unpacked_text(const std::filesystem::path& file, std::size_t longest) {
  LineReader lines(file, longest);
  std::string text;
  std::string line;
  while (lines.next(line)) {
    text += line + "\n";
    if (text.size() > longest) {
      throw lines.error("the text up to here is longer than " + std::to_string(longest) + " bytes");
    }
  }
  return text;
}

namespace {

/// The ending of a file's name in small letters.
std::string small_ending(const std::filesystem::path& file) {
  std::string text = file.extension().string();
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

/// The files of a folder with one of these endings, plain or compressed, by name.
std::vector<std::filesystem::path> files_of(const std::filesystem::path& folder,
                                            const std::vector<std::string>& kinds) {
  if (!std::filesystem::is_directory(folder)) {
    throw bad_input(folder.string(), 0, "is no folder");
  }
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string kind = small_ending(without_packing(entry.path()));
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

std::filesystem::path without_packing(std::filesystem::path file) {
  const std::string last = small_ending(file);
  if (last == ".gz" || last == ".xz" || last == ".bz2" || last == ".zst") {
    file.replace_extension();
  }
  return file;
}

std::vector<std::filesystem::path> csv_files(const std::filesystem::path& folder) {
  return files_of(folder, {".csv"});
}

std::vector<std::filesystem::path> text_files(const std::filesystem::path& folder) {
  return files_of(folder, {".csv", ".txt"});
}

}  // namespace evbal
