// Sample bundles made by another plate element (Kirchhoff's, on a finer mesh)
// whose hidden effect leaves the frequencies as they are.
#include "tests/updating/support/deck_support.hpp"
#include "updating/structure/assembly/assemble.hpp"
#include "updating/structure/mesh/refine_mesh.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace tapfit::structure {
namespace {

struct Case {
  const char* name;
  Eigen::Index skipped;  // rigid modes on a soft suspension
};

class KnownCases : public testing::TestWithParam<Case> {};

// Frequencies of the modes that bend the structure out of its plane.
std::vector<double> bending_hz(const Deck& deck, Eigen::Index count) {
  Deck flat = deck;
  hold(flat, "126", [](const Eigen::Vector3d&) { return true; });
  const Eigen::VectorXd f = modes_of(flat, count).frequency_hz;
  return {f.begin(), f.end()};
}

double largest_error(const std::vector<double>& f,
                     const std::vector<double>& truth,
                     std::size_t skipped) {
  double largest = 0.0;
  for (std::size_t i = skipped; i < truth.size(); ++i) {
    largest = std::max(largest, std::abs(f[i] / truth[i] - 1.0));
  }
  return largest;
}

TEST_P(KnownCases, HaveTheFrequenciesOfTheTruth) {
  const std::filesystem::path folder =
      std::filesystem::path(TAPFIT_SOURCE_DIR "/../shared/cases") /
      GetParam().name;
  if (!std::filesystem::exists(folder)) {
    GTEST_SKIP() << folder << " is not here";
  }
  const nlohmann::json truth =
      nlohmann::json::parse(std::ifstream(folder / "truth.json"));
  std::vector<double> hz = truth.at("natural_frequencies_hz");
  std::sort(hz.begin(), hz.end());
  Deck deck = read_deck(folder / "model.bdf");
  Material& m = deck.materials.at(1);
  m.E = truth.at("E_true");
  m.G = m.E / (2 * (1 + m.nu));
  EXPECT_NEAR(
      total_mass(deck, assemble(deck)), truth.at("total_mass_kg"), 1e-6);
  const Eigen::Index count = static_cast<Eigen::Index>(hz.size());
  const std::size_t skipped = static_cast<std::size_t>(GetParam().skipped);
  EXPECT_LT(largest_error(bending_hz(deck, count), hz, skipped), 0.003);
  // Without transverse shear both are Kirchhoff's plate: what is left is the
  // mesh of the truth.
  deck.shell_properties.at(1).shear = 0;
  const Deck fine = refine_mesh(deck).deck;
  EXPECT_LT(largest_error(bending_hz(fine, count), hz, skipped), 0.0015);
}

INSTANTIATE_TEST_SUITE_P(Cases,
                         KnownCases,
                         testing::Values(Case{"frame-none", 0},
                                         Case{"ladder-dashpot", 0},
                                         Case{"plate-channel-gain", 3}),
                         [](const auto& tested) {
                           std::string name = tested.param.name;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

}  // namespace
}  // namespace tapfit::structure
