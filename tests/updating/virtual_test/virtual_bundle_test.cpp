#include "updating/virtual_test/virtual_bundle.hpp"

#include "acquisition/bundle/read_test_bundle.hpp"
#include "acquisition/bundle/recording.hpp"
#include "acquisition/bundle/run_reader.hpp"
#include "acquisition/bundle/test_bundle.hpp"
#include "acquisition/foundation/input_error.hpp"
#include "updating/virtual_test/made_files.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>
#include <sstream>

namespace tapfit::updating {
namespace {

namespace fs = std::filesystem;

VirtualBundleSpec small_spec() {
  VirtualBundleSpec spec = demo_spec();
  spec.points = 4;
  spec.hits = 2;
  spec.gap_s = 2.0;
  spec.seed = 5;
  return spec;
}

fs::path fresh_folder(const std::string& name) {
  const fs::path folder = fs::path(::testing::TempDir()) / ("tapfit-" + name);
  fs::remove_all(folder);
  return folder;
}

std::string bytes_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// Pulses of a run: crossings of 20 % of an ordinary peak, rising.
int pulses(const acquisition::Recording& recording, double level) {
  int count = 0;
  for (Eigen::Index n = 1; n < recording.samples.rows(); ++n) {
    const bool above = recording.samples(n, 0) > level;
    const bool below = recording.samples(n - 1, 0) <= level;
    if (above && below) ++count;
  }
  return count;
}

TEST(VirtualBundle, IsReadableAndHoldsItsFaults) {
  const fs::path folder = fresh_folder("faults");
  const VirtualBundleResult result = make_virtual_bundle(small_spec(), folder);
  EXPECT_EQ(result.runs, 4U);
  const acquisition::TestBundle bundle = acquisition::read_test_bundle(folder);
  EXPECT_TRUE(bundle.warnings.empty());
  const std::vector<acquisition::Recording> recordings =
      acquisition::read_recordings(bundle);
  int blows = 0;
  int overloaded = 0;
  for (const acquisition::Recording& recording : recordings) {
    EXPECT_EQ(recording.sample_rate_hz, result.rate_hz);
    blows += pulses(recording, 3.0);
    bool clipped = false;
    for (int c = 1; c < 3; ++c) {
      const double full_scale =
          bundle.channels[static_cast<std::size_t>(c)].full_scale_si();
      clipped |= recording.samples.col(c).cwiseAbs().maxCoeff() >
                 full_scale * (1.0 - 1e-6);
    }
    overloaded += clipped ? 1 : 0;
  }
  EXPECT_EQ(blows, 4 * 2 + 1) << "one of them a second blow";
  EXPECT_EQ(overloaded, 1);
}

TEST(VirtualBundle, SameSeedSameBytes) {
  const fs::path first = fresh_folder("first");
  const fs::path again = fresh_folder("again");
  (void)make_virtual_bundle(small_spec(), first);
  VirtualBundleSpec longer = small_spec();
  longer.points = 5;
  (void)make_virtual_bundle(longer, again);
  longer.points = 4;
  (void)make_virtual_bundle(longer, again, {}, {{}, true});
  for (const char* file :
       {"test.json", "model.bdf", "truth.json", "run-01.flac", "run-04.flac"}) {
    EXPECT_EQ(bytes_of(first / file), bytes_of(again / file)) << file;
    EXPECT_FALSE(bytes_of(first / file).empty()) << file;
  }
}

TEST(VirtualBundle, DriftTurnsEveryRunAnotherWay) {
  VirtualBundleSpec spec;
  spec.structure = "portal";
  spec.points = 3;
  spec.hits = 1;
  spec.gap_s = 1.0;
  spec.faulty_hits = false;
  const fs::path still = fresh_folder("still");
  const fs::path drifting = fresh_folder("drifting");
  (void)make_virtual_bundle(spec, still);
  spec.effects = {parse_virtual_effect("drift=4")};
  (void)make_virtual_bundle(spec, drifting);
  // The first run is stiffer, the last softer; the middle one is as it was.
  EXPECT_NE(bytes_of(still / "run-01.flac"),
            bytes_of(drifting / "run-01.flac"));
  EXPECT_EQ(bytes_of(still / "run-02.flac"),
            bytes_of(drifting / "run-02.flac"));
  EXPECT_NE(bytes_of(still / "run-03.flac"),
            bytes_of(drifting / "run-03.flac"));
}

// Whatever it is called, it may be somebody's.
TEST(VirtualBundle, TakesNoFileAway) {
  const fs::path folder = fresh_folder("others");
  fs::create_directories(folder);
  std::ofstream(folder / "run-05.flac") << "mine";
  for (const bool force : {false, true}) {
    (void)make_virtual_bundle(small_spec(), folder, {}, {{}, force});
    EXPECT_EQ(bytes_of(folder / "run-05.flac"), "mine") << force;
  }
}

TEST(VirtualBundle, KnowsItsFilesAsLongAsTheyAreAsTheyWere) {
  const fs::path folder = fresh_folder("made");
  EXPECT_TRUE(made_files(folder).empty());
  (void)make_virtual_bundle(small_spec(), folder);
  std::ofstream(folder / "run-05.flac") << "mine";
  const auto knows = [&folder](const char* name) {
    return acquisition::OutputRule{made_files(folder), true}.is_input(folder /
                                                                      name);
  };
  for (const char* name :
       {"test.json", "model.bdf", "truth.json", "run-01.flac", "run-04.flac"}) {
    EXPECT_TRUE(knows(name)) << name;
  }
  EXPECT_FALSE(knows("run-05.flac"));
  std::ofstream(folder / "run-02.flac") << "mine";
  std::ofstream(folder / "test.json", std::ios::app) << ' ';
  EXPECT_FALSE(knows("run-02.flac"));
  EXPECT_FALSE(knows("test.json"));
  EXPECT_TRUE(knows("run-01.flac"));
  // Another's truth.json says nothing of this program's files.
  std::string truth = bytes_of(folder / "truth.json");
  truth.replace(truth.find("\"seed\": 5"), 9, "\"seed\": 6");
  std::ofstream(folder / "truth.json") << truth;
  EXPECT_TRUE(made_files(folder).empty());
}

// A sheet on which one accelerometer of several is unlike the others would tell
// whose gain is off.
TEST(VirtualBundle, TheSheetDoesNotTellWhoseGainIsOff) {
  VirtualBundleSpec spec = small_spec();
  for (const char* gain : {"channel-gain@acc1=0.1", "channel-gain@acc1=10"}) {
    spec.effects = {parse_virtual_effect(gain)};
    const fs::path folder = fresh_folder("gain");
    (void)make_virtual_bundle(spec, folder);
    const auto test = nlohmann::json::parse(bytes_of(folder / "test.json"));
    const nlohmann::json& channels = test["channels"];
    ASSERT_GE(channels.size(), 3U);
    for (std::size_t c = 2; c < channels.size(); ++c) {
      EXPECT_EQ(channels[c]["sensitivity"], channels[1]["sensitivity"]) << gain;
    }
  }
}

TEST(VirtualBundle, RefusesToReplaceATest) {
  const fs::path folder = fresh_folder("kept");
  fs::create_directories(folder);
  std::ofstream(folder / "test.json") << "{}";
  EXPECT_THROW((void)make_virtual_bundle(small_spec(), folder), InputError);
  EXPECT_EQ(bytes_of(folder / "test.json"), "{}");
}

TEST(VirtualBundle, RefusesAFolderWithWorkOnAnotherTest) {
  const fs::path folder = fresh_folder("played");
  fs::create_directories(folder);
  std::ofstream(folder / "session.json") << "{}";
  EXPECT_THROW((void)make_virtual_bundle(small_spec(), folder), InputError);
  EXPECT_FALSE(fs::exists(folder / "test.json"));
  EXPECT_EQ(bytes_of(folder / "session.json"), "{}");
}

TEST(VirtualBundle, RefusesADeckWithoutBandAndChannelsThatAreNone) {
  VirtualBundleSpec spec = small_spec();
  spec.effects = {parse_virtual_effect("channel-gain@acc9=1.1")};
  EXPECT_THROW((void)make_virtual_bundle(spec, fresh_folder("none")),
               InputError);
  // The hammer is no sensor.
  for (const char* text :
       {"channel-swap@acc1:hammer", "sensor-mass@hammer=1"}) {
    spec.effects = {parse_virtual_effect(text)};
    EXPECT_THROW((void)make_virtual_bundle(spec, fresh_folder("none")),
                 InputError)
        << text;
  }
  spec = small_spec();
  spec.structure = "somewhere.bdf";
  EXPECT_THROW((void)make_virtual_bundle(spec, fresh_folder("none")),
               InputError);
}

TEST(DemoRecording, TruthIsNearThePaper) {
  // Table 7, measured: 2.15 7.81 12.71 26.76 Hz.
  std::ifstream in(TAPFIT_SOURCE_DIR
                   "/recordings/solar-panel-frame/truth.json");
  ASSERT_TRUE(in);
  const nlohmann::json truth = nlohmann::json::parse(in);
  const auto hz = truth["natural_frequencies_hz"].get<std::vector<double>>();
  ASSERT_GE(hz.size(), 4U);
  EXPECT_NEAR(hz[0], 2.15, 0.05 * 2.15);
  EXPECT_NEAR(hz[1], 7.81, 0.08 * 7.81);
  EXPECT_NEAR(hz[2], 12.71, 0.03 * 12.71);
  EXPECT_NEAR(hz[3], 26.76, 0.15 * 26.76);
}

TEST(DemoRecording, HoldsWhatItsReadmeSays) {
  const acquisition::TestBundle bundle = acquisition::read_test_bundle(
      TAPFIT_SOURCE_DIR "/recordings/solar-panel-frame");
  EXPECT_TRUE(bundle.warnings.empty());
  EXPECT_EQ(bundle.runs.size(), 24U);
  int driving = 0;
  for (const acquisition::Run& run : bundle.runs) {
    for (const acquisition::Placement& sensor : run.sensors) {
      driving += sensor.dof.node == run.hammer.dof.node ? 1 : 0;
    }
  }
  EXPECT_EQ(driving, 2);
  EXPECT_EQ(bundle.channels[1].mass_kg.value(), 0.020);
  std::uintmax_t bytes = 0;
  for (const fs::directory_entry& entry :
       fs::directory_iterator(bundle.folder)) {
    bytes += entry.file_size();
  }
  EXPECT_LT(bytes, 10'000'000U);
}

}  // namespace
}  // namespace tapfit::updating
