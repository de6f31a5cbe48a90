#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace evbal {

/// The folder of the program that is running, or of the Python module that this code is part of. Throws
/// Error{run_failed} where there is no /proc.
std::filesystem::path own_folder();

/// The program that a command names: a path, else one beside this program, else one in $PATH. Empty if there is none
/// that may be executed; folders that cannot be read are passed over.
std::filesystem::path find_program(const std::string& name);

/// What is shipped with the programs, such as "cities" or "scenarios": the folder share/evbal/NAME that stands nearest
/// above own_folder(), in an installation as in a build tree; empty if there is none.
std::filesystem::path shipped_folder(const std::string& name);

/// Names of what is shipped in the folder NAME, sorted.
std::vector<std::string> shipped_names(const std::string& name);

/// The file that a command line names: a path, or without a folder and where there is no such file, the name of one
/// that is shipped in the folder NAME. Throws Error{bad_input} if there is neither.
std::filesystem::path find_shipped(const std::string& name, const std::filesystem::path& given);

}  // namespace evbal
