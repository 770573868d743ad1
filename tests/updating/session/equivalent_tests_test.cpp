// One test written down in several ways has the same results, from recordings
// to updated model: in other units, with channels, runs, properties and effects
// in another order, at another sensitivity, on any number of threads.
#include "acquisition/foundation/parallel.hpp"
#include "acquisition/readers/audio_file.hpp"
#include "tests/acquisition/support/temporary_folder.hpp"
#include "tests/updating/support/bar_frame.hpp"
#include "updating/catalogue/effect_place.hpp"
#include "updating/export/updated_deck.hpp"
#include "updating/session/session.hpp"
#include "updating/virtual_test/virtual_bundle.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tapfit::updating {
namespace {

namespace fs = std::filesystem;
using Eigen::Index;
using nlohmann::json;
using tapfit::testing::TemporaryFolder;

// What users are shown, by name; modes and pairs from below.
struct WholeResult {
  std::map<std::string, Eigen::VectorXcd> frfs;
  std::map<std::string, Eigen::VectorXcd> shapes;  // of a point, over the modes
  std::vector<double> poles;       // frequencies, damping ratios, their sd
  std::vector<double> comparison;  // error, floors, pairs
  double floor_mesh = 0.0;
  std::map<std::string, Estimate> sizes;
  double error = 0.0;  // with the effects
};

std::vector<EffectRef> effects_of_the_test() {
  return {parse_effect("added-mass@6"), parse_effect("ground-spring@12")};
}

void take_measured(Session& session, WholeResult& result) {
  for (const signal::Frf& frf : session.frfs().frfs) {
    result.frfs[name(frf)] = frf.H;
  }
  const modal::ModeSet& set = session.modes();
  for (std::size_t k = 0; k < set.dofs.size(); ++k) {
    Eigen::VectorXcd row(static_cast<Index>(set.modes.size()));
    std::ranges::transform(
        set.modes, row.begin(), [k](const modal::Mode& mode) {
          return mode.shape(static_cast<Index>(k));
        });
    result.shapes[name(set.dofs[k])] = row;
  }
  for (const modal::Mode& mode : set.modes) {
    for (const double value : {mode.frequency_hz,
                               mode.damping_ratio,
                               mode.frequency_sd_hz,
                               mode.damping_sd}) {
      result.poles.push_back(value);
    }
  }
}

WholeResult whole_result(
    Session& session,
    const std::vector<EffectRef>& effects = effects_of_the_test()) {
  WholeResult result;
  take_measured(session, result);
  const Comparison& c = session.comparison();
  result.comparison = {c.error, c.floor, c.floor_noise};
  result.floor_mesh = c.floor_mesh;
  for (const ModePair& pair : c.pairs) {
    for (const double value : {pair.model_hz, pair.mac, pair.weighted_mac}) {
      result.comparison.push_back(value);
    }
  }
  session.add_together(effects);
  for (const Estimate& e : session.model_parameters()) result.sizes[e.name] = e;
  result.error = session.ladder().back().error;
  return result;
}

void expect_near(const std::vector<double>& one,
                 const std::vector<double>& other,
                 double relative) {
  ASSERT_EQ(one.size(), other.size());
  for (std::size_t k = 0; k < one.size(); ++k) {
    EXPECT_NEAR(one[k], other[k], relative * std::abs(other[k])) << k;
  }
}

void expect_near(const std::map<std::string, Eigen::VectorXcd>& one,
                 const std::map<std::string, Eigen::VectorXcd>& other,
                 double relative) {
  ASSERT_EQ(one.size(), other.size());
  for (const auto& [name, values] : other) {
    ASSERT_TRUE(one.contains(name)) << name;
    ASSERT_EQ(one.at(name).size(), values.size());
    EXPECT_LE((one.at(name) - values).norm(), relative * values.norm()) << name;
  }
}

// In standard deviations: how far from its minimum a fit may end
// (Fitter::fit), and what rounding makes of the same steps from the same start.
constexpr double another_way = 0.05;
constexpr double same_way = 1e-4;

void expect_same_sizes(const WholeResult& one,
                       const WholeResult& other,
                       double of_sd) {
  ASSERT_EQ(one.sizes.size(), other.sizes.size());
  for (const auto& [name, e] : other.sizes) {
    ASSERT_TRUE(one.sizes.contains(name)) << name;
    const Estimate& own = one.sizes.at(name);
    EXPECT_NEAR(own.value, e.value, of_sd * e.sd) << name;
    EXPECT_NEAR(own.sd, e.sd, of_sd * e.sd) << name;
    EXPECT_EQ(own.unit, e.unit) << name;
  }
  EXPECT_NEAR(one.error, other.error, of_sd * other.error);
}

// Sums of some ten thousand samples in another order, and what the conditioning
// of poles and shapes makes of that.
constexpr double rounding = 1e-11;
constexpr double rounding_in_modes = 1e-7;

// Two meshes differ by some 1e-4 of what they answer: so many digits go.
constexpr double rounding_between_meshes = 1e-5;

void expect_same(const WholeResult& one, const WholeResult& other) {
  expect_near(one.frfs, other.frfs, rounding);
  expect_near(one.poles, other.poles, rounding_in_modes);
  expect_near(one.shapes, other.shapes, rounding_in_modes);
  expect_near(one.comparison, other.comparison, rounding_in_modes);
  EXPECT_NEAR(one.floor_mesh,
              other.floor_mesh,
              rounding_between_meshes * other.floor_mesh);
  expect_same_sizes(one, other, same_way);
}

json read_json(const fs::path& file) {
  std::ifstream in(file);
  return json::parse(in);
}

class EquivalentTests : public ::testing::Test {
 protected:
  // Two runs' sensors are hit themselves, so that shapes have a scale.
  static void SetUpTestSuite() {
    const char* off = std::getenv("TAPFIT_NO_CACHE");
    cache_was_off_ = off != nullptr ? std::optional<std::string>(off)
                                    : std::optional<std::string>();
    ::setenv("TAPFIT_NO_CACHE", "1", 1);
    root_ = std::make_unique<TemporaryFolder>();
    root_->write("truth.bdf", support::frame_text());
    VirtualBundleSpec spec;
    spec.structure = (root_->path() / "truth.bdf").string();
    spec.effects = {parse_virtual_effect("added-mass@6=0.4"),
                    parse_virtual_effect("ground-spring@12=2e5")};
    spec.points = 4;
    spec.hits = 2;
    spec.gap_s = 1.0;
    spec.band_hz = {20.0, 1200.0};
    spec.damping_mean = 0.02;
    spec.faulty_hits = false;
    make_virtual_bundle(spec, root_->path() / "plain");
    json test = read_json(root_->path() / "plain" / "test.json");
    test["uncertain"].push_back(
        {{"material", 1}, {"property", "rho"}, {"sd_percent", 1.0}});
    root_->write("plain/test.json", test.dump());
    root_->write("plain/model.bdf", support::frame_text());
    Session session(root_->path() / "plain");
    plain_ = std::make_unique<WholeResult>(whole_result(session));
  }
  static void TearDownTestSuite() {
    plain_.reset();
    root_.reset();
    ::unsetenv("TAPFIT_NO_CACHE");
    if (cache_was_off_) ::setenv("TAPFIT_NO_CACHE", cache_was_off_->c_str(), 1);
  }

