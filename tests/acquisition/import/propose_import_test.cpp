// What `tapfit import FILE` makes of a file alone.
#include "acquisition/import/propose_import.hpp"

#include "acquisition/bundle/recording.hpp"
#include "acquisition/bundle/run_reader.hpp"
#include "acquisition/foundation/input_error.hpp"
#include "acquisition/import/channel_points.hpp"
#include "acquisition/import/hammer_channel.hpp"
#include "tests/acquisition/support/mat_text.hpp"
#include "tests/acquisition/support/npy_text.hpp"
#include "tests/acquisition/support/tdms_text.hpp"
#include "tests/acquisition/support/temporary_folder.hpp"
#include "tests/acquisition/support/uff_text.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace tapfit::acquisition {
namespace {

namespace fs = std::filesystem;

constexpr int samples = 600;

// Three half-sines of 6 samples.
Eigen::VectorXd pulses() {
  Eigen::VectorXd force = Eigen::VectorXd::Zero(samples);
  for (const int at : {50, 250, 450}) {
    for (int k = 0; k < 6; ++k) {
      force[at + k] = 80.0 * std::sin(0.5235987755982988 * (k + 0.5));
    }
  }
  return force;
}

// What rings after each of them.
Eigen::VectorXd ringing(double frequency) {
  Eigen::VectorXd motion = Eigen::VectorXd::Zero(samples);
  for (const int at : {50, 250, 450}) {
    for (int k = at; k < samples; ++k) {
      motion[k] +=
          3.0 * std::exp(-0.02 * (k - at)) * std::sin(frequency * (k - at));
    }
  }
  return motion;
}

std::vector<double> list(const Eigen::VectorXd& values) {
  return {values.begin(), values.end()};
}

class ProposeImport : public ::testing::Test {
 protected:
  testing::TemporaryFolder folder_;

