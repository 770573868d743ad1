// How often the truth lies within the bands that estimates state. For tests and
// the study over seeds.
#pragma once

#include "signal/checks/confidence_band.hpp"
#include "signal/estimate/estimate_frfs.hpp"
#include "tests/signal/support/generated_test.hpp"

#include <functional>

namespace tapfit::signal {

struct Coverage {
  double share = 0.0;  // of lines whose truth lies within the 95 % circle
  double parts = 0.0;  // of real and imaginary parts within their 95 % band
  double bias = 0.0;   // mean error over mean |H|
};

// Poles of modes that outlast the block, as identified from a test.
using IdentifiedPoles = std::function<Eigen::VectorXcd(const GeneratedTest&)>;

// Where poles are identified, of FFT lines without a window, completed behind
// the block's end and against the exact FRF.
inline Coverage coverage(const std::vector<TestMode>& modes,
                         const GeneratedOptions& options,
                         bool damped_line,
                         int repeats,
                         const IdentifiedPoles& identified = {}) {
  GeneratedOptions quiet = options;
  quiet.response_noise = quiet.force_noise = quiet.spread = 0.0;
  int inside = 0;
  int parts = 0;
  int lines = 0;
  std::complex<double> sum = 0.0;
  double size = 0.0;
  const GeneratedTest clean = generate_test(modes, quiet);
  for (int r = 0; r < repeats; ++r) {
    GeneratedOptions o = options;
    o.seed = options.seed + static_cast<unsigned>(r);
    GeneratedTest test = generate_test(modes, o);
    test.bundle.band_hz = {5.0, 100.0};
    FrfSet set;
    if (damped_line) {
      Eigen::VectorXcd s(140);
      s.real().setConstant(5.0);
      s.imag().setLinSpaced(
          140, 2.0 * std::numbers::pi * 5.0, 2.0 * std::numbers::pi * 100.0);
      set = estimate_frfs_at(test.bundle, test.recordings, test.hits, s, {});
    } else {
      FrfOptions frf;
      if (identified) {
        frf.window.end_value = 1.0;
        frf.lasting_poles = identified(test);
      }
      set = estimate_frfs(test.bundle, test.recordings, test.hits, frf);
    }
    // Against the noise-free estimate, so that truncation is not counted.
    FrfSet truth =
        estimate_frfs_at(test.bundle, clean.recordings, clean.hits, set.s, {});
    for (Eigen::Index i = 0; identified && i < set.lines(); ++i) {
      truth.frfs[0].H(i) = exact_frf(modes, set.s(i));
    }
    const Eigen::VectorXd radius = confidence_radius(set.frfs[0]);
    const Eigen::VectorXd reach = confidence_reach(set.frfs[0]);
    for (Eigen::Index i = 0; i < set.lines(); ++i) {
      const std::complex<double> error = set.frfs[0].H(i) - truth.frfs[0].H(i);
      inside += std::abs(error) <= radius(i);
      parts += std::abs(error.real()) <= reach(i);
      parts += std::abs(error.imag()) <= reach(i);
      ++lines;
      sum += error;
      size += std::abs(truth.frfs[0].H(i));
    }
  }
  return {static_cast<double>(inside) / lines,
          static_cast<double>(parts) / (2.0 * lines),
          std::abs(sum) / size};
}

inline GeneratedOptions noisy(int hits) {
  GeneratedOptions o;
  o.block = 2048;
  o.gap = 4096;
  o.hits = hits;
  o.response_noise = 0.02;
  o.force_noise = 0.01;
  o.seed = 100;
  return o;
}

}  // namespace tapfit::signal
