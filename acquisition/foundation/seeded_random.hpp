// Random numbers that are the same on every machine for the same seed.
//
// The engine (mt19937_64) is fixed by the C++ standard, the distributions of
// <random> are not; so the few that are needed are written out here. Normal
// deviates by the polar method: G. Marsaglia and T. A. Bray, "A convenient
// method for generating normal variables", SIAM Review 6(3), 1964, p. 260-264.
#pragma once

#include <cstdint>
#include <optional>
#include <random>
#include <string_view>

namespace tapfit::acquisition {

class SeededRandom {
 public:
  /// @param seed of the whole simulation
  /// @param purpose, index name an independent stream, so that more numbers
  ///   drawn for one purpose leave those of the others as they were
  SeededRandom(std::uint64_t seed,
               std::string_view purpose,
               std::uint64_t index = 0);

  /// Uniform in [low, high).
  [[nodiscard]] double uniform(double low, double high);

  /// Gaussian with mean 0 and standard deviation 1.
  [[nodiscard]] double normal();

  /// A factor about 1: exp(sd * normal), kept within exp(+-2.5 sd).
  [[nodiscard]] double scatter(double sd);

 private:
  std::mt19937_64 engine_;
  std::optional<double> spare_;
};

}  // namespace tapfit::acquisition
