#include "tests/end_to_end/small_bundle.hpp"

#include "tests/end_to_end/run_program.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <stdexcept>

namespace tapfit::end_to_end {

namespace fs = std::filesystem;

fs::path copy_of_small_bundle() {
  static const fs::path made_once = [] {
    const fs::path folder = scratch_folder("small-bundle") / "test";
    const auto made = run_tapfit(fmt::format(
        "simulate '{}' --structure ladder --seed 5 --runs 6 --hits 3 "
        "--effect added-mass@200=0.05",
        folder.string()));
    if (made.exit_status != 0) throw std::runtime_error(made.err);
    return folder;
  }();
  const fs::path bundle = fresh_folder() / "bundle";
  fs::remove_all(bundle);
  fs::copy(made_once, bundle, fs::copy_options::recursive);
  return bundle;
}

void WithCache::SetUp() {
  cache_ = fresh_folder() / "cache";
  ::setenv("XDG_CACHE_HOME", cache_.c_str(), 1);
  ::unsetenv("TAPFIT_NO_CACHE");
}

void WithCache::TearDown() {
  ::unsetenv("XDG_CACHE_HOME");
  ::setenv("TAPFIT_NO_CACHE", "1", 1);
}

}  // namespace tapfit::end_to_end
