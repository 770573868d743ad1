#include "acquisition/foundation/large_pages.hpp"

#include <cstdint>
#include <sys/mman.h>

namespace tapfit::acquisition {

void prefer_large_pages(Eigen::Ref<Eigen::MatrixXd> samples) {
  constexpr std::uintptr_t page = 4096;
  constexpr std::size_t least = 4 << 20;
  const std::size_t size =
      static_cast<std::size_t>(samples.size()) * sizeof(double);
  if (size < least) return;
  const auto begin = reinterpret_cast<std::uintptr_t>(samples.data());
  const std::uintptr_t first = (begin + page - 1) / page * page;
  const std::uintptr_t last = (begin + size) / page * page;
  // What it answers does not matter.
  (void)::madvise(reinterpret_cast<void*>(first), last - first, MADV_HUGEPAGE);
}

}  // namespace tapfit::acquisition
