#include "tests/tui/support/fake_results.hpp"

#include "updating/localisation/signature.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace tapfit::tui::testing {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double rate_hz = 256.0;
const std::vector<double> modes_hz{5.0, 17.5, 31.25};

std::complex<double> accelerance(double f, double shift, std::size_t dof) {
  const std::complex<double> s(0.5, 2 * pi * f);
  std::complex<double> sum = 0.0;
  for (std::size_t m = 0; m < modes_hz.size(); ++m) {
    const double w = 2 * pi * modes_hz[m] * (1.0 + shift);
    const double residue = (dof == 1 && m == 1) ? -0.4 : 1.0;
    sum += residue * s * s / (s * s + 2 * 0.01 * w * s + w * w);
  }
  return sum;
}

Eigen::VectorXd lines_hz() { return Eigen::VectorXd::LinSpaced(157, 1, 40); }

Eigen::VectorXcd fake_curve(double shift, std::size_t dof) {
  const Eigen::VectorXd f = lines_hz();
  Eigen::VectorXcd H(f.size());
  for (Eigen::Index i = 0; i < f.size(); ++i) {
    H[i] = accelerance(f[i], shift, dof);
  }
  return H;
}

}  // namespace

acquisition::TestBundle fake_bundle() {
  acquisition::TestBundle bundle;
  bundle.title = "Made-up strip";
  bundle.folder = "made-up";  // is not there
  acquisition::Channel hammer;
  hammer.name = "hammer";
  hammer.quantity = acquisition::Quantity::Force;
  acquisition::Channel a1;
  a1.name = "acc1";
  acquisition::Channel a2;
  a2.name = "acc2";
  bundle.channels = {hammer, a1, a2};
  for (int r = 0; r < 2; ++r) {
    acquisition::Run run;
    run.file = r == 0 ? "run-01.wav" : "run-02.wav";
    run.hammer = {0, Dof{3 + r, 3, 1}};
    run.sensors = {{1, Dof{6, 3, 1}}, {2, Dof{4, 3, 1}}};
    bundle.runs.push_back(run);
  }
  bundle.warnings = {"test.json: unknown field \"operator\" is kept"};
  return bundle;
}

structure::Deck fake_deck() {
  structure::Deck deck;
  for (int i = 0; i < 6; ++i) {
    deck.grids.push_back({i + 1, {0.1 * (i / 2), 0.05 * (i % 2), 0.0}});
  }
  deck.shells.push_back({1, 1, {1, 3, 4, 2}, 0.0});
  deck.shells.push_back({2, 1, {3, 5, 6, 4}, 0.0});
  return deck;
}

std::vector<acquisition::Recording> fake_recordings() {
  std::vector<acquisition::Recording> all;
  for (int r = 0; r < 2; ++r) {
    acquisition::Recording recording;
    recording.sample_rate_hz = rate_hz;
    recording.samples = Eigen::MatrixXd::Zero(2560, 3);
    for (const Eigen::Index hit : {256, 1024, 1792}) {
      recording.samples(hit, 0) = 20.0;
      for (Eigen::Index i = 0; i < 512; ++i) {
        const double t = static_cast<double>(i) / rate_hz;
        recording.samples(hit + i, 1) = 3 * std::exp(-2 * t) * std::sin(31 * t);
        recording.samples(hit + i, 2) = std::exp(-3 * t) * std::sin(110 * t);
      }
    }
    all.push_back(std::move(recording));
  }
  return all;
}

acquisition::HitSet fake_hits() {
  acquisition::HitSet set;
  set.sample_rate_hz = rate_hz;
  set.block = 700;
  set.pre_trigger = 10;
  set.trigger_n = 1.5;
  for (int r = 0; r < 2; ++r) {
    std::vector<acquisition::Hit> hits(3);
    for (std::size_t i = 0; i < 3; ++i) {
      hits[i].trigger = 256 + 768 * static_cast<Eigen::Index>(i);
      hits[i].begin = hits[i].trigger - 10;
      hits[i].time_s = static_cast<double>(hits[i].trigger) / rate_hz;
      hits[i].peak_n = 20.0 + static_cast<double>(i);
      hits[i].pulse_s = 0.008;
    }
    hits[1].accepted = false;
    hits[1].reasons = {acquisition::HitFault::Double};
    set.runs.push_back(hits);
  }
  set.statements = {"block 2.73 s: the gap between hits"};
  return set;
}

signal::FrfSet fake_frfs() {
  signal::FrfSet set;
  const Eigen::VectorXd f = lines_hz();
  set.s.resize(f.size());
  for (Eigen::Index i = 0; i < f.size(); ++i) set.s[i] = {0.5, 2 * pi * f[i]};
  for (std::size_t r = 0; r < 2; ++r) {
    for (std::size_t d = 0; d < 2; ++d) {
      signal::Frf frf;
      frf.response = Dof{d == 0 ? 6 : 4, 3, 1};
      frf.reference = Dof{static_cast<int>(3 + r), 3, 1};
      frf.run = r;
      frf.channel = d + 1;
      frf.H = fake_curve(0.0, d);
      frf.coherence = Eigen::VectorXd::Constant(f.size(), 0.987);
      frf.variance = 1e-4 * frf.H.cwiseAbs2();
      frf.hits = 2;
      set.frfs.push_back(std::move(frf));
    }
  }
  return set;
}

