#pragma once

#include "agents/world/city.hpp"
#include "common/error.hpp"
#include "common/scratch_folder.hpp"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace evbal {

/// Reads any bytes as a file of its kind.
using Reader = void (*)(std::string_view bytes);

/// A folder of this process's own, in memory where there is room.
inline const std::filesystem::path& folder() {
  static const ScratchFolder own(std::filesystem::exists("/dev/shm") ? "/dev/shm" : "/tmp");
  return own.path();
}

/// Writes a file into that folder and returns its path.
inline std::filesystem::path write(const std::string& name, std::string_view text) {
  std::filesystem::create_directories((folder() / name).parent_path());
  std::ofstream(folder() / name, std::ios::binary) << text;
  return folder() / name;
}

/// One square region.
inline const std::vector<Region>& regions() {
  static const std::vector<Region> all{
      {"a", {{{37.7, -122.5}, {37.7, -122.4}, {37.8, -122.4}, {37.8, -122.5}}}, {37.75, -122.45}}};
  return all;
}

/// Gives the bytes to the reader that the first of them names. It takes them or throws Error; everything else is found.
inline void read_any(std::span<const Reader> readers, const std::uint8_t* data, std::size_t size) {
  if (size == 0) {
    return;
  }
  const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  try {
    readers[data[0] % readers.size()](bytes);
  } catch (const Error&) {
  }
}

}  // namespace evbal
