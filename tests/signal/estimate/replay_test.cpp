#include "signal/estimate/replay.hpp"

#include "acquisition/bundle/uff_bundle.hpp"
#include "acquisition/bundle/uff_records.hpp"
#include "acquisition/foundation/input_error.hpp"
#include "acquisition/hits/find_hits.hpp"
#include "acquisition/readers/audio_file.hpp"
#include "tests/acquisition/support/temporary_folder.hpp"
#include "tests/signal/support/generated_test.hpp"
#include "tests/support/matchers.hpp"

#include <chrono>

namespace tapfit::signal {
namespace {

using acquisition::Hit;
using acquisition::HitSet;

const std::vector<TestMode> two_modes{{20.0, 0.01, 1.0}, {61.0, 0.008, -0.7}};

class Replay : public ::testing::Test {
 protected:
  // Two runs of 40 hits, on disk: 170,000 samples each.
  Replay() {
    GeneratedOptions o;
    o.hits = 40;
    o.response_noise = 0.02;
    o.force_noise = 0.01;
    test_ = generate_test(two_modes, o);
    o.seed = 2;
    GeneratedTest second = generate_test(two_modes, o);
    // A second blow, a knocked sensor (ten times its answer), a faint hit.
    Eigen::MatrixXd& x = second.recordings[0].samples;
    const auto row = [&](int hit) { return o.lead + hit * o.gap; };
    x.col(0).segment(row(30) + 200, 12) +=
        0.3 * x.col(0).segment(row(30) - 3, 12);
    x.col(1).segment(row(20), o.gap) *= 10.0;
    x.block(row(10) - 5, 0, 30, 2) *= 0.1;
    test_.bundle.runs.push_back(test_.bundle.runs[0]);
    test_.bundle.runs[1].file = "run-02.wav";
    test_.bundle.runs[1].hammer.dof.node += 1;
    test_.recordings.push_back(second.recordings[0]);
    for (acquisition::Channel& channel : test_.bundle.channels) {
      channel.full_scale_volts = full_scale;
    }
    for (std::size_t r = 0; r < 2; ++r) {
      acquisition::Run& run = test_.bundle.runs[r];
      run.file = folder_.path() / run.file;
      write_audio(run.file,
                  test_.recordings[r].samples / full_scale,
                  512,
                  acquisition::AudioFormat::WavFloat64);
    }
    test_.bundle.band_hz = {2.0, 90.0};
    // The trial look sees the first ten hits of each run.
    options_.trial_samples = 2 * 2 * 10 * o.gap;
    // Seven pieces or more: 25,000 samples of two channels.
    options_.piece_samples = 50000;
  }

  // A power of two, so that samples come back as they were.
  static constexpr double full_scale = 1024.0;

