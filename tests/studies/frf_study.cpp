// Scale, damping and stated scatter of FRFs over random structures.
//
//   frf_study [SEED [COUNT]]
//
// Scale: two modes of random frequency, gain and damping that decay by 6 to 15
// time constants within the block, windows ending at 1 to 0.01. Coverage:
// truths within the stated 95 %, one to ten hits in noise; also of responses of
// four time constants without a window, completed, against the exact FRF.
//
// Scale is judged twice, from blocks as they are and with what their end cuts
// off added by the identified poles. As they are the largest error of |H| is
// the tail that six time constants leave beyond the block: e^-6 = 0.25 % of
// each mode, times the force spectrum at the mode over that at the line, and
// twice that where two modes half cancel. The closed form
// sum_r R_r F(l_r)/F(s) exp((l_r - s) T) dt / (1 - exp((l_r - s) dt)) gives all
// of the worst ones, up to 0.58 %, to 0.003 %.
#include "tests/signal/support/band_coverage.hpp"
#include "tests/signal/support/scale_error.hpp"
#include "updating/measurement/truncation_corrected_frfs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

namespace tapfit::signal {
namespace {

double between(double low, double high, std::mt19937_64& random) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

std::vector<TestMode> random_modes(std::mt19937_64& random,
                                   const GeneratedOptions& o,
                                   double time_constants) {
  const double T = static_cast<double>(o.block - o.pre_trigger) / o.fs;
  const double first = between(12.0, 40.0, random);
  const double second = first * between(1.5, 3.0, random);
  const double gain = between(0.4, 1.5, random);
  std::vector<TestMode> modes{{std::min(first, 50.0), 0.0, 1.0},
                              {std::min(second, 85.0),
                               0.0,
                               between(0.0, 1.0, random) < 0.5 ? -gain : gain}};
  for (TestMode& mode : modes) {
    mode.zeta = time_constants / (2.0 * std::numbers::pi * mode.hz * T);
  }
  return modes;
}

// Damping of the estimate over that of the exact FRF, both by the same fit: a
// second mode nearby makes the fit itself err by some per cent.
double damping_bias(const GeneratedTest& test,
                    const std::vector<TestMode>& modes,
                    const FrfOptions& options) {
  FrfSet set = estimate_frfs(test.bundle, test.recordings, test.hits, options);
  FrfSet exact = set;
  const double sign = set.frfs[0].response.sign;
  for (Eigen::Index i = 0; i < set.lines(); ++i) {
    exact.frfs[0].H(i) = sign * exact_frf(modes, set.s(i));
  }
  double worst = 0.0;
  for (const TestMode& mode : modes) {
    worst = std::max(
        worst,
        std::abs(damping_near(set, mode.hz) / damping_near(exact, mode.hz) -
                 1.0));
  }
  return worst;
}

Eigen::VectorXcd lasting_poles(const GeneratedTest& test) {
  return updating::estimate_truncation_corrected_frfs(
             test.bundle, test.recordings, test.hits, {})
      .poles;
}

// Of one way to estimate.
struct Errors {
  std::vector<double> scale;
  std::vector<double> damping;

  void add(const GeneratedTest& test,
           const std::vector<TestMode>& modes,
           const FrfOptions& options) {
    scale.push_back(worst_of(test, modes, options).scale);
    damping.push_back(damping_bias(test, modes, options));
  }
};

void print(const char* what, std::vector<double> errors) {
  std::ranges::sort(errors);
  fmt::print("{}: median {:.3f} %, largest {:.3f} % of {}\n",
             what,
             100.0 * errors[errors.size() / 2],
             100.0 * errors.back(),
             errors.size());
}

void scale(unsigned seed, int count) {
  std::mt19937_64 random(seed);
  Errors as_cut;
  Errors completed;
  for (int k = 0; k < count; ++k) {
    GeneratedOptions o;
    o.block = between(0.0, 1.0, random) < 0.5 ? 4096 : 2048;
    const double end = std::pow(0.01, between(0.0, 1.0, random));
    // The worst case, six time constants, in every other one.
    const auto modes =
        random_modes(random, o, k % 2 == 0 ? 6.0 : between(6.0, 15.0, random));
    GeneratedTest test = generate_test(modes, o);
    test.bundle.band_hz = {5.0, 100.0};
    FrfOptions options;
    options.window.end_value = k % 4 == 0 ? 1.0 : end;
    as_cut.add(test, modes, options);
    options.lasting_poles = lasting_poles(test);
    completed.add(test, modes, options);
  }
  print("|H| at and between resonances, completed", completed.scale);
  print("damping ratio, of itself, completed", completed.damping);
  print("|H|, blocks as they are", as_cut.scale);
  print("damping ratio, blocks as they are", as_cut.damping);
}

// Lines that are covered: as the program has them, damped, and completed
// without a window.
enum class Lines { Fft, Damped, Completed };

void covered(Lines lines, int hits, int count, std::mt19937_64& random) {
  const char* const names[] = {"FFT", "damped", "completed"};
  IdentifiedPoles identified;
  if (lines == Lines::Completed) identified = lasting_poles;
  double share = 0.0;
  constexpr int structures = 8;
  for (int k = 0; k < structures; ++k) {
    GeneratedOptions o = noisy(hits);
    o.seed = static_cast<unsigned>(random());
    const double time_constants = lines == Lines::Completed ? 4.0 : 8.0;
    share += coverage(random_modes(random, o, time_constants),
                      o,
                      lines == Lines::Damped,
                      std::max(1, count / (structures * hits)),
                      identified)
                 .share;
  }
  fmt::print("{} hits, {} lines: {:.1f} % covered\n",
             hits,
             names[static_cast<int>(lines)],
             100.0 * share / structures);
  std::fflush(stdout);
}

void covered(unsigned seed, int count) {
  std::mt19937_64 random(seed + 1);
  for (const Lines lines : {Lines::Fft, Lines::Damped, Lines::Completed}) {
    for (const int hits : {1, 2, 3, 5, 10}) covered(lines, hits, count, random);
  }
}

}  // namespace
}  // namespace tapfit::signal

int main(int argc, char** argv) {
  const int seed = argc > 1 ? std::atoi(argv[1]) : 1;
  const int count = argc > 2 ? std::atoi(argv[2]) : 200;
  tapfit::signal::scale(static_cast<unsigned>(seed), count);
  tapfit::signal::covered(static_cast<unsigned>(seed), count);
  return 0;
}
