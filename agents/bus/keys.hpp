#pragma once

#include "agents/bus/certificates.hpp"
#include "agents/bus/participant.hpp"

#include <filesystem>
#include <map>
#include <string>

namespace evbal {

/// Writes for each process of a run, NAME, the folder NAME into `folder`: its certificate and private key, the
/// authority's certificate, and the two documents of grants.hpp, signed. `folder`, which is there, and those in it are
/// for this user only, and so are the files. Throws Error{run_failed}.
void write_keys(const std::filesystem::path& folder, const BusAddress& address, const CertificateAuthority& authority);

/// The properties that make Fast DDS protect a participant by what is in such a folder of one process.
std::map<std::string, std::string> security_properties(const std::filesystem::path& keys);

}  // namespace evbal