  // A copy of the test, to be written otherwise.
  void SetUp() override {
    folder_ = root_->path() /
              ::testing::UnitTest::GetInstance()->current_test_info()->name();
    fs::copy(root_->path() / "plain", folder_);
    test_ = read_json(folder_ / "test.json");
  }

  Session session() {
    std::ofstream(folder_ / "test.json") << test_.dump();
    return Session(folder_);
  }

  // Every record with column k taken from column `from[k]`, times `gain[k]`;
  // as a file that keeps every digit.
  void rewrite_records(const std::vector<Index>& from,
                       const std::vector<double>& gain) {
    for (json& run : test_["runs"]) {
      const fs::path file = run["file"].get<std::string>();
      const acquisition::Audio audio = acquisition::read_audio(folder_ / file);
      Eigen::MatrixXd samples(audio.samples.rows(), audio.samples.cols());
      for (std::size_t k = 0; k < from.size(); ++k) {
        samples.col(static_cast<Index>(k)) =
            gain[k] * audio.samples.col(from[k]);
      }
      run["file"] = fs::path(file).replace_extension(".wav").string();
      acquisition::write_audio(folder_ / run["file"].get<std::string>(),
                               samples,
                               static_cast<int>(audio.sample_rate_hz),
                               acquisition::AudioFormat::WavFloat64);
    }
  }

