#include "tui/screen/held_errors.hpp"

#include <array>
#include <cstddef>
#include <unistd.h>

namespace tapfit::tui {

HeldErrors::HeldErrors() : held_(std::tmpfile()), real_(dup(STDERR_FILENO)) {
  std::fflush(stderr);
  if (held_ != nullptr && real_ >= 0) dup2(fileno(held_), STDERR_FILENO);
}

HeldErrors::~HeldErrors() {
  std::fflush(stderr);
  if (real_ >= 0) {
    dup2(real_, STDERR_FILENO);
    close(real_);
  }
  if (held_ == nullptr) return;
  std::rewind(held_);
  std::array<char, 4096> buffer{};
  while (const std::size_t n =
             std::fread(buffer.data(), 1, buffer.size(), held_)) {
    std::fwrite(buffer.data(), 1, n, stderr);
  }
  std::fclose(held_);
}

}  // namespace tapfit::tui
