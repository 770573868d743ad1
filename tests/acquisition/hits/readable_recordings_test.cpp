#include "acquisition/hits/readable_recordings.hpp"

#include "acquisition/bundle/read_test_bundle.hpp"
#include "acquisition/bundle/run_reader.hpp"
#include "acquisition/bundle/uff_records.hpp"
#include "acquisition/foundation/input_error.hpp"
#include "acquisition/readers/audio_file.hpp"
#include "tests/acquisition/support/hammer_record.hpp"
#include "tests/acquisition/support/temporary_folder.hpp"
#include "tests/support/matchers.hpp"

#include <filesystem>
#include <fstream>
#include <random>

namespace tapfit::acquisition {
namespace {

// Three runs of two blows each; what a test spoils is one of their files.
class ReadableRecordingsTest : public ::testing::Test {
 protected:
  ReadableRecordingsTest() {
    bundle_ = testing::hammer_bundle();
    bundle_.runs.resize(3, bundle_.runs[0]);
    for (std::size_t r = 0; r < 3; ++r) {
      bundle_.runs[r].file = folder_.path() / ("run" + std::to_string(r));
      write(r, rate);
    }
  }
  void write(std::size_t run, int at_hz, double peak = 0.1) {
    Eigen::VectorXd force = Eigen::VectorXd::Zero(8192);
    for (const double time_s : {1.0, 4.0}) {
      testing::add_pulse(force, rate, time_s, 0.004, peak, false);
    }
    std::mt19937_64 random(run + 1);
    if (peak == 0.0) testing::add_noise(force, 1e-4, random);
    Eigen::MatrixXd samples(force.size(), 2);
    samples << force, 0.5 * force;
    write_audio(
        bundle_.runs[run].file, samples, at_hz, AudioFormat::WavFloat64);
  }

