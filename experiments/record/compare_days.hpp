#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace evbal {

/// "served is 3, the replay gives 4".
std::string disagreement(const std::string& name, const std::string& recorded, const std::string& replayed);

/// The first difference, in the order of ticks, between two files of DayFile as "run.sqlite: table, tick 41, region 7:
/// column is 3, the replay gives 4". Columns of a message's origin are left out, and what befell
/// processes from outside.
std::optional<std::string> compare_days(const std::filesystem::path& recorded, const std::filesystem::path& replayed);

}  // namespace evbal
