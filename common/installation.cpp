#include "common/installation.hpp"

#include "common/error.hpp"
#include "common/suggestion.hpp"

#include <dlfcn.h>
#include <link.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>

namespace evbal {

namespace fs = std::filesystem;

fs::path own_folder() {
  Dl_info symbol{};
  link_map* object = nullptr;
  void* const here = reinterpret_cast<void*>(&own_folder);  // NOLINT(cppcoreguidelines-pro-type-reinterpret-cast)
  if (dladdr1(here, &symbol, reinterpret_cast<void**>(&object), RTLD_DL_LINKMAP) != 0 && *object->l_name != '\0') {
    return fs::canonical(object->l_name).parent_path();
  }
  std::error_code failed;
  const fs::path program = fs::read_symlink("/proc/self/exe", failed);
  if (failed) {
    throw run_failed("/proc/self/exe: cannot be read: " + failed.message() + "; evbal needs /proc");
  }
  return program.parent_path();
}

fs::path find_program(const std::string& name) {
  std::vector<fs::path> candidates = {name};
  if (name.find('/') == std::string::npos) {
    candidates = {own_folder() / name};
    const char* path = std::getenv("PATH");
    std::istringstream folders(path == nullptr ? "" : path);
    for (std::string folder; std::getline(folders, folder, ':');) {
      candidates.push_back(fs::path(folder) / name);
    }
  }
  const auto found = std::ranges::find_if(candidates, [](const fs::path& candidate) {
    std::error_code unreadable;
    return fs::is_regular_file(candidate, unreadable) && access(candidate.c_str(), X_OK) == 0;
  });
  return found == candidates.end() ? fs::path() : *found;
}

fs::path shipped_folder(const std::string& name) {
  for (fs::path folder = own_folder(); folder.has_relative_path(); folder = folder.parent_path()) {
    std::error_code unreadable;
    if (fs::path shipped = folder / "share" / "evbal" / name; fs::is_directory(shipped, unreadable)) {
      return shipped;
    }
  }
  return {};
}

std::vector<std::string> shipped_names(const std::string& name) {
  std::vector<std::string> names;
  std::error_code unreadable;
  for (fs::directory_iterator entry(shipped_folder(name), unreadable), end; !unreadable && entry != end;
       entry.increment(unreadable)) {
    names.push_back(entry->path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

fs::path find_shipped(const std::string& name, const fs::path& given) {
  if (given.has_parent_path() || fs::exists(given)) {
    return given;
  }
  if (fs::path shipped = shipped_folder(name) / given; fs::exists(shipped)) {
    return shipped;
  }
  throw bad_input(given.string(), 0,
                  "cannot be read" + did_you_mean(given.string(), shipped_names(name)) +
                      "; give an existing YAML file, or the name of one that `evbal list " + name + "` shows");
}

}  // namespace evbal
