// FRFs freed of the sensors against recordings of the same structure without
// them.
#include "acquisition/bundle/read_test_bundle.hpp"
#include "acquisition/bundle/recording.hpp"
#include "acquisition/bundle/run_reader.hpp"
#include "acquisition/hits/find_hits.hpp"
#include "acquisition/hits/hits.hpp"
#include "signal/estimate/estimate_frfs.hpp"
#include "signal/mass_removal/free_frfs.hpp"
#include "signal/mass_removal/sensor_loads.hpp"
#include "updating/virtual_test/virtual_bundle.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>

namespace tapfit::updating {
namespace {

namespace fs = std::filesystem;

constexpr double sensor = 0.03;  // kg each, on a ladder of 1.3 kg

/// Both sensors' places are hit; noise, damping and modulus are the same for
/// the same seed whatever is hidden.
signal::FrfSet measured(bool loaded) {
  VirtualBundleSpec spec;
  spec.structure = "ladder";
  spec.seed = 3;
  spec.points = 3;
  spec.hits = 2;
  spec.faulty_hits = false;
  if (loaded) spec.effects = {parse_virtual_effect("sensor-mass=0.03")};
  const fs::path folder = fs::path(::testing::TempDir()) /
                          (loaded ? "tapfit-loaded" : "tapfit-bare");
  fs::remove_all(folder);
  (void)make_virtual_bundle(spec, folder);
  const acquisition::TestBundle bundle = acquisition::read_test_bundle(folder);
  const auto recordings = acquisition::read_recordings(bundle);
  const auto hits = acquisition::find_hits(bundle, recordings, {});
  // Lines of one damped line, whatever block each recording was given.
  Eigen::VectorXcd s(300);
  for (Eigen::Index k = 0; k < s.size(); ++k) {
    const double f = 5.0 + 0.3 * static_cast<double>(k);
    s(k) = {0.4, 2.0 * std::numbers::pi * f};
  }
  return signal::estimate_frfs_at(bundle, recordings, hits, s, {});
}

/// rms over lines of what differs, each line over its rms over the FRFs.
double difference(const signal::FrfSet& a, const signal::FrfSet& b) {
  double sum = 0.0;
  for (Eigen::Index k = 0; k < a.lines(); ++k) {
    double level = 0.0;
    double left = 0.0;
    for (std::size_t f = 0; f < a.frfs.size(); ++f) {
      level += std::norm(b.frfs[f].H(k));
      left += std::norm(a.frfs[f].H(k) - b.frfs[f].H(k));
    }
    sum += left / level;
  }
  return std::sqrt(sum / static_cast<double>(a.lines()));
}

TEST(FreedFrfs, AreThoseOfTheStructureWithoutSensors) {
  const signal::FrfSet loaded = measured(true);
  const signal::FrfSet bare = measured(false);
  ASSERT_EQ(loaded.frfs.size(), bare.frfs.size());
  std::vector<signal::ChannelMass> masses;
  for (const signal::Frf& frf : loaded.frfs) {
    if (frf.run == 0) masses.push_back({frf.channel, {"acc", sensor, 0.0}});
  }
  ASSERT_EQ(masses.size(), 2U);
  const signal::FreedFrfs freed =
      signal::free_frfs(loaded, signal::sensors_as_loads(loaded, masses), {});
  for (const signal::FreedNote& note : freed.notes) {
    EXPECT_EQ(note.by, signal::FreedBy::Measurement) << note.reason;
  }
  EXPECT_GT(difference(loaded, bare), 0.5);
  // Scatter of 0.1 %, some ten times larger where a resonance was moved.
  EXPECT_LT(difference(freed.frfs, bare), 0.03);
}

}  // namespace
}  // namespace tapfit::updating
