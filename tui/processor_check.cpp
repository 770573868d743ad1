// Built for newer processors only (cmake/flags.cmake), the program says so on
// an older one, ahead of all else: its objects are made with such instructions
// before main() begins. This file is compiled for any x86-64 processor.
#include <string_view>
#include <sys/platform/x86.h>
#include <unistd.h>

namespace {

[[gnu::constructor(101)]] void check_processor() {
  if (CPU_FEATURE_ACTIVE(AVX2) && CPU_FEATURE_ACTIVE(FMA) &&
      CPU_FEATURE_ACTIVE(BMI2)) {
    return;
  }
  constexpr std::string_view text =
      "tapfit: this program is built for processors with AVX2, FMA and BMI2, "
      "which this one has not (build it here, or elsewhere with "
      "-DTAPFIT_AVX2=OFF)\n";
  (void)!write(STDERR_FILENO, text.data(), text.size());
  _exit(70);
}

}  // namespace
