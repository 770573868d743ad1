// Standard error while screens are up.
#pragma once

#include <cstdio>

namespace tapfit::tui {

/// Keeps standard error away from the screen until it is destroyed; what was
/// said comes out then.
class HeldErrors {
 public:
  HeldErrors();
  ~HeldErrors();
  HeldErrors(const HeldErrors&) = delete;
  HeldErrors& operator=(const HeldErrors&) = delete;

 private:
  std::FILE* held_;
  int real_;
};

}  // namespace tapfit::tui