  ImportProposal propose(const fs::path& file) {
    ImportOptions options;
    options.files = {{file, {}}};
    options.folder = folder_.path() / "bundle";
    return propose_import(options);
  }
  static bool assumed(const ImportProposal& proposal, const std::string& part) {
    return std::ranges::any_of(
        proposal.assumptions, [&](const ImportAssumption& assumption) {
          return assumption.what.find(part) != std::string::npos;
        });
  }
};

TEST_F(ProposeImport, RattlesnakesFileNeedsNoAssumption) {
  const ImportProposal proposal = propose(
      TAPFIT_SOURCE_DIR "/tests/acquisition/instruments/files/rattlesnake.nc");
  EXPECT_EQ(proposal.options.hammer.channel, "Force 3 Z+");
  ASSERT_EQ(proposal.options.sensors.size(), 2U);
  ASSERT_EQ(proposal.assumptions.size(), 1U);
  EXPECT_TRUE(assumed(proposal, "\"Voltage\" in V is left out"));
  const TestBundle bundle = import_recordings(proposal.options);
  EXPECT_EQ(bundle.runs[0].hammer.dof, (Dof{3, 3, 1}));
  EXPECT_EQ(bundle.runs[0].sensors[1].dof, (Dof{12, 3, -1}));
  EXPECT_DOUBLE_EQ(bundle.channels[1].sensitivity, 0.1) << "100 mV/g";
  const Recording recording = read_recording(bundle, bundle.runs[0]);
  EXPECT_EQ(recording.sample_rate_hz, 2048.0);
  EXPECT_DOUBLE_EQ(recording.samples(201, 0), 40.0);
  EXPECT_NEAR(recording.samples(210, 2),
              0.8 * std::exp(-0.125) * std::sin(2.0) * 9.80665,
              1e-14);
}

TEST_F(ProposeImport, UnitsNamesAndRateOfTdms) {
  const ImportProposal proposal = propose(folder_.write(
      "run.tdms", testing::tdms_hammer_test(list(pulses()), list(ringing(1)))));
  const TestBundle bundle = import_recordings(proposal.options);
  EXPECT_EQ(bundle.channels[0].name, "Hammer");
  EXPECT_EQ(bundle.channels[1].unit, "g");
  EXPECT_EQ(bundle.runs[0].sensors[0].dof, (Dof{12, 3, 1})) << "in its name";
  EXPECT_TRUE(assumed(proposal, "\"Hammer\" 13Z+"));
  EXPECT_FALSE(assumed(proposal, "unit"));
  const Recording recording = read_recording(bundle, bundle.runs[0]);
  EXPECT_EQ(recording.sample_rate_hz, 2048.0);
  EXPECT_DOUBLE_EQ(recording.samples(60, 1), ringing(1)[60] * 9.80665);
}

// Nothing but names: the pulses tell the hammer, X, Y and Z one point.
TEST_F(ProposeImport, AMuteFileIsTakenByItsShapes) {
  const fs::path file =
      folder_.write("run.npz",
                    testing::zip({{"a_x.npy", testing::npy(list(ringing(0.9)))},
                                  {"a_y.npy", testing::npy(list(ringing(1.3)))},
                                  {"ch3.npy", testing::npy(list(-pulses()))},
                                  {"a_z.npy", testing::npy(list(ringing(0.4)))},
                                  {"fs.npy", testing::npy({1000.0})}},
                                 true));
  const ImportProposal proposal = propose(file);
  EXPECT_EQ(proposal.options.hammer.column, "ch3");
  EXPECT_TRUE(assumed(proposal, "the hammer is \"ch3\", by its pulses"));
  EXPECT_TRUE(assumed(proposal, "\"ch3\" has no unit; N is taken"));
  EXPECT_TRUE(assumed(proposal, "\"a_x\" has no unit; m/s^2 is taken"));
  const TestBundle bundle = import_recordings(proposal.options);
  const acquisition::Run& run = bundle.runs[0];
  EXPECT_EQ(run.sensors[0].dof, (Dof{1, 1, 1}));
  EXPECT_EQ(run.sensors[1].dof, (Dof{1, 2, 1}));
  EXPECT_EQ(run.sensors[2].dof, (Dof{1, 3, 1}));
  EXPECT_EQ(run.hammer.dof, (Dof{2, 3, 1}));
  for (const ImportAssumption& assumption : proposal.assumptions) {
    EXPECT_FALSE(assumption.option.empty()) << assumption.what;
  }
}

TEST_F(ProposeImport, ChannelsInVoltsAreTakenWhereThereAreNoOthers) {
  const auto archive = [&](const std::string& units) {
    return folder_.write(
        "run.npz",
        testing::zip({{"f.npy", testing::npy(list(1e3 * pulses()))},
                      {"a.npy", testing::npy(list(ringing(0.9)))},
                      {"b.npy", testing::npy(list(ringing(0.8)))},
                      {"units.npy", testing::npy("|S5", "(3,)", units)},
                      {"fs.npy", testing::npy({1000.0})}},
                     false));
  };
  const std::string volts("mV\0\0\0V\0\0\0\0V\0\0\0\0", 15);
  const ImportProposal proposal = propose(archive(volts));
  EXPECT_TRUE(assumed(proposal, "\"a\" is in volts"));
  const TestBundle bundle = import_recordings(proposal.options);
  EXPECT_EQ(bundle.channels[0].sensitivity, 1.0);
  const Recording recording = read_recording(bundle, bundle.runs[0]);
  EXPECT_DOUBLE_EQ(recording.samples(53, 0), pulses()[53]) << "mV made V";
  // Beside a sensor with a unit, what is in volts is a drive.
  fs::remove_all(folder_.path() / "bundle");
  const std::string mixed("mV\0\0\0V\0\0\0\0m/s^2", 15);
  const ImportProposal other = propose(archive(mixed));
  EXPECT_EQ(other.options.hammer.column, "f");
  EXPECT_EQ(other.options.sensors.size(), 1U);
  EXPECT_TRUE(assumed(other, "\"a\" in V is left out"));
}

TEST_F(ProposeImport, ACsvWithAHeaderAndUnits) {
  std::string table = "time [s];hammer [N];acc 12X-\ns;N;g\n";
  const Eigen::VectorXd force = pulses();
  const Eigen::VectorXd motion = ringing(1.1);
  for (int k = 0; k < samples; ++k) {
    table +=
        fmt::format("{:.5f};{:.9g};{:.9g}\n", k / 800.0, force[k], motion[k]);
  }
  const ImportProposal proposal = propose(folder_.write("run.csv", table));
  EXPECT_EQ(proposal.options.hammer.column, "2");
  EXPECT_EQ(proposal.options.time_column, "1");
  const TestBundle bundle = import_recordings(proposal.options);
  EXPECT_EQ(bundle.channels[0].unit, "N");
  EXPECT_EQ(bundle.channels[1].unit, "g");
  EXPECT_EQ(bundle.runs[0].sensors[0].dof, (Dof{12, 1, -1}));
  EXPECT_EQ(read_recording(bundle, bundle.runs[0]).sample_rate_hz, 800.0);
}

// Neither with another unit, nor with one where the first has none.
TEST_F(ProposeImport, FilesOfDifferingUnitsAreNotTakenTogether) {
  const auto table = [&](const std::string& name, const std::string& unit) {
    std::string text = "time [s];hammer [N];acc" + unit + "\n";
    for (int k = 0; k < samples; ++k) {
      text += fmt::format(
          "{:.5f};{:.9g};{:.9g}\n", k / 800.0, pulses()[k], ringing(1.1)[k]);
    }
    return folder_.write(name, text);
  };
  const fs::path in_g = table("g.csv", " [g]");
  for (const fs::path& other :
       {table("si.csv", " [m/s^2]"), table("mute.csv", "")}) {
    ImportOptions options;
    options.files = {{other, {}}, {in_g, {}}};
    options.folder = folder_.path() / "bundle";
    const ImportProposal proposal = propose_import(options);
    EXPECT_THROW((void)import_recordings(proposal.options), InputError);
  }
}

TEST_F(ProposeImport, ASensorThatIsGivenIsNoHammer) {
  ImportOptions options;
  options.files = {
      {folder_.write("run.npz",
                     testing::zip({{"a.npy", testing::npy(list(ringing(1)))},
                                   {"b.npy", testing::npy(list(pulses()))},
                                   {"fs.npy", testing::npy({1000.0})}},
                                  false)),
       {}}};
  options.folder = folder_.path() / "bundle";
  options.sensors = {{.column = "b", .channel = "b", .dof = {7, 3, 1}}};
  EXPECT_EQ(propose_import(options).options.hammer.column, "a");
}

TEST_F(ProposeImport, WhatIsGivenIsNotProposed) {
  ImportOptions options;
  options.files = {{folder_.write("run.tdms",
                                  testing::tdms_hammer_test(list(pulses()),
                                                            list(ringing(1)))),
                    Dof{5, 1, -1}}};
  options.folder = folder_.path() / "bundle";
  options.sensors = {{.column = "Acc 12Z+",
                      .channel = "acc",
                      .unit = "m/s^2",
                      .dof = {7, 3, 1}}};
  const ImportProposal proposal = propose_import(options);
  const TestBundle bundle = import_recordings(proposal.options);
  EXPECT_EQ(bundle.channels[1].name, "acc");
  EXPECT_EQ(bundle.channels[1].unit, "m/s^2");
  EXPECT_EQ(bundle.runs[0].sensors[0].dof, (Dof{7, 3, 1}));
  EXPECT_EQ(bundle.runs[0].hammer.dof, (Dof{5, 1, -1}));
  EXPECT_TRUE(proposal.assumptions.empty());
}

TEST_F(ProposeImport, WhatIsMissingIsSaid) {
  const auto refusal = [&](const fs::path& file) {
    try {
      (void)propose(file);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  const std::string force = testing::mat4_variable("force", pulses());
  EXPECT_NE(refusal(folder_.write("one.mat", force)).find("no hammer with"),
            std::string::npos);
  EXPECT_NE(
      refusal(folder_.write("two.mat",
                            force + testing::mat4_variable("acc", ringing(1))))
          .find("does not say its sampling rate"),
      std::string::npos);
  const std::string run =
      testing::uff_ascii({.axis = 13, .unit = "N", .values = {0, 4, 0}}) +
      testing::uff_ascii({.unit = "g", .values = {1, 2, 3}});
  EXPECT_NE(refusal(folder_.write("runs.uff", run + run)).find("tapfit run"),
            std::string::npos);
}

// Of pulses of 6 samples in 200: 1/sqrt(p) for a square pulse is 5.8.
TEST(HammerChannel, IsTheOneWithShortPulsesToOneSide) {
  EXPECT_GT(one_sidedness(pulses()), 4.0);
  EXPECT_NEAR(one_sidedness(-pulses()), one_sidedness(pulses()), 1e-9);
  EXPECT_LT(one_sidedness(ringing(0.9)), 1.0);
  // A factor does not count, not even one whose cube overflows.
  EXPECT_NEAR(one_sidedness(1e200 * pulses()), one_sidedness(pulses()), 1e-9);
  EXPECT_EQ(one_sidedness(Eigen::VectorXd::Ones(10)), 0.0);
  // p = 1/101: skewness (1 - 2p)/sqrt(p(1 - p)) of a single sample set.
  Eigen::VectorXd single = Eigen::VectorXd::Zero(101);
  single[7] = -3.0;
  EXPECT_NEAR(one_sidedness(single), 99.0 / 10.0, 1e-9);
}

TEST_F(ProposeImport, TwoColumnsAtOnePointAreNamed) {
  std::string text = "t,Hammer [N],41Z+ [g],41Z+ [g],41X+ [g]\n";
  const Eigen::VectorXd force = pulses();
  const Eigen::VectorXd motion = ringing(0.9);
  for (int k = 0; k < samples; ++k) {
    text += fmt::format("{},{},{},{},{}\n",
                        k / 1000.0,
                        force[k],
                        motion[k],
                        -motion[k],
                        motion[k]);
  }
  const ImportProposal proposal = propose(folder_.write("twice.csv", text));
  EXPECT_TRUE(assumed(proposal, "\"41Z+\" and \"41Z+ 2\" are both at 41Z+"));
  EXPECT_FALSE(assumed(proposal, "41X+"));
}

TEST(HammerChannel, OfSeveralForcesThePulsesTell) {
  TimeRecord shaker{.column = "1", .name = "shaker", .unit = "N"};
  shaker.values = ringing(0.9);
  TimeRecord hammer{.column = "2", .name = "hammer", .unit = "lbf"};
  hammer.values = pulses();
  TimeRecord motion{.column = "3", .name = "acc", .unit = "g"};
  motion.values = Eigen::VectorXd::Zero(101);
  motion.values[7] = 1.0;
  const HammerChoice choice = choose_hammer({&motion, &shaker, &hammer});
  EXPECT_EQ(choice.channel, 2U);
  EXPECT_FALSE(choice.certain);
}

TEST(ChannelPoints, TriaxialSensorsAreOnePoint) {
  std::vector<TimeRecord> records;
  for (const char* name :
       {"seat x", "seat y", "seat z-", "relay", "12Z+", "P1X", "P1Y"}) {
    records.push_back({.column = name, .name = name, .unit = ""});
  }
  records[4].dof = Dof{12, 3, 1};
  std::vector<const TimeRecord*> all;
  for (const TimeRecord& record : records) all.push_back(&record);
  const std::vector<Dof> points = points_for(all);
  EXPECT_EQ(points[0], (Dof{13, 1, 1}));
  EXPECT_EQ(points[1], (Dof{13, 2, 1}));
  EXPECT_EQ(points[2], (Dof{13, 3, -1}));
  EXPECT_EQ(points[3], (Dof{14, 3, 1})) << "a word that ends in y";
  EXPECT_EQ(points[4], (Dof{12, 3, 1}));
  EXPECT_EQ(points[5], (Dof{15, 1, 1}));
  EXPECT_EQ(points[6], (Dof{15, 2, 1}));
}

}  // namespace
}  // namespace tapfit::acquisition
