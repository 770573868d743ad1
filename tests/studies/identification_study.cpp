// Modes found, lost and invented on random plates, and how exact they are.
//
//   identification_study [SEED [COUNT]]
//
// Three times COUNT simply supported plates of 8 to 20 modes in the band:
// noise of any level up to 5 % of each FRF's rms, none, and 5 %. Errors are
// those of the worst mode of each plate.
#include "tests/modal/support/random_plate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <numeric>
#include <vector>

namespace tapfit::test {
namespace {

/// Noise of a plate's FRFs, given the plate's random numbers.
using Level = std::function<double(std::mt19937_64&)>;

void print(const char* what, std::vector<double> values, double limit) {
  if (values.empty()) return;
  std::ranges::sort(values);
  const auto within = std::ranges::upper_bound(values, limit) - values.begin();
  fmt::print(
      "  {}: median {:.2g}, 98 % below {:.2g}, largest {:.2g}; {} of {} "
      "within {:.2g}\n",
      what,
      values[values.size() / 2],
      values[values.size() * 98 / 100],
      values.back(),
      within,
      values.size(),
      limit);
}

void study(const char* title,
           unsigned seed,
           unsigned count,
           const Level& level,
           double frequency_limit,
           double damping_limit) {
  std::vector<double> frequency;
  std::vector<double> damping;
  std::vector<double> unlike;
  std::vector<double> error;
  std::vector<double> gain;
  std::string wrong;
  for (unsigned k = 0; k < count; ++k) {
    std::mt19937_64 random(seed + k);
    const RandomPlate plate = random_plate(random);
    const double noise = level(random);
    const modal::ModeSet found =
        modal::identify_modes(measure(plate, noise, random), {});
    const std::optional<PlateErrors> errors = errors_of(found, plate);
    if (!errors) {
      wrong += fmt::format("  seed {}: {} of {} modes, noise {:.3f}\n",
                           seed + k,
                           found.modes.size(),
                           plate.in_band,
                           noise);
      continue;
    }
    frequency.push_back(errors->frequency);
    damping.push_back(errors->damping);
    unlike.push_back(1.0 - errors->mac);
    error.push_back(found.synthesis_error);
    gain.push_back(found.synthesis_error / found.unrefined_error);
  }
  fmt::print("{}: {} of {} plates with exactly their modes\n{}",
             title,
             frequency.size(),
             count,
             wrong);
  print("frequency", frequency, frequency_limit);
  print("damping", damping, damping_limit);
  print("1 - MAC", unlike, 0.1);
  print("synthesis error", error, 0.1);
  print("synthesis error over that before refinement", gain, 1.0);
  std::fflush(stdout);
}

}  // namespace
}  // namespace tapfit::test

int main(int argc, char** argv) {
  using tapfit::test::study;
  const auto seed = static_cast<unsigned>(argc > 1 ? std::atoi(argv[1]) : 1000);
  const auto count = static_cast<unsigned>(argc > 2 ? std::atoi(argv[2]) : 200);
  study(
      "Noise up to 5 %",
      seed,
      count,
      [](std::mt19937_64& random) {
        return 0.05 * std::uniform_real_distribution<double>()(random);
      },
      1e-3,
      5e-2);
  study(
      "No noise", seed, count, [](auto&) { return 0.0; }, 1e-4, 1e-3);
  study(
      "Noise of 5 %", seed, count, [](auto&) { return 0.05; }, 1e-3, 5e-2);
  return 0;
}
