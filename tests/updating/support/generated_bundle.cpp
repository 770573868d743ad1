#include "tests/updating/support/generated_bundle.hpp"

#include "acquisition/bundle/write_test_bundle.hpp"
#include "acquisition/foundation/output_file.hpp"
#include "acquisition/readers/audio_file.hpp"
#include "tests/signal/support/generated_structure.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>

namespace tapfit::updating::testing {
namespace {

using acquisition::Recording;
using Eigen::Index;
using signal::HungStructure;

constexpr double mass_kg = 2.0;

// Modes cos(i pi x) cos(j pi y) (free) or sin (held) at random points.
HungStructure plate(const PlainOptions& o, int points) {
  std::mt19937 engine(o.seed);
  std::uniform_real_distribution<double> anywhere(0.05, 0.95);
  HungStructure made;
  std::vector<double> x;
  std::vector<double> y;
  for (int p = 0; p < points; ++p) {
    x.push_back(anywhere(engine));
    y.push_back(anywhere(engine));
  }
  const double long_side = std::uniform_real_distribution(1.1, 1.9)(engine);
  const double lowest = std::uniform_real_distribution(12.0, 20.0)(engine);
  std::uniform_real_distribution<double> damping(0.004, 0.015);
  if (!o.held) {
    // Hung: up and down, and both ways of tipping, gone within the block.
    for (int kind = 0; kind < 3; ++kind) {
      signal::StructureMode mode{0.3 + 0.1 * kind, 0.3, {}};
      for (int p = 0; p < points; ++p) {
        const auto at = static_cast<std::size_t>(p);
        const double arm = kind == 1 ? x[at] - 0.5 : y[at] - 0.5;
        mode.phi.push_back((kind == 0 ? 1.0 : std::sqrt(12.0) * arm) /
                           std::sqrt(mass_kg));
      }
      made.modes.push_back(mode);
    }
  }
  const int first = o.held ? 1 : 0;
  for (int i = first; i < 4; ++i) {
    for (int j = first; j < 4; ++j) {
      if (!o.held && i + j < 2) continue;
      const double k = i * i + j * j / (long_side * long_side);
      const double hz = o.stiffer * lowest * k / (o.held ? 1.3 : 1.0);
      const double zeta = damping(engine);
      if (hz > 180.0) continue;
      signal::StructureMode mode{hz, zeta, {}};
      for (int p = 0; p < points; ++p) {
        const auto at = static_cast<std::size_t>(p);
        const double px = i * std::numbers::pi * x[at];
        const double py = j * std::numbers::pi * y[at];
        const double value =
            o.held ? std::sin(px) * std::sin(py) : std::cos(px) * std::cos(py);
        const double size =
            (i > 0 ? std::sqrt(2.0) : 1.0) * (j > 0 ? std::sqrt(2.0) : 1.0);
        mode.phi.push_back(size * value / std::sqrt(mass_kg));
      }
      made.modes.push_back(mode);
    }
  }
  return made;
}

}  // namespace

SheetAndRecords plain_test(const PlainOptions& options) {
  constexpr int points = 12;
  HungStructure structure = plate(options, points);
  for (int c = 0; c < options.sensors; ++c) {
    const auto at = static_cast<std::size_t>(c);
    structure.sensors.push_back(
        at < options.sensor_at.size()
            ? static_cast<std::size_t>(options.sensor_at[at])
            : at);
  }
  for (int r = 0; r < options.runs; ++r) {
    structure.hits.push_back(static_cast<std::size_t>(r));
  }
  signal::GeneratedOptions o;
  o.hits = 3;
  o.response_noise = 0.02 * options.noise;
  o.force_noise = 0.01 * options.noise;
  o.seed = 100 * options.seed + 1;
  signal::GeneratedTest made = generate_structure(structure, o);
  SheetAndRecords test{std::move(made.bundle), std::move(made.recordings)};
  // The sheet says where they were meant to be.
  for (acquisition::Run& run : test.bundle.runs) {
    for (std::size_t c = 0; c < run.sensors.size(); ++c) {
      run.sensors[c].dof.node = static_cast<int>(c) + 1;
    }
  }
  test.bundle.band_hz = {4.0, 90.0};
  test.bundle.weighed = acquisition::Weighed{mass_kg, {}, 1.0};
  test.bundle.channels.front().unit = "N";
  return test;
}

void write_bundle(const SheetAndRecords& test,
                  const std::filesystem::path& folder) {
  acquisition::TestBundle bundle = test.bundle;
  std::filesystem::create_directories(folder);
  // One range for all runs, half of it used.
  for (std::size_t c = 0; c < bundle.channels.size(); ++c) {
    double peak = 1e-9;
    for (const Recording& r : test.recordings) {
      peak = std::max(
          peak, r.samples.col(static_cast<Index>(c)).cwiseAbs().maxCoeff());
    }
    bundle.channels[c].full_scale_volts = 2.0 * peak;
  }
  for (std::size_t r = 0; r < bundle.runs.size(); ++r) {
    Eigen::MatrixXd samples = test.recordings[r].samples;
    const double steps = std::pow(2.0, test.bits - 1);
    for (std::size_t c = 0; c < bundle.channels.size(); ++c) {
      auto x = samples.col(static_cast<Index>(c));
      x = (x / bundle.channels[c].full_scale_volts * steps).array().round() /
          steps;
    }
    bundle.runs[r].file = "run-" + std::to_string(r + 1) + ".wav";
    acquisition::write_audio(
        folder / bundle.runs[r].file,
        samples,
        static_cast<int>(test.recordings[r].sample_rate_hz),
        acquisition::AudioFormat::Wav24);
  }
  acquisition::write_file(folder / "test.json",
                          acquisition::test_bundle_text(bundle, folder),
                          {{}, true});
}

}  // namespace tapfit::updating::testing
