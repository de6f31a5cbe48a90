#pragma once

#include <vector>

namespace evbal {

/// A DDS domain with enough following ones that the UDP ports of `participants` processes meet those of no other run
/// on this host. Held as long as the object lives; the kernel frees it when the process dies, however it does, and no
/// file is left.
class DomainLock {
 public:
  /// Throws Error{run_failed} if no domain is free, or if the system lets none be locked.
  explicit DomainLock(int participants);
  ~DomainLock();
  DomainLock(const DomainLock&) = delete;
  DomainLock& operator=(const DomainLock&) = delete;

  /// The DDS domain that is locked.
  int domain() const { return domain_; }

 private:
  int domain_ = 0;
  std::vector<int> sockets_;
};

}  // namespace evbal
