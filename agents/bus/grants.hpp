#pragma once

#include "agents/bus/certificates.hpp"

#include <string>

/// The two documents with which DDS Security (1.1, section 9.4) says what is protected and who may do what, as XML.
namespace evbal {

/// What holds in a domain: nobody joins without a certificate and a grant, and all that is written or told of writers
/// and readers is encrypted.
std::string governance_of(int domain);

/// What one participant may do: write to the topics on which it has a say, and read those to which it listens
/// (topics.hpp).
std::string grant_of(const Subject& subject, int participant, int domain);

}  // namespace evbal