  static constexpr int rate = 1024;
  testing::TemporaryFolder folder_;
  TestBundle bundle_;
};

TEST_F(ReadableRecordingsTest, AreAllWhereNothingIsWrong) {
  ReadableRecordings all = read_readable(bundle_);
  EXPECT_TRUE(all.left_out.empty());
  const HitSet hits = find_readable_hits(bundle_, all, {});
  for (const auto& run : hits.runs) EXPECT_EQ(run.size(), 2U);
}

TEST_F(ReadableRecordingsTest, LeaveOutWhatCannotBeRead) {
  folder_.write("run1", "no sound");
  ReadableRecordings all = read_readable(bundle_);
  ASSERT_EQ(all.left_out.size(), 1U);
  const std::string said = statement(all.left_out[0]);
  EXPECT_EQ(said.rfind("run 2 is left out: ", 0), 0U) << said;
  EXPECT_THAT(said, HasSubstr("run1"));
  const HitSet hits = find_readable_hits(bundle_, all, {});
  ASSERT_EQ(hits.runs.size(), 3U);
  EXPECT_EQ(hits.runs[0].size(), 2U);
  EXPECT_TRUE(hits.runs[1].empty());
  EXPECT_EQ(hits.runs[2].size(), 2U);
  // The recordings are there as before.
  EXPECT_EQ(all.recordings[0].samples.rows(), 8192);
  EXPECT_EQ(all.recordings[1].samples.rows(), 0);
  EXPECT_EQ(all.recordings[1].sample_rate_hz, rate);
  EXPECT_EQ(all.recordings[2].samples.rows(), 8192);
}

TEST_F(ReadableRecordingsTest, LeaveOutWhatIsNotThere) {
  EXPECT_NO_THROW(check_run_files(bundle_, Unreadable::Refused));
  std::filesystem::remove(bundle_.runs[1].file);
  const auto refused = [this](Unreadable missing) {
    return refusal_of([&] { check_run_files(bundle_, missing); });
  };
  const std::string said = refused(Unreadable::Refused);
  EXPECT_THAT(said, HasSubstr("test.json: runs[1].file"));
  EXPECT_EQ(refused(Unreadable::LeftOut), "");
  const ReadableRecordings all = read_readable(bundle_);
  ASSERT_EQ(all.left_out.size(), 1U);
  EXPECT_EQ(all.left_out[0].run, 1U);
  EXPECT_THAT(std::string(all.left_out[0].why.what()), HasSubstr("run1"));
  for (const std::size_t r : {0U, 2U}) {
    std::filesystem::remove(bundle_.runs[r].file);
  }
  const std::string none = refused(Unreadable::LeftOut);
  EXPECT_THAT(none, HasSubstr("nor that of any other run"));
}

TEST_F(ReadableRecordingsTest, LeaveOutAnotherSamplingRate) {
  write(2, 2 * rate);
  const ReadableRecordings all = read_readable(bundle_);
  ASSERT_EQ(all.left_out.size(), 1U);
  EXPECT_EQ(all.left_out[0].run, 2U);
  EXPECT_THAT(std::string(all.left_out[0].why.what()), HasSubstr("2048 Hz"));
}

TEST_F(ReadableRecordingsTest, AreRefusedWhereNoneIsLeft) {
  for (const char* file : {"run0", "run1", "run2"}) folder_.write(file, "");
  EXPECT_THROW((void)read_readable(bundle_), InputError);
}

// Their samples stay, to be looked at.
TEST_F(ReadableRecordingsTest, LeaveOutRunsWithoutAHit) {
  write(0, rate, 0.0);
  write(2, rate, 0.0);
  ReadableRecordings all = read_readable(bundle_);
  EXPECT_TRUE(all.left_out.empty());
  const HitSet hits = find_readable_hits(bundle_, all, {});
  ASSERT_EQ(all.left_out.size(), 2U);
  EXPECT_EQ(all.left_out[0].run, 0U);
  EXPECT_EQ(all.left_out[1].run, 2U);
  EXPECT_THAT(std::string(all.left_out[1].why.what()),
              HasSubstr("no hit was found"));
  EXPECT_THAT(std::string(all.left_out[1].why.what()), HasSubstr("run2"));
  ASSERT_EQ(hits.runs.size(), 3U);
  EXPECT_TRUE(hits.runs[0].empty());
  EXPECT_EQ(hits.runs[1].size(), 2U);
  EXPECT_TRUE(hits.runs[2].empty());
  EXPECT_EQ(all.recordings[2].samples.rows(), 8192);
}

// What one that cannot be read leaves is counted anew.
TEST_F(ReadableRecordingsTest, LeaveOutOneForEachReason) {
  folder_.write("run0", "no sound");
  write(1, rate, 0.0);
  ReadableRecordings all = read_readable(bundle_);
  const HitSet hits = find_readable_hits(bundle_, all, {});
  ASSERT_EQ(all.left_out.size(), 2U);
  EXPECT_EQ(all.left_out[1].run, 1U);
  EXPECT_EQ(hits.runs[2].size(), 2U);
}

TEST_F(ReadableRecordingsTest, AreRefusedWhereNoRunHasAHit) {
  for (const std::size_t r : {0U, 1U, 2U}) write(r, rate, 0.0);
  ReadableRecordings all = read_readable(bundle_);
  EXPECT_THROW((void)find_readable_hits(bundle_, all, {}), InputError);
  EXPECT_TRUE(all.left_out.empty());
}

// All runs in one universal file, of which one has a dead channel.
TEST_F(ReadableRecordingsTest, LeaveOutOneRunOfAUniversalFile) {
  const std::filesystem::path file = folder_.path() / "test.uff";
  {
    std::ofstream out(file, std::ios::binary);
    write_uff_records(bundle_, UffEncoding::Binary, out);
    Recording dead = read_recording(bundle_, bundle_.runs[1]);
    dead.samples.col(1).setZero();
    int number = 7;
    write_uff_run(
        bundle_, bundle_.runs[1], dead, UffEncoding::Binary, number, out);
  }
  const TestBundle bundle = read_test_bundle(file);
  ASSERT_EQ(bundle.runs.size(), 4U);
  EXPECT_THROW((void)read_recordings(bundle), InputError);
  ReadableRecordings all = read_readable(bundle);
  ASSERT_EQ(all.left_out.size(), 1U);
  EXPECT_EQ(all.left_out[0].run, 3U);
  EXPECT_THAT(std::string(all.left_out[0].why.what()), HasSubstr("is dead"));
  const HitSet hits = find_readable_hits(bundle, all, {});
  EXPECT_EQ(hits.runs[2].size(), 2U);
  EXPECT_TRUE(hits.runs[3].empty());
}

// Also where what follows fails.
TEST_F(ReadableRecordingsTest, GiveTheRecordingsBack) {
  folder_.write("run1", "no sound");
  ReadableRecordings all = read_readable(bundle_);
  for (const std::size_t r : {0U, 2U}) all.recordings[r].samples.setZero();
  EXPECT_THROW((void)find_readable_hits(bundle_, all, {}), InputError);
  EXPECT_EQ(all.recordings[0].samples.rows(), 8192);
}

}  // namespace
}  // namespace tapfit::acquisition
