#include "agents/bus/certificates.hpp"

#include "common/error.hpp"

#include <openssl/bio.h>
#include <openssl/err.h>
#include <openssl/evp.h>
#include <openssl/pem.h>
#include <openssl/pkcs7.h>
#include <openssl/rand.h>
#include <openssl/x509v3.h>

#include <cstdio>
#include <functional>
#include <utility>

namespace evbal {
namespace {

constexpr auto valid_from = "20000101000000Z";
constexpr auto valid_until = "21000101000000Z";
constexpr long version_3 = 2;

template <auto release>
struct ReleasedBy {
  void operator()(auto* object) const { release(object); }
};
using Bio = std::unique_ptr<BIO, ReleasedBy<BIO_free_all>>;
using Name = std::unique_ptr<X509_NAME, ReleasedBy<X509_NAME_free>>;
using Signature = std::unique_ptr<PKCS7, ReleasedBy<PKCS7_free>>;
using Extension = std::unique_ptr<X509_EXTENSION, ReleasedBy<X509_EXTENSION_free>>;

/// What OpenSSL gives, unless it failed.
template <class Result>
Result checked(Result result) {
  if (!result) {
    std::array<char, 256> reason{};
    ERR_error_string_n(ERR_get_error(), reason.data(), reason.size());
    throw run_failed(std::string("OpenSSL cannot make a certificate or a signature: ") + reason.data());
  }
  return result;
}

/// What `write` puts into a buffer of OpenSSL.
std::string written(const std::function<int(BIO*)>& write) {
  const Bio bio(checked(BIO_new(BIO_s_mem())));
  checked(write(bio.get()));
  char* data = nullptr;
  const long size = BIO_get_mem_data(bio.get(), &data);
  return {data, static_cast<std::size_t>(size)};
}

Bio reader_of(const std::string& text) {
  return Bio(checked(BIO_new_mem_buf(text.data(), static_cast<int>(text.size()))));
}

std::shared_ptr<EVP_PKEY> new_key() {
  return {checked(EVP_EC_gen("P-256")), EVP_PKEY_free};
}

void add_to(X509_NAME* name, const char* field, const std::string& value) {
  checked(X509_NAME_add_entry_by_txt(name, field, MBSTRING_ASC, reinterpret_cast<const unsigned char*>(value.c_str()),
                                     -1, -1, 0));
}

Name x509_name_of(const Subject& subject) {
  Name name(checked(X509_NAME_new()));
  add_to(name.get(), "O", subject.run);
  add_to(name.get(), "CN", subject.process);
  return name;
}

void extend(X509* certificate, int what, const char* value) {
  const Extension extension(checked(X509V3_EXT_conf_nid(nullptr, nullptr, what, value)));
  checked(X509_add_ext(certificate, extension.get(), -1));
}

/// A certificate that nobody has signed yet.
std::shared_ptr<X509> unsigned_certificate(X509_NAME* subject, X509_NAME* issuer, EVP_PKEY* key) {
  std::shared_ptr<X509> certificate(checked(X509_new()), X509_free);
  std::uint64_t serial = 0;
  checked(RAND_bytes(reinterpret_cast<unsigned char*>(&serial), sizeof serial) == 1);
  X509_set_version(certificate.get(), version_3);
  checked(ASN1_INTEGER_set_uint64(X509_get_serialNumber(certificate.get()), serial));
  checked(ASN1_TIME_set_string_X509(X509_getm_notBefore(certificate.get()), valid_from));
  checked(ASN1_TIME_set_string_X509(X509_getm_notAfter(certificate.get()), valid_until));
  checked(X509_set_subject_name(certificate.get(), subject));
  checked(X509_set_issuer_name(certificate.get(), issuer));
  checked(X509_set_pubkey(certificate.get(), key));
  return certificate;
}

std::string pem_of(X509* certificate) {
  return written([&](BIO* out) { return PEM_write_bio_X509(out, certificate); });
}

using File = std::unique_ptr<std::FILE, ReleasedBy<std::fclose>>;

File opened(const std::filesystem::path& file) {
  File stream(std::fopen(file.c_str(), "r"));
  if (!stream) {
    throw bad_input(file, 0,
                    "cannot be read; the folder of one's own CA holds its certificate, `ca.pem`, and its private key, "
                    "`ca-key.pem`");
  }
  return stream;
}

/// A key that is locked stays so: nobody is asked.
int no_password(char* /*buffer*/, int /*size*/, int /*writing*/, void* /*unused*/) {
  return 0;
}

bool is_p256(EVP_PKEY* key) {
  std::array<char, 64> group{};
  return EVP_PKEY_get_group_name(key, group.data(), group.size(), nullptr) == 1 &&
         (std::string(group.data()) == "prime256v1" || std::string(group.data()) == "P-256");
}

}  // namespace

std::string text_of(const Subject& subject) {
  return "CN=" + subject.process + ",O=" + subject.run;
}

SubjectHash hash_of(const Subject& subject) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  checked(X509_NAME_digest(x509_name_of(subject).get(), EVP_sha256(), digest.data(), nullptr));
  // A one bit, then the hash's first 47 bits.
  SubjectHash hash{};
  unsigned char carried = 1;
  for (std::size_t i = 0; i < hash.size(); ++i) {
    hash[i] = static_cast<std::uint8_t>(carried << 7 | digest[i] >> 1);
    carried = digest[i] & 1;
  }
  return hash;
}

