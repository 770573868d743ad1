// A hammer test on a structure given by its modes, with its exact FRF.
//
//   H(s) = sum_r g_r s^2 / (s^2 + 2 zeta_r w_r s + w_r^2)
//   z' = lambda z + f,  a = sum_r 2 Re(R lambda (lambda z + f)),
//   R = g / (2 j w_d)
//
// Each step of z is exact for a force that is linear between substeps; with 64
// substeps per sample over a pulse of 12 samples what is left is 2e-5 of the
// pulse (second difference of sin^4 at 1/768 of its length).
#pragma once

#include "acquisition/hits/hits.hpp"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <random>
#include <vector>

namespace tapfit::signal {

struct TestMode {
  double hz = 10.0;
  double zeta = 0.01;
  double gain = 1.0;  // phi_response * phi_reference
};

struct GeneratedOptions {
  double fs = 512.0;
  Eigen::Index block = 4096;
  Eigen::Index pre_trigger = 64;
  Eigen::Index lead = 600;  // samples before the first trigger
  Eigen::Index gap = 4096;  // samples between triggers
  int hits = 1;
  double response_noise = 0.0;  // rms [m/s^2]
  double force_noise = 0.0;     // rms [N]
  double offset = 0.0;          // of the response [m/s^2]
  double drift = 0.0;           // of the response [m/s^2 per s]
  double hum = 0.0;             // amplitude [m/s^2]
  double hum_hz = 50.0;
  double spread = 0.0;  // hits that repeat only so well: sd of a gain
  unsigned seed = 1;
};

struct GeneratedTest {
  acquisition::TestBundle bundle;
  std::vector<acquisition::Recording> recordings;
  acquisition::HitSet hits;
};

inline std::complex<double> exact_frf(const std::vector<TestMode>& modes,
                                      std::complex<double> s) {
  std::complex<double> H = 0.0;
  for (const TestMode& m : modes) {
    const double w = 2.0 * std::numbers::pi * m.hz;
    H += m.gain * s * s / (s * s + 2.0 * m.zeta * w * s + w * w);
  }
  return H;
}

// sin^4 pulse of 12 samples; its spectrum falls with the fifth power and has
// its first zero at a quarter of fs, so it is used up to 0.19 fs, where what
// aliases is below 1e-4 of it.
inline double pulse_at(double samples) {
  constexpr double width = 12.0;
  if (samples <= 0.0 || samples >= width) return 0.0;
  const double x = std::sin(std::numbers::pi * samples / width);
  return x * x * x * x;
}

// The force [N] at a time in samples; strengths differ from hit to hit.
inline double force_at(double t, const GeneratedOptions& o) {
  double force = 0.0;
  for (int k = 0; k < o.hits; ++k)
    force += (20.0 + 6.0 * (k % 3)) *
             pulse_at(t + 3.0 - static_cast<double>(o.lead + k * o.gap));
  return force;
}

// Response of one mode, sampled.
inline Eigen::VectorXd mode_response(const TestMode& mode,
                                     const GeneratedOptions& o,
                                     const std::vector<double>& gains,
                                     Eigen::Index n) {
  constexpr int fine = 64;
  using complex = std::complex<double>;
  const double w = 2.0 * std::numbers::pi * mode.hz;
  const double wd = w * std::sqrt(1.0 - mode.zeta * mode.zeta);
  const complex lambda(-mode.zeta * w, wd);
  const complex R = complex(0.0, -0.5 * mode.gain / wd);
  const double h = 1.0 / (o.fs * fine);
  const complex e = std::exp(lambda * h);
  // phi1 and phi2 by series: lambda h is below 0.05 here.
  complex phi1 = 0.0;
  complex phi2 = 0.0;
  complex term = 1.0;
  for (int i = 1; i < 12; ++i) {
    phi1 += term / static_cast<double>(i);
    phi2 += term / static_cast<double>(i * (i + 1));
    term *= lambda * h / static_cast<double>(i);
  }
  const complex coarse = std::exp(lambda / o.fs);
  Eigen::VectorXd a(n);
  complex z = 0.0;
  for (Eigen::Index i = 0; i < n; ++i) {
    const double t = static_cast<double>(i);
    const Eigen::Index k =
        std::clamp<Eigen::Index>((i - o.lead + 20) / o.gap, 0, o.hits - 1);
    const double gain = gains[static_cast<std::size_t>(k)];
    a(i) = 2.0 * std::real(R * lambda * (lambda * z + gain * force_at(t, o)));
    const Eigen::Index since = i - o.lead - k * o.gap;
    if (since < -6 || since > 14) {
      z *= coarse;
      continue;
    }
    for (int j = 0; j < fine; ++j) {
      const double f0 = gain * force_at(t + j / double{fine}, o);
      const double f1 = gain * force_at(t + (j + 1) / double{fine}, o);
      z = e * z + h * ((phi1 - phi2) * f0 + phi2 * f1);
    }
  }
  return a;
}

inline GeneratedTest generate_test(const std::vector<TestMode>& modes,
                                   const GeneratedOptions& o) {
  std::mt19937_64 engine(o.seed);
  std::normal_distribution<double> normal;
  const Eigen::Index n =
      o.lead + (o.hits - 1) * o.gap + (o.block - o.pre_trigger);
  GeneratedTest test;
  acquisition::Channel hammer;
  hammer.name = "hammer";
  hammer.quantity = acquisition::Quantity::Force;
  acquisition::Channel sensor;
  sensor.name = "acc1";
  test.bundle.channels = {hammer, sensor};
  acquisition::Run run;
  run.file = "run-01.wav";
  run.hammer = {0, Dof{3, 3, 1}};
  run.sensors = {{1, Dof{7, 3, -1}}};
  test.bundle.runs = {run};
  std::vector<double> gains;
  for (int k = 0; k < o.hits; ++k)
    gains.push_back(1.0 + o.spread * normal(engine));
  Eigen::MatrixXd x = Eigen::MatrixXd::Zero(n, 2);
  for (Eigen::Index i = 0; i < n; ++i)
    x(i, 0) = force_at(static_cast<double>(i), o);
  for (const TestMode& mode : modes)
    x.col(1) += mode_response(mode, o, gains, n);
  const double phase = 6.0 * normal(engine);
  for (Eigen::Index i = 0; i < n; ++i) {
    const double t = static_cast<double>(i) / o.fs;
    x(i, 0) += o.force_noise * normal(engine);
    x(i, 1) += o.response_noise * normal(engine) + o.offset + o.drift * t +
               o.hum * std::sin(2.0 * std::numbers::pi * o.hum_hz * t + phase);
  }
  test.recordings = {{o.fs, std::move(x)}};
  test.hits.sample_rate_hz = o.fs;
  test.hits.block = o.block;
  test.hits.pre_trigger = o.pre_trigger;
  test.hits.runs.emplace_back();
  for (int k = 0; k < o.hits; ++k) {
    acquisition::Hit hit;
    hit.trigger = o.lead + k * o.gap;
    hit.begin = hit.trigger - o.pre_trigger;
    hit.time_s = static_cast<double>(hit.trigger) / o.fs;
    hit.peak_n = 20.0;
    hit.pulse_s = 6.0 / o.fs;
    test.hits.runs[0].push_back(hit);
  }
  return test;
}

}  // namespace tapfit::signal
