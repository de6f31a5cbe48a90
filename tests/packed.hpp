#pragma once

#include <archive.h>
#include <archive_entry.h>

#include <string>

namespace evbal {

/// `text` as a file packed by gzip or xz.
inline std::string packed(const std::string& text, const std::string& how) {
  std::string bytes(text.size() + 10'000, '\0');
  std::size_t used = 0;
  archive* writer = archive_write_new();
  archive_write_set_format_raw(writer);
  archive_write_add_filter_by_name(writer, how.c_str());
  archive_write_open_memory(writer, bytes.data(), bytes.size(), &used);
  archive_entry* entry = archive_entry_new();
  archive_entry_set_filetype(entry, AE_IFREG);
  archive_write_header(writer, entry);
  archive_write_data(writer, text.data(), text.size());
  archive_entry_free(entry);
  archive_write_close(writer);
  archive_write_free(writer);
  return bytes.substr(0, used);
}

}  // namespace evbal
