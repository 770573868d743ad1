#include "tests/updating/support/generated_bundle.hpp"

#include "acquisition/bundle/write_test_bundle.hpp"
#include "acquisition/foundation/output_file.hpp"
#include "acquisition/readers/audio_file.hpp"
#include "tests/signal/support/generated_structure.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <utility>

namespace tapfit::updating::testing {
namespace {

using acquisition::Recording;
using Eigen::Index;
using signal::HungStructure;

constexpr double mass_kg = 2.0;

struct Place {
  double x = 0.0;  // along the structure, 0 ... 1
  double y = 0.0;
};

// Of a structure 1 x 1 of mass 1: mean square 1 over the mass.
struct Shape {
  double relative_hz = 0.0;  // any unit
  std::function<double(const Place&)> phi;
};

// cos(i pi x) cos(j pi y) (free) or sin sin (held).
std::vector<Shape> plate_shapes(bool held, double long_side) {
  std::vector<Shape> shapes;
  const int first = held ? 1 : 0;
  for (int i = first; i < 4; ++i) {
    for (int j = first; j < 4; ++j) {
      if (!held && i + j < 2) continue;
      const double k = i * i + j * j / (long_side * long_side);
      const double size =
          (i > 0 ? std::sqrt(2.0) : 1.0) * (j > 0 ? std::sqrt(2.0) : 1.0);
      shapes.push_back({k / (held ? 1.3 : 1.0), [=](const Place& at) {
                          const double px = i * std::numbers::pi * at.x;
                          const double py = j * std::numbers::pi * at.y;
                          return size * (held ? std::sin(px) * std::sin(py)
                                              : std::cos(px) * std::cos(py));
                        }});
    }
  }
  return shapes;
}

// Euler's beam, its roots: S. S. Rao, "Mechanical Vibrations", table 8.4.
std::vector<Shape> beam_shapes(bool clamped) {
  const std::vector<double> roots =
      clamped ? std::vector{1.875104, 4.694091, 7.854757, 10.995541}
              : std::vector{4.730041, 7.853205, 10.995608, 14.137165};
  std::vector<Shape> shapes;
  for (const double b : roots) {
    const double turn = clamped ? -1.0 : 1.0;
    const double sigma = (std::cosh(b) - turn * std::cos(b)) /
                         (std::sinh(b) - turn * std::sin(b));
    const double low = clamped ? 0.4 : 1.0;
    shapes.push_back(
        {low * std::pow(b / roots.front(), 2), [=](const Place& at) {
           const double z = b * at.x;
           return std::cosh(z) + turn * std::cos(z) -
                  sigma * (std::sinh(z) + turn * std::sin(z));
         }});
  }
  return shapes;
}

// Five equal floors on equal walls, each floor moving as one.
std::vector<Shape> storey_shapes() {
  constexpr int floors = 5;
  std::vector<Shape> shapes;
  for (int k = 1; k <= floors; ++k) {
    const double turn = (2 * k - 1) * std::numbers::pi / (2 * floors + 1);
    shapes.push_back({std::sin(0.5 * turn) /
                          std::sin(0.5 * std::numbers::pi / (2 * floors + 1)),
                      [=](const Place& at) {
                        const double floor = std::floor(floors * at.x) + 1.0;
                        return std::sqrt(4.0 * floors / (2 * floors + 1)) *
                               std::sin(floor * turn);
                      }});
  }
  return shapes;
}

std::vector<Shape> shapes_of(Structure structure, double long_side) {
  switch (structure) {
    case Structure::FreePlate:
    case Structure::HeldPlate:
      return plate_shapes(structure == Structure::HeldPlate, long_side);
    case Structure::FreeBeam:
    case Structure::ClampedBeam:
      return beam_shapes(structure == Structure::ClampedBeam);
    case Structure::Storeys:
      return storey_shapes();
  }
  return {};
}

// Hung: up and down, and both ways of tipping, gone within the block.
std::vector<Shape> rigid_shapes(Structure structure) {
  const auto tipping = [](double along) {
    return std::sqrt(12.0) * (along - 0.5);
  };
  const Shape up{0.3, [](const Place&) { return 1.0; }};
  const Shape along{0.4, [=](const Place& at) { return tipping(at.x); }};
  const Shape across{0.5, [=](const Place& at) { return tipping(at.y); }};
  if (structure == Structure::FreePlate) return {up, along, across};
  if (structure == Structure::FreeBeam) return {up, along};
  return {};
}

// At random points.
HungStructure made_structure(const PlainOptions& o, int points) {
  std::mt19937 engine(o.seed);
  std::uniform_real_distribution<double> anywhere(0.05, 0.95);
  std::vector<Place> places(static_cast<std::size_t>(points));
  for (Place& at : places) {
    at.x = anywhere(engine);
    at.y = anywhere(engine);
  }
  const double long_side = std::uniform_real_distribution(1.1, 1.9)(engine);
  const double lowest = std::uniform_real_distribution(12.0, 20.0)(engine);
  std::uniform_real_distribution<double> damping(0.004, 0.015);
  HungStructure made;
  const auto add = [&](double hz, double zeta, const Shape& shape) {
    made.modes.push_back({hz, zeta, {}});
    for (const Place& at : places) {
      made.modes.back().phi.push_back(shape.phi(at) / std::sqrt(mass_kg));
    }
  };
  for (const Shape& shape : rigid_shapes(o.structure)) {
    add(shape.relative_hz, 0.3, shape);
  }
  for (const Shape& shape : shapes_of(o.structure, long_side)) {
    const double hz = o.stiffer * lowest * shape.relative_hz;
    const double zeta = damping(engine);
    if (hz <= 180.0) add(hz, zeta, shape);
  }
  return made;
}

}  // namespace

SheetAndRecords plain_test(const PlainOptions& options) {
  constexpr int points = 12;
  HungStructure structure = made_structure(options, points);
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
  structure = with_effect(structure, options.hidden, mass_kg);
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
  const bool weighed_with = options.hidden.kind == Hidden::PointMass;
  test.bundle.weighed = acquisition::Weighed{
      mass_kg + (weighed_with ? mass_of(options.hidden, mass_kg) : 0.0),
      {},
      1.0};
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
