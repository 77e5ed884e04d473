#pragma once

#include <stdexcept>
#include <unistd.h>

namespace shapegauge::test {

/// While it lives, the process has the rights of an ordinary user: permissions do not bind root.
class OrdinaryUser {
 public:
  OrdinaryUser() : before_(::geteuid()) {
    if (before_ == 0 && ::seteuid(65534) != 0) throw std::runtime_error("cannot give up root's rights");
  }
  OrdinaryUser(const OrdinaryUser&) = delete;
  OrdinaryUser& operator=(const OrdinaryUser&) = delete;
  OrdinaryUser(OrdinaryUser&&) = delete;
  OrdinaryUser& operator=(OrdinaryUser&&) = delete;
  ~OrdinaryUser() {
    if (::seteuid(before_) != 0) ::_exit(1);
  }

 private:
  uid_t before_;
};

}  // namespace shapegauge::test
