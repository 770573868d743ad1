#include "updating/structure/solve/blas_turn.hpp"

#include <dlfcn.h>

namespace tapfit::structure {
namespace {

// A function of the BLAS that was loaded; null: it is not OpenBLAS.
template <typename Function>
Function loaded(const char* name) {
  return reinterpret_cast<Function>(dlsym(RTLD_DEFAULT, name));
}

bool is_for_one_thread() {
  const auto parallel = loaded<int (*)()>("openblas_get_parallel");
  if (parallel == nullptr) return false;
  if (parallel() == 0) return true;
  const auto set_threads = loaded<void (*)(int)>("openblas_set_num_threads");
  if (set_threads != nullptr) set_threads(1);
  return false;
}

}  // namespace

std::unique_lock<std::mutex> blas_turn() {
  static const bool alone = is_for_one_thread();
  static std::mutex guard;
  return alone ? std::unique_lock(guard) : std::unique_lock<std::mutex>();
}

}  // namespace tapfit::structure
