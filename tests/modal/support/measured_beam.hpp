// Measured FRFs of a suspended beam, made by others: a roving hammer past one
// accelerometer. Their folder lies beside the project and is not part of it.
#pragma once

#include "signal/frf_set/frf_set.hpp"

#include <fmt/format.h>

#include <array>
#include <complex>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

namespace tapfit::test {

inline const std::filesystem::path beam_data =
    TAPFIT_SOURCE_DIR "/../shared/data/suspended-beam-frf";

/// Lines of frequency, real and imaginary part; anything else is heading.
inline signal::Frf read_frf(const std::filesystem::path& file,
                            double low_hz,
                            double high_hz,
                            std::vector<double>& hz) {
  std::ifstream in(file);
  std::vector<std::complex<double>> values;
  hz.clear();
  for (std::string line; std::getline(in, line);) {
    std::istringstream numbers(line);
    double f = 0.0;
    double re = 0.0;
    double im = 0.0;
    if (!(numbers >> f >> re >> im) || f < low_hz || f > high_hz) continue;
    hz.push_back(f);
    values.emplace_back(re, im);
  }
  signal::Frf frf;
  frf.H = Eigen::Map<Eigen::VectorXcd>(
      values.data(), static_cast<Eigen::Index>(values.size()));
  return frf;
}

/// @param points of the hits, in their order; the accelerometer stands at the
/// fourth
inline signal::FrfSet read_beam(const std::array<int, 9>& points) {
  signal::FrfSet set;
  std::vector<double> hz;
  for (int point = 1; point <= 9; ++point) {
    signal::Frf frf = read_frf(beam_data / fmt::format("ASCII{:05d}", point) /
                                   fmt::format("Hxysv{:05d}.txt", point),
                               65.0,
                               1010.0,
                               hz);
    frf.reference = {points[static_cast<std::size_t>(point - 1)], 1, 1};
    frf.response = {points[3], 1, -1};  // at z = 0.5 m
    frf.run = static_cast<std::size_t>(point - 1);
    set.frfs.push_back(std::move(frf));
  }
  set.s.resize(static_cast<Eigen::Index>(hz.size()));
  for (std::size_t k = 0; k < hz.size(); ++k) {
    set.s(static_cast<Eigen::Index>(k)) = {0.0, 2.0 * std::numbers::pi * hz[k]};
  }
  return set;
}

}  // namespace tapfit::test
