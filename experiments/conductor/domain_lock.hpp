#pragma once

#include <string>
#include <vector>

namespace evbal {

/// A DDS domain, and as many following ones as are needed so that no other run on this host uses the UDP ports of
/// `participants` processes. Held as long as the object lives; the kernel frees it when the process dies, however it
/// does, and no file is left.
class DomainLock {
 public:
  static constexpr int first_domain = 10;  ///< the low ones belong to others on this host

  /// The first domain from `from` on that no other run holds and of whose ports no program has one. Throws
  /// Error{run_failed} if there is none, or if the system lets none be locked.
  explicit DomainLock(int participants, int from = first_domain);
  ~DomainLock();
  DomainLock(const DomainLock&) = delete;
  DomainLock& operator=(const DomainLock&) = delete;

  /// The DDS domain that is locked.
  int domain() const { return domain_; }

  /// Why one of the participants cannot have its ports now, in a few words; empty if all can. To be asked while none
  /// of them has them.
  std::string complaint() const;

 private:
  int participants_;
  int domain_ = 0;
  std::vector<int> sockets_;
};

}  // namespace evbal
