// A bundle written as a universal file of time records has the same hits and
// FRFs when it is read again, to the bit.
#include "acquisition/bundle/read_test_bundle.hpp"
#include "acquisition/bundle/run_reader.hpp"
#include "acquisition/bundle/uff_records.hpp"
#include "acquisition/hits/find_hits.hpp"
#include "acquisition/readers/audio_file.hpp"
#include "signal/estimate/estimate_frfs.hpp"
#include "tests/acquisition/support/temporary_folder.hpp"
#include "tests/signal/support/generated_test.hpp"

#include <gtest/gtest.h>

#include <fstream>

namespace tapfit::signal {
namespace {

TEST(UffRoundTrip, GivesTheSameFrfs) {
  const testing::TemporaryFolder folder;
  GeneratedOptions o;
  o.hits = 4;
  o.response_noise = 0.01;
  GeneratedTest test =
      generate_test({{20.0, 0.01, 1.0}, {61.0, 0.008, -0.7}}, o);
  acquisition::TestBundle bundle = test.bundle;
  bundle.band_hz = {5.0, 90.0};
  for (acquisition::Channel& channel : bundle.channels) {
    channel.full_scale_volts = 40.0;
  }
  bundle.runs[0].file = folder.path() / "run.wav";
  write_audio(bundle.runs[0].file,
              test.recordings[0].samples / 40.0,
              static_cast<int>(o.fs),
              acquisition::AudioFormat::Wav24);
  const std::filesystem::path file = folder.path() / "records.uff";
  {
    std::ofstream out(file, std::ios::binary);
    write_uff_records(bundle, acquisition::UffEncoding::Binary, out);
  }
  const auto frfs_of = [](const acquisition::TestBundle& of) {
    const auto recordings = read_recordings(of);
    return estimate_frfs(of, recordings, find_hits(of, recordings, {}), {});
  };
  const FrfSet before = frfs_of(bundle);
  const FrfSet after = frfs_of(acquisition::read_test_bundle(file));
  ASSERT_EQ(after.frfs.size(), 1U);
  EXPECT_EQ(name(after.frfs[0]), name(before.frfs[0]));
  EXPECT_EQ(after.frfs[0].hits, before.frfs[0].hits);
  EXPECT_EQ(after.s, before.s);
  EXPECT_EQ(after.frfs[0].H, before.frfs[0].H);
  EXPECT_EQ(after.frfs[0].variance, before.frfs[0].variance);
}

}  // namespace
}  // namespace tapfit::signal
