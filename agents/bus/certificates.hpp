#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

using X509 = struct x509_st;
using EVP_PKEY = struct evp_pkey_st;

namespace evbal {

/// Whom a certificate names.
struct Subject {
  std::string run;      ///< id of the run
  std::string process;  ///< "conductor", "coordinator", "faults", "agent-0"
};

/// The name as grants write it (RFC 2253): "CN=agent-0,O=4700-123".
std::string text_of(const Subject& subject);

/// The first bytes of the GUID of every participant that has proved itself by such a certificate: a hash of the name
/// (DDS Security 1.1, section 9.3.3), which the others check.
using SubjectHash = std::array<std::uint8_t, 6>;

/// The hash of a subject's name.
SubjectHash hash_of(const Subject& subject);

/// A certificate and its private key, as PEM.
struct Credentials {
  std::string certificate;  ///< X.509
  std::string key;          ///< of the elliptic curve P-256
};

/// Who says which certificates and documents are genuine. All its members throw Error{run_failed} if OpenSSL fails.
/// What it signs is valid from 2000 to 2100, so that the clocks of hosts do not matter.
class CertificateAuthority {
 public:
  /// A new one. Its private key is never written anywhere.
  static CertificateAuthority made(const std::string& name);

  /// One's own: certificate `ca.pem` and private key `ca-key.pem` of a folder. Throws Error{bad_input} if they cannot
  /// be used.
  static CertificateAuthority read(const std::filesystem::path& folder);

  /// Its certificate, as PEM.
  std::string certificate() const;

  /// A new key, and a certificate for it.
  Credentials issue(const Subject& subject) const;

  /// The text as a signed document (S/MIME).
  std::string sign(const std::string& text) const;

 private:
  CertificateAuthority(std::shared_ptr<X509> certificate, std::shared_ptr<EVP_PKEY> key);

  std::shared_ptr<X509> certificate_;
  std::shared_ptr<EVP_PKEY> key_;
};

}  // namespace evbal