  static inline std::optional<std::string> cache_was_off_;
  static inline std::unique_ptr<TemporaryFolder> root_;
  static inline std::unique_ptr<WholeResult> plain_;
  fs::path folder_;
  json test_;
};

// What the others compare is all there, and is what was hidden.
TEST_F(EquivalentTests, ThePlainOneFindsWhatIsInIt) {
  EXPECT_EQ(plain_->frfs.size(), 8U);
  EXPECT_EQ(plain_->shapes.size(), 4U);
  ASSERT_EQ(plain_->poles.size(), 4U * 3U);
  EXPECT_EQ(plain_->sizes.size(), 4U);
  EXPECT_GT(plain_->comparison.at(0), 10.0 * plain_->error);
  const Estimate& mass = plain_->sizes.at("added-mass mass_kg");
  EXPECT_NEAR(mass.value, 0.4, 3.0 * mass.sd);
  EXPECT_LT(mass.sd, 0.04);
}

// A tonne per cubic millimetre is 1e12 kg/m^3, a MPa 1e6 Pa, a N/mm 1000 N/m.
TEST_F(EquivalentTests, InMillimetresAndTonnes) {
  std::ofstream(folder_ / "model.bdf") << support::frame_text(support::mm_t_s);
  test_["units"] = "mm-t-s";
  Session in_mm = session();
  expect_same(whole_result(in_mm), *plain_);

  // Its updated deck is in its own units.
  write_updated_deck(in_mm, folder_ / "updated.bdf", {}, {});
  const structure::Deck deck = structure::read_deck(folder_ / "updated.bdf");
  const auto size = [](const char* name) {
    return plain_->sizes.at(name).value;
  };
  constexpr double digits = 1e-5;  // of a card
  const auto expect_card = [&](double written, double value) {
    EXPECT_NEAR(written, value, digits * value);
  };
  expect_card(deck.materials.at(1).E, 1e-6 * size("E:1"));
  expect_card(deck.materials.at(1).rho, 1e-12 * size("rho:1"));
  ASSERT_EQ(deck.masses.size(), 1U);
  expect_card(deck.masses[0].mass, 1e-3 * size("added-mass mass_kg"));
  ASSERT_EQ(deck.scalars.size(), 1U);
  expect_card(deck.scalars[0].stiffness,
              1e-3 * size("ground-spring stiffness_n_per_m"));
  // Fits make up for the mesh, which no card does.
  const double mesh = in_mm.comparison().floor_mesh;
  ASSERT_GT(mesh, 0.0);
  const std::string note =
      fmt::format("$ not written: what the mesh leaves ({:.2g} % of the FRFs)",
                  100.0 * mesh);
  EXPECT_TRUE(std::ranges::any_of(deck.cards, [&](const std::string& line) {
    return line.starts_with(note);
  })) << note;
}

TEST_F(EquivalentTests, WithChannelsInAnotherOrder) {
  const json channels = test_["channels"];
  test_["channels"] = {channels[2], channels[0], channels[1]};
  rewrite_records({2, 0, 1}, {1.0, 1.0, 1.0});
  for (json& run : test_["runs"]) {
    std::swap(run["sensors"][0], run["sensors"][1]);
  }
  Session other = session();
  expect_same(whole_result(other), *plain_);
}

TEST_F(EquivalentTests, WithRunsInAnotherOrder) {
  const json runs = test_["runs"];
  test_["runs"] = {runs[2], runs[0], runs[3], runs[1]};
  Session other = session();
  expect_same(whole_result(other), *plain_);
}

// The fit adds one effect after the other, so that it comes another way.
TEST_F(EquivalentTests, WithPropertiesAndEffectsInAnotherOrder) {
  std::swap(test_["uncertain"][0], test_["uncertain"][1]);
  std::vector<EffectRef> effects = effects_of_the_test();
  std::ranges::reverse(effects);
  Session other = session();
  expect_same_sizes(whole_result(other, effects), *plain_, another_way);
}

// What is measured is sample x full scale / sensitivity.
TEST_F(EquivalentTests, WithSamplesAsTheirSensitivity) {
  const std::vector<double> gain = {0.7, 0.3, 0.9};
  rewrite_records({0, 1, 2}, gain);
  for (std::size_t k = 0; k < gain.size(); ++k) {
    json& sensitivity = test_["channels"][k]["sensitivity"];
    sensitivity = gain[k] * sensitivity.get<double>();
  }
  Session other = session();
  WholeResult result;
  take_measured(other, result);
  expect_near(result.frfs, plain_->frfs, rounding);
  expect_near(result.poles, plain_->poles, rounding_in_modes);
  expect_near(result.shapes, plain_->shapes, rounding_in_modes);
}

// Within a piece of parallel work there is one thread. Every sum is done by one
// thread alone, so that nothing may differ, not by a bit.
TEST_F(EquivalentTests, OnOneThread) {
  Session on_all(root_->path() / "plain");
  const Diagnosis& all = on_all.diagnosis();
  for_each_parallel(2, [&](std::size_t piece) {
    if (piece > 0) return;
    Session on_one = session();
    const Diagnosis& one = on_one.diagnosis();
    EXPECT_EQ(one.verdict, all.verdict);
    ASSERT_EQ(one.candidates.size(), all.candidates.size());
    for (std::size_t k = 0; k < all.candidates.size(); ++k) {
      EXPECT_EQ(one.candidates[k].effect, all.candidates[k].effect);
      EXPECT_EQ(one.candidates[k].where, all.candidates[k].where);
      EXPECT_EQ(one.candidates[k].error, all.candidates[k].error);
      EXPECT_EQ(one.candidates[k].probability, all.candidates[k].probability);
    }
    const WholeResult result = whole_result(on_one);
    EXPECT_EQ(result.frfs, plain_->frfs);
    EXPECT_EQ(result.poles, plain_->poles);
    EXPECT_EQ(result.comparison, plain_->comparison);
    EXPECT_EQ(result.floor_mesh, plain_->floor_mesh);
    EXPECT_EQ(result.error, plain_->error);
    expect_same_sizes(result, *plain_, 0.0);
  });
}

}  // namespace
}  // namespace tapfit::updating
