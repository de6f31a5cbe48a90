#pragma once

#include "experiments/scenario/scenario.hpp"

#include <filesystem>
#include <string>

/// The files beside its scenario that a day is played with: the same scenario with others is another day.
namespace evbal {

/// Fingerprints of their contents.
struct InputDigests {
  std::string pack;         ///< of the city
  std::string model;        ///< empty where there is no such file, which another coordinator than evbal's may not need
  std::string coordinator;  ///< of the files that its command names; empty without one
};

/// Throws Error{bad_input} if a file cannot be read.
InputDigests input_digests(const Scenario& scenario);

/// Of a model's file; empty if there is none.
std::string model_digest(const std::filesystem::path& file);

/// Of the program and of the files that a coordinator's command names, in turn; empty without a command.
/// Throws Error{bad_input} if there is no such program.
std::string command_digest(const Command& coordinator);

/// Of a city pack's files, with their names: all but README.md and model.json, which is an input of its own.
std::string pack_digest(const std::filesystem::path& folder);

}  // namespace evbal
