#include "updating/measurement/damped_line.hpp"

#include "acquisition/foundation/constants.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

namespace tapfit::updating {

Eigen::VectorXcd damped_line(std::array<double, 2> band_hz,
                             double block_s,
                             const DampedLineOptions& options) {
  const double least = 5.0 / block_s;
  // Lines one peak width apart carry nearly independent information.
  const double octaves = std::log(band_hz[1] / std::max(band_hz[0], 1e-3));
  const double stretch = std::max(
      1.0, std::expm1(octaves / (options.max_lines - 1)) / options.delta);
  std::vector<std::complex<double>> s;
  double omega = two_pi * band_hz[0];
  while (omega <= two_pi * band_hz[1] * (1.0 + 1e-12)) {
    const double sigma = std::max(options.delta * omega, least);
    s.emplace_back(sigma, omega);
    omega += stretch * sigma;
  }
  return Eigen::Map<Eigen::VectorXcd>(s.data(),
                                      static_cast<Eigen::Index>(s.size()));
}

std::string describe_line(std::array<double, 2> band_hz,
                          const Eigen::VectorXcd& s,
                          const DampedLineOptions& options) {
  if (s.size() == 0) return "no lines";
  return fmt::format(
      "{} lines from {:g} to {:g} Hz on s = sigma + j omega, sigma = {:g} "
      "omega and at least {:.3g} 1/s",
      s.size(),
      band_hz[0],
      band_hz[1],
      options.delta,
      s.real().minCoeff());
}

}  // namespace tapfit::updating