CertificateAuthority::CertificateAuthority(std::shared_ptr<X509> certificate, std::shared_ptr<EVP_PKEY> key)
    : certificate_(std::move(certificate)), key_(std::move(key)) {}

CertificateAuthority CertificateAuthority::made(const std::string& name) {
  auto key = new_key();
  const Name own(checked(X509_NAME_new()));
  add_to(own.get(), "CN", name);
  auto certificate = unsigned_certificate(own.get(), own.get(), key.get());
  extend(certificate.get(), NID_basic_constraints, "critical,CA:TRUE");
  extend(certificate.get(), NID_key_usage, "critical,keyCertSign,digitalSignature");
  checked(X509_sign(certificate.get(), key.get(), EVP_sha256()));
  return {std::move(certificate), std::move(key)};
}

CertificateAuthority CertificateAuthority::read(const std::filesystem::path& folder) {
  const auto certificate_file = folder / "ca.pem";
  const auto key_file = folder / "ca-key.pem";
  std::shared_ptr<X509> certificate(PEM_read_X509(opened(certificate_file).get(), nullptr, no_password, nullptr),
                                    X509_free);
  if (!certificate) {
    throw bad_input(certificate_file, 0, "is no certificate; give one as PEM");
  }
  if (X509_check_ca(certificate.get()) == 0 || X509_check_issued(certificate.get(), certificate.get()) != X509_V_OK ||
      X509_get_signature_nid(certificate.get()) != NID_ecdsa_with_SHA256) {
    throw bad_input(certificate_file, 0,
                    "is no certificate of a CA that has signed itself by ECDSA with SHA-256; docs/security.md says how "
                    "to make one");
  }
  std::shared_ptr<EVP_PKEY> key(PEM_read_PrivateKey(opened(key_file).get(), nullptr, no_password, nullptr),
                                EVP_PKEY_free);
  if (!key) {
    throw bad_input(key_file, 0, "is no private key without a password; give one as PEM");
  }
  if (!is_p256(key.get()) || X509_check_private_key(certificate.get(), key.get()) != 1) {
    throw bad_input(key_file, 0, "is not the key of `ca.pem` on the elliptic curve P-256; give that");
  }
  return {std::move(certificate), std::move(key)};
}

std::string CertificateAuthority::certificate() const {
  return pem_of(certificate_.get());
}

Credentials CertificateAuthority::issue(const Subject& subject) const {
  const auto key = new_key();
  const auto certificate =
      unsigned_certificate(x509_name_of(subject).get(), X509_get_subject_name(certificate_.get()), key.get());
  extend(certificate.get(), NID_basic_constraints, "critical,CA:FALSE");
  checked(X509_sign(certificate.get(), key_.get(), EVP_sha256()));
  return {.certificate = pem_of(certificate.get()), .key = written([&](BIO* out) {
                                                      return PEM_write_bio_PrivateKey(out, key.get(), nullptr, nullptr,
                                                                                      0, nullptr, nullptr);
                                                    })};
}

std::string CertificateAuthority::sign(const std::string& text) const {
  constexpr int flags = PKCS7_TEXT | PKCS7_DETACHED;
  const Signature signature(checked(PKCS7_sign(certificate_.get(), key_.get(), nullptr, reader_of(text).get(), flags)));
  return written([&](BIO* out) { return SMIME_write_PKCS7(out, signature.get(), reader_of(text).get(), flags); });
}

}  // namespace evbal
