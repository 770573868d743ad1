// From a recording to its FRFs, against what cannot be avoided: reading the
// samples, and transforming each hit's block with FFTW.
//
//   Read        the file decoded into a matrix
//   ReadAndFft  the same, and one transform per hit and channel
//   Frfs        the whole step: hits found and judged, blocks cut and windowed,
//               noise, FRFs with coherence and variance
//   FindHits, EstimateFrfs   its two halves, samples already read
//   Replay      the same piece by piece
//
// Frfs is to take at most 1.5 times ReadAndFft. Both use all cores alike; with
// `taskset -c 0` both run on one thread, and the times of the processor can be
// compared on a busy machine too.
#include "acquisition/bundle/run_reader.hpp"
#include "acquisition/foundation/parallel.hpp"
#include "acquisition/hits/find_hits.hpp"
#include "acquisition/readers/audio_file.hpp"
#include "acquisition/simulator/hammer_pulse.hpp"
#include "signal/estimate/estimate_frfs.hpp"
#include "signal/estimate/replay.hpp"
#include "signal/spectra/fft.hpp"

#include <benchmark/benchmark.h>

#include <cmath>
#include <filesystem>
#include <numbers>
#include <random>

namespace tapfit {
namespace {

using acquisition::Recording;
using acquisition::TestBundle;
using Eigen::Index;

constexpr int rate = 51200;
constexpr double full_scale = 100.0;

// Ten hits, 6 s apart, on three modes; four channels of 24 bits: 37 MB.
Eigen::MatrixXd samples_of_hammer_test() {
  acquisition::SeededRandom random(1, "hits");
  acquisition::HammerHand hand;
  hand.hits = 10;
  hand.gap_s = 6.0;
  hand.width_s = 1e-3;
  const auto pulses = ordinary_hits(hand, random);
  const auto n = static_cast<Index>(duration(hand) * rate);
  Eigen::MatrixXd x(n, 4);
  x.col(0) = force_of(pulses, n, rate);
  for (Index c = 1; c < 4; ++c) {
    x.col(c).setZero();
    for (const double hz : {180.0, 612.0, 1423.0}) {
      const double w = 2.0 * std::numbers::pi * hz;
      const std::complex<double> step =
          std::exp(std::complex<double>(-0.005 * w, w) / double{rate});
      std::complex<double> z = 0.0;
      for (Index i = 0; i < n; ++i) {
        z = step * z + x(i, 0);
        x(i, c) += 0.01 * static_cast<double>(c) * z.imag();
      }
    }
  }
  std::mt19937_64 engine(2);
  std::normal_distribution<double> normal(0.0, 1e-3);
  for (double& value : x.reshaped()) value += normal(engine);
  return x / full_scale;
}

TestBundle bundle_on_disk() {
  const auto folder =
      std::filesystem::temp_directory_path() / "tapfit-frf-benchmark";
  std::filesystem::create_directories(folder);
  TestBundle bundle;
  acquisition::Channel channel;
  channel.full_scale_volts = full_scale;
  channel.quantity = acquisition::Quantity::Force;
  bundle.channels.push_back(channel);
  channel.quantity = acquisition::Quantity::Acceleration;
  bundle.channels.insert(bundle.channels.end(), 3, channel);
  acquisition::Run run;
  run.file = folder / "run.wav";
  run.hammer = {0, {1, 3, 1}};
  for (std::size_t c = 1; c < 4; ++c) {
    run.sensors.push_back({c, {static_cast<int>(c), 3, 1}});
  }
  bundle.runs = {run};
  bundle.band_hz = {50.0, 1200.0};
  if (!std::filesystem::exists(run.file)) {
    write_audio(run.file,
                samples_of_hammer_test(),
                rate,
                acquisition::AudioFormat::Wav24);
  }
  return bundle;
}

const TestBundle& bundle() {
  static const TestBundle made = bundle_on_disk();
  return made;
}

void Read(benchmark::State& state) {
  for (auto unused : state) {
    benchmark::DoNotOptimize(acquisition::read_audio(bundle().runs[0].file));
  }
}

void ReadAndFft(benchmark::State& state) {
  const auto recordings = read_recordings(bundle());
  const auto hits = find_hits(bundle(), recordings, {});
  for (auto unused : state) {
    const auto audio = acquisition::read_audio(bundle().runs[0].file);
    const signal::RealFft planned(hits.block);
    for_each_parallel(
        static_cast<std::size_t>(audio.samples.cols()), [&](std::size_t c) {
          signal::RealFft fft = planned;
          const auto channel = audio.samples.col(static_cast<Index>(c));
          for (const acquisition::Hit& hit : hits.runs[0]) {
            if (!hit.accepted) continue;
            benchmark::DoNotOptimize(
                fft.transform(channel.segment(hit.begin, hits.block)));
          }
        });
  }
  state.counters["block"] = static_cast<double>(hits.block);
  state.counters["accepted"] = static_cast<double>(std::count_if(
      hits.runs[0].begin(), hits.runs[0].end(), [](const auto& hit) {
        return hit.accepted;
      }));
}

void Frfs(benchmark::State& state) {
  for (auto unused : state) {
    const auto recordings = read_recordings(bundle());
    const auto hits = find_hits(bundle(), recordings, {});
    benchmark::DoNotOptimize(
        signal::estimate_frfs(bundle(), recordings, hits, {}));
  }
}

void FindHits(benchmark::State& state) {
  const auto recordings = read_recordings(bundle());
  for (auto unused : state) {
    benchmark::DoNotOptimize(find_hits(bundle(), recordings, {}));
  }
}

void EstimateFrfs(benchmark::State& state) {
  const auto recordings = read_recordings(bundle());
  const auto hits = find_hits(bundle(), recordings, {});
  for (auto unused : state) {
    benchmark::DoNotOptimize(
        signal::estimate_frfs(bundle(), recordings, hits, {}));
  }
}

void Replay(benchmark::State& state) {
  for (auto unused : state) {
    benchmark::DoNotOptimize(signal::replay(bundle(), {}, {}));
  }
}

BENCHMARK(Read)->Unit(benchmark::kMillisecond);
BENCHMARK(ReadAndFft)->Unit(benchmark::kMillisecond);
BENCHMARK(Frfs)->Unit(benchmark::kMillisecond);
BENCHMARK(FindHits)->Unit(benchmark::kMillisecond);
BENCHMARK(EstimateFrfs)->Unit(benchmark::kMillisecond);
BENCHMARK(Replay)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace tapfit