modal::ModeSet fake_modes() {
  modal::ModeSet set;
  set.dofs = {Dof{4, 3, 1}, Dof{6, 3, 1}};
  for (std::size_t m = 0; m < modes_hz.size(); ++m) {
    modal::Mode mode;
    mode.frequency_hz = modes_hz[m];
    mode.frequency_sd_hz = 0.0025;
    mode.damping_ratio = 0.01;
    mode.damping_sd = 0.0002;
    mode.mpc = 0.998;
    mode.shape.resize(2);
    mode.shape << 1.0, (m == 1 ? -0.4 : 1.0);
    set.modes.push_back(mode);
    for (int order = 4; order <= 20; order += 2) {
      set.diagram.push_back({order, modes_hz[m], 0.01, order < 8 ? 'o' : 's'});
    }
  }
  set.scaled = true;
  set.unrefined_error = 0.034;
  set.synthesis_error = 0.021;
  return set;
}

updating::Comparison fake_comparison(double high) {
  updating::Comparison c;
  c.error = 7.76 * high + 0.0001;
  c.floor = 0.031;
  c.floor_noise = 0.012;
  c.floor_mesh = 0.0286;
  c.contour = "s = 5 + jw, 1 to 40 Hz";
  c.mac = Eigen::MatrixXd::Identity(3, 3) * 0.97;
  c.modes.frequency_hz.resize(3);
  for (int m = 0; m < 3; ++m) {
    const double hz = modes_hz[static_cast<std::size_t>(m)];
    c.modes.frequency_hz[m] = hz * (1 + high);
    c.pairs.push_back({m, m, hz, hz * (1 + high), 100 * high, 0.97});
  }
  c.frf_error = {0.40, 0.37, 0.41, 0.35};
  c.frac = {0.61, 0.64, 0.60, 0.71};
  c.bands = {{1, 14, 0.3}, {14, 27, 0.4}, {27, 40, 0.5}};
  c.point_error = {{4, 0.36}, {6, 0.405}};
  c.frf_band_error = Eigen::MatrixXd::Constant(4, 3, 0.4);
  c.frf_band_error(2, 1) = 0.87;
  for (std::size_t i = 0; i < 4; ++i) {
    c.model_frfs.push_back(fake_curve(high, i % 2));
  }
  return c;
}

updating::Diagnosis fake_diagnosis() {
  updating::Diagnosis d;
  d.verdict = "added-mass";
  d.error_base = 0.388;
  d.error_best = 0.038;
  d.floor = 0.031;
  d.contour = "s = 5 + jw";
  updating::Candidate mass;
  mass.effect = "added-mass";
  mass.where.node = 5;
  mass.parameters = {{"mass_kg", 0.0785, 0.0006, 0.0773, 0.0797}};
  mass.probability = 0.983;
  mass.error = 0.038;
  mass.held_out_error = 0.041;
  updating::Candidate sensor;
  sensor.effect = "sensor-mass";
  sensor.where.channels = {"acc1"};
  sensor.parameters = {{"mass_kg", 0.071, 0.001, 0.069, 0.073}};
  sensor.probability = 0.017;
  sensor.error = 0.052;
  sensor.held_out_error = 0.06;
  sensor.indistinguishable_from = {{"added-mass", mass.where}};
  d.candidates = {mass, sensor};
  d.ladder = {{mass.effect, mass.where, mass.error, mass.parameters}};
  return d;
}

std::vector<updating::Robustness> fake_robustness() {
  const std::vector<updating::Estimate> size = {
      {"added-mass mass_kg", 0.0788, 0.0006, 0.0776, 0.08}};
  return {{"prior of E:1 doubled", "added-mass", true, size, 0.5},
          {"runs 1 to 2 left out", "none", false, size, 1.25}};
}

updating::Signature fake_signature(int node) {
  updating::Signature s;
  s.node = node;
  s.frequency_hz = lines_hz();
  s.z.resize(s.frequency_hz.size());
  for (Eigen::Index i = 0; i < s.z.size(); ++i) {
    s.z[i] = -0.08 * std::pow(2 * pi * s.frequency_hz[i], 2);
  }
  s.z_sd = Eigen::VectorXd::Constant(s.z.size(), 10.0);
  s.explained = 0.99;
  s.mass_unexplained = 0.06;
  s.mass_kg = 0.0801;
  s.spring_unexplained = 0.84;
  s.spring_n_per_m = -412.0;
  s.dashpot_unexplained = 0.99;
  return s;
}

}  // namespace tapfit::tui::testing