  testing::TemporaryFolder folder_;
  GeneratedTest test_;
  ReplayOptions options_;
};

TEST_F(Replay, GivesWhatTheWholeRecordGives) {
  std::size_t seen = 0;
  const Replayed live = replay(test_.bundle, options_, [&](const LiveHit& now) {
    EXPECT_EQ(now.run, seen < 40 ? 0u : 1u);
    ++seen;
  });
  EXPECT_EQ(seen, 80u);
  acquisition::HitOptions fixed;
  fixed.trigger_n = live.hits.trigger_n;
  const double rate = live.hits.sample_rate_hz;
  fixed.block_s = static_cast<double>(live.hits.block) / rate;
  fixed.pre_trigger_s = static_cast<double>(live.hits.pre_trigger) / rate;
  fixed.trigger.hold_off_s = static_cast<double>(live.hits.hold_off) / rate;
  const HitSet whole = find_hits(test_.bundle, test_.recordings, fixed);
  ASSERT_EQ(whole.block, live.hits.block);
  for (std::size_t r = 0; r < 2; ++r) {
    ASSERT_EQ(live.hits.runs[r].size(), whole.runs[r].size());
    for (std::size_t k = 0; k < whole.runs[r].size(); ++k) {
      const Hit& now = live.hits.runs[r][k];
      EXPECT_EQ(now.trigger, whole.runs[r][k].trigger);
      EXPECT_EQ(now.reasons, whole.runs[r][k].reasons) << r << " " << k;
      EXPECT_EQ(now.accepted, whole.runs[r][k].accepted);
    }
  }
  EXPECT_FALSE(live.hits.runs[1][10].accepted);
  EXPECT_FALSE(live.hits.runs[1][20].accepted);
  EXPECT_FALSE(live.hits.runs[1][30].accepted);
  const FrfSet expected =
      estimate_frfs(test_.bundle, test_.recordings, whole, {});
  ASSERT_EQ(live.frfs.frfs.size(), 2u);
  for (std::size_t r = 0; r < 2; ++r) {
    const Frf& mine = live.frfs.frfs[r];
    const Frf& other = expected.frfs[r];
    EXPECT_EQ(mine.hits, other.hits);
    // The same sums in another order.
    EXPECT_LT((mine.H - other.H).cwiseAbs().maxCoeff(),
              1e-12 * other.H.cwiseAbs().maxCoeff());
    EXPECT_LT((mine.coherence - other.coherence).cwiseAbs().maxCoeff(), 1e-12);
    // The noise's spectrum is smoothed per hit instead of over all: a few
    // per cent of the variance.
    EXPECT_LT(
        (mine.variance.array() / other.variance.array() - 1.0).abs().maxCoeff(),
        0.2);
  }
}

// Two files of the same point: one average over both, as of whole records.
TEST_F(Replay, GoesOnAveragingWhereTheSamePointIsHitAgain) {
  test_.bundle.runs[1].hammer = test_.bundle.runs[0].hammer;
  std::vector<Eigen::Index> averaged;
  const Replayed live = replay(test_.bundle, options_, [&](const LiveHit& now) {
    if (now.hit.accepted) averaged.push_back(now.averaged);
  });
  ASSERT_EQ(live.frfs.frfs.size(), 1U);
  const Frf& mine = live.frfs.frfs[0];
  // 37 of the first run, 40 of the second.
  EXPECT_EQ(mine.hits, 77);
  EXPECT_EQ(averaged.back(), 77);
  HitSet hits = live.hits;
  const FrfSet expected =
      estimate_frfs(test_.bundle, test_.recordings, hits, {});
  ASSERT_EQ(expected.frfs.size(), 1U);
  EXPECT_LT((mine.H - expected.frfs[0].H).cwiseAbs().maxCoeff(),
            1e-12 * expected.frfs[0].H.cwiseAbs().maxCoeff());
}

// A sensitivity that was changed between the files is said, as of whole
// records.
TEST_F(Replay, SaysWhereFilesOfTheSamePointDiffer) {
  acquisition::Run& second = test_.bundle.runs[1];
  second.hammer = test_.bundle.runs[0].hammer;
  Eigen::MatrixXd samples = test_.recordings[1].samples / full_scale;
  samples.col(1) *= 1.25;
  write_audio(second.file, samples, 512, acquisition::AudioFormat::WavFloat64);
  const Replayed live = replay(test_.bundle, options_, {});
  ASSERT_FALSE(live.frfs.statements.empty());
  const std::string& said = live.frfs.statements.back();
  EXPECT_THAT(said, HasSubstr("runs 1 and 2 measured the same"));
  EXPECT_THAT(said, HasSubstr("by a factor of"));
}

// The same records in a universal file: streamed, binary or text, they give
// what the sound files give. Text has 13 digits.
// What the beginning has chosen is not what the whole record would choose.
TEST_F(Replay, SaysWhatWasChosenFromTheBeginning) {
  const auto says = [&] {
    const Replayed live = replay(test_.bundle, options_, {});
    return std::ranges::count_if(
        live.hits.statements, [](const std::string& text) {
          return text.starts_with("these were chosen from the first");
        });
  };
  EXPECT_EQ(says(), 1);
  options_.trial_samples = 4 << 20;
  EXPECT_EQ(says(), 0);
}

TEST_F(Replay, StreamsUniversalFiles) {
  const Replayed sound = replay(test_.bundle, options_, {});
  for (const auto& [encoding, digits] :
       {std::pair{acquisition::UffEncoding::Binary, 1e-14},
        std::pair{acquisition::UffEncoding::Text, 1e-8}}) {
    const auto path = folder_.path() / "records.uff";
    {
      std::ofstream file(path, std::ios::binary);
      write_uff_records(test_.bundle, encoding, file);
    }
    const Replayed uff =
        replay(acquisition::read_uff_bundle(path), options_, {});
    ASSERT_EQ(uff.frfs.frfs.size(), 2U);
    ASSERT_EQ(uff.hits.runs.size(), 2U);
    for (std::size_t r = 0; r < 2; ++r) {
      ASSERT_EQ(uff.hits.runs[r].size(), 40U);
      for (std::size_t k = 0; k < 40; ++k) {
        EXPECT_EQ(uff.hits.runs[r][k].trigger, sound.hits.runs[r][k].trigger);
        EXPECT_EQ(uff.hits.runs[r][k].reasons, sound.hits.runs[r][k].reasons);
      }
      const Eigen::VectorXcd& H = sound.frfs.frfs[r].H;
      ASSERT_EQ(uff.frfs.frfs[r].H.size(), H.size());
      EXPECT_LE((uff.frfs.frfs[r].H - H).cwiseAbs().maxCoeff(),
                digits * H.cwiseAbs().maxCoeff());
    }
  }
}

// 3 Hz with a damping ratio of 0.005 has 0.7 time constants in 8 s: replay
// says so, first, as the whole recording does.
TEST_F(Replay, ProposesALongerBlockBeforeAnyWindow) {
  GeneratedOptions o;
  o.hits = 10;
  o.response_noise = 0.002;
  const GeneratedTest lasting =
      generate_test({{3.0, 0.005, 1.0}, {61.0, 0.008, -0.7}}, o);
  test_.bundle.runs.pop_back();
  write_audio(test_.bundle.runs[0].file,
              lasting.recordings[0].samples / full_scale,
              512,
              acquisition::AudioFormat::WavFloat64);
  const Replayed live = replay(test_.bundle, options_, {});
  ASSERT_FALSE(live.frfs.statements.empty());
  const FrfSet whole =
      estimate_frfs(test_.bundle, lasting.recordings, live.hits, {});
  ASSERT_FALSE(whole.statements.empty());
  EXPECT_EQ(live.frfs.statements[0], whole.statements[0]);
  EXPECT_THAT(whole.statements[0], HasSubstr("before any window"));
}

TEST_F(Replay, KeepsPaceWithTheSpeed) {
  // 331 s of the first run at 400 times: 0.8 s, however fast the machine is.
  test_.bundle.runs.pop_back();
  options_.speed = 400.0;
  const auto start = std::chrono::steady_clock::now();
  (void)replay(test_.bundle, options_, {});
  const std::chrono::duration<double> took =
      std::chrono::steady_clock::now() - start;
  EXPECT_GT(took.count(), 0.8);
}

TEST_F(Replay, StopsWhenAsked) {
  std::stop_source stop;
  options_.speed = 1.0;
  Progress progress;
  progress.stop = stop.get_token();
  stop.request_stop();
  EXPECT_THROW((void)replay(test_.bundle, options_, {}, progress), Stopped);
}

// As whole recordings are: seen at the end, since it may yet wake up. The
// trial look sees but the beginning.
TEST_F(Replay, RefusesADeadChannelAtTheEnd) {
  Eigen::MatrixXd& samples = test_.recordings[1].samples;
  const auto write = [&] {
    write_audio(test_.bundle.runs[1].file,
                samples / full_scale,
                512,
                acquisition::AudioFormat::WavFloat64);
  };
  samples.col(1).setZero();
  write();
  int seen = 0;
  EXPECT_THAT(
      [&] {
        (void)replay(test_.bundle, options_, [&](const LiveHit&) { ++seen; });
      },
      Refuses("channel \"acc1\" is dead: every sample is 0"));
  // Its last hits are in the piece that tells.
  EXPECT_GT(seen, 60);
  samples(samples.rows() - 1, 1) = 0.1;
  write();
  EXPECT_NO_THROW((void)replay(test_.bundle, options_, {}));
}

TEST_F(Replay, RefusesWhatIsNotFiniteWithItsTime) {
  test_.recordings[0].samples(100000, 1) =
      std::numeric_limits<double>::quiet_NaN();
  write_audio(test_.bundle.runs[0].file,
              test_.recordings[0].samples,
              512,
              acquisition::AudioFormat::WavFloat64);
  try {
    (void)replay(test_.bundle, options_, {});
    FAIL() << "not a number was averaged";
  } catch (const InputError& error) {
    // 100000 / 512 s.
    EXPECT_THAT(error.what(), HasSubstr("at 195.312500 s"));
  }
}

}  // namespace
}  // namespace tapfit::signal
