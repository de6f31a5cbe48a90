#include "agents/bus/keys.hpp"

#include "agents/bus/grants.hpp"
#include "common/error.hpp"
#include "common/files.hpp"

#include <string_view>

namespace evbal {
namespace {

namespace fs = std::filesystem;

constexpr auto authority_file = "ca.pem";
constexpr auto certificate_file = "certificate.pem";
constexpr auto key_file = "key.pem";
constexpr auto governance_file = "governance.p7s";
constexpr auto grant_file = "grant.p7s";

/// In a folder that nobody else may enter, so that there is no moment in which another may read it.
void write_for_us_only(const fs::path& file, std::string_view text) {
  write_file(file, text);
  fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write);
}

}  // namespace

void write_keys(const fs::path& folder, const BusAddress& address, const CertificateAuthority& authority) {
  try {
    fs::permissions(folder, fs::perms::owner_all);
    const std::string governance = authority.sign(governance_of(address.domain));
    for (int participant = 0; participant < address.participants; ++participant) {
      const Subject subject{.run = address.run, .process = name_of(participant)};
      const fs::path own = folder / subject.process;
      fs::create_directory(own);
      fs::permissions(own, fs::perms::owner_all);
      const Credentials credentials = authority.issue(subject);
      write_for_us_only(own / key_file, credentials.key);
      write_for_us_only(own / certificate_file, credentials.certificate);
      write_for_us_only(own / authority_file, authority.certificate());
      write_for_us_only(own / governance_file, governance);
      write_for_us_only(own / grant_file, authority.sign(grant_of(subject, participant, address.domain)));
    }
  } catch (const fs::filesystem_error& error) {
    throw run_failed(std::string("keys cannot be written: ") + error.what());
  }
}

std::map<std::string, std::string> security_properties(const fs::path& keys) {
  const auto file = [&](const char* name) { return "file://" + fs::absolute(keys / name).string(); };
  return {{"dds.sec.auth.plugin", "builtin.PKI-DH"},
          {"dds.sec.auth.builtin.PKI-DH.identity_ca", file(authority_file)},
          {"dds.sec.auth.builtin.PKI-DH.identity_certificate", file(certificate_file)},
          {"dds.sec.auth.builtin.PKI-DH.private_key", file(key_file)},
          {"dds.sec.auth.builtin.PKI-DH.preferred_key_agreement", "ECDH"},  // of version 3; the other is slower
          {"dds.sec.access.plugin", "builtin.Access-Permissions"},
          {"dds.sec.access.builtin.Access-Permissions.permissions_ca", file(authority_file)},
          {"dds.sec.access.builtin.Access-Permissions.governance", file(governance_file)},
          {"dds.sec.access.builtin.Access-Permissions.permissions", file(grant_file)},
          {"dds.sec.crypto.plugin", "builtin.AES-GCM-GMAC"}};
}

}  // namespace evbal
