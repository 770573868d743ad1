// How often hits are judged rightly, over random records of the whole range:
// pulses of 0.2 to 10 ms, blocks of 0.5 to 16 s, 256 Hz to 51.2 kHz, each drawn
// evenly in its logarithm.
//
//   hit_judgement_study [SEED [COUNT]]
//
// COUNT records of each kind. Width counts as the hammer channel shows it: two
// samples more than the blow's own, which the anti-alias filter adds.
#include "acquisition/hits/find_hits.hpp"
#include "tests/acquisition/support/judged_records.hpp"
#include "tests/acquisition/support/saturated_records.hpp"
#include "tests/acquisition/support/soft_records.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdlib>

namespace tapfit {
namespace {

using acquisition::is_overloaded;
using testing::between;
using testing::judged_double;
using testing::judged_overload;
using testing::make;
using testing::Rate;
using testing::TestContext;

// Whether some of the pulse's own width is left to be seen.
enum class Width { SubSample, Resolved };

TestContext draw(Width width, std::mt19937_64& random) {
  for (;;) {
    const TestContext s{between(256.0, 51200.0, random),
                        between(0.2e-3, 10e-3, random),
                        between(0.5, 16.0, random)};
    const bool resolved = s.width_s * s.rate >= 0.5;
    if (resolved == (width == Width::Resolved)) return s;
  }
}

void say(const char* what, double value, const Rate& rate) {
  fmt::print("{:<44} {:8.0e} {:7.2f} % of {}\n",
             what,
             value,
             rate.percent(),
             rate.all);
  std::fflush(stdout);
}

void second_blows(unsigned seed, int count) {
  for (const Width width : {Width::Resolved, Width::SubSample}) {
    const bool resolved = width == Width::Resolved;
    fmt::print("pulses of {} half a sample\n",
               resolved ? "more than" : "below");
    for (const double noise : {1e-5, 1e-3, 1e-2}) {
      std::mt19937_64 random(seed);
      Rate rate;
      for (; rate.all < count; ++rate.all) {
        const TestContext s = draw(width, random);
        rate.yes += judged_double(make(s, 0.0, noise, random), s.rate) ? 1 : 0;
      }
      say("  single blow called double, noise", noise, rate);
    }
    for (const double share : {0.05, 0.1, 0.3, 1.0}) {
      std::mt19937_64 random(seed + 1);
      Rate rate;
      for (; rate.all < count; ++rate.all) {
        const TestContext s = draw(width, random);
        rate.yes += judged_double(make(s, share, 1e-4, random), s.rate) ? 1 : 0;
      }
      say("  second blow found, share", share, rate);
    }
  }
}

// Several modes and blows of many shapes, the noise known from the record.
void clipping_in_noise(unsigned seed, int count) {
  for (const bool blow : {false, true}) {
    for (const double noise : {1e-4, 1e-3, 3e-3, 1e-2}) {
      std::mt19937_64 random(seed);
      Rate alarms;
      Rate found;
      for (; alarms.all < count; ++alarms.all, ++found.all) {
        const Eigen::VectorXd x =
            blow ? testing::any_pulse(random) : testing::ringing_modes(random);
        const double level = between(0.05, 0.95, random);
        alarms.yes +=
            judged_overload(testing::converted(level * x, 1.0, noise, random));
        const double clip = between(0.3, 0.9, random);
        const double over = between(1.2, 3.0, random);
        found.yes += judged_overload(
            testing::converted(over * clip * x, clip, noise, random));
      }
      const char* what = blow ? "blow" : "modes";
      say(fmt::format("unclipped {} called overload, noise", what).c_str(),
          noise,
          alarms);
      say(fmt::format("clipped {} found, noise after", what).c_str(),
          noise,
          found);
    }
  }
}

// Blows of one tip, its width scattering as an ordinary hand's does; shapes
// from a half sine to Hann's, no band given.
void soft_blows(unsigned seed, int count) {
  for (const double scatter : {0.0, 0.08}) {
    std::mt19937_64 random(seed + 4);
    Rate rate;
    for (int k = 0; k < count; ++k) {
      const TestContext s = draw(Width::Resolved, random);
      const double power =
          std::uniform_real_distribution<double>(1.0, 2.0)(random);
      const acquisition::HitSet hits =
          testing::hits_of({s.rate, s.width_s, power, scatter}, random);
      rate.yes += testing::judged_soft(hits);
      rate.all += static_cast<int>(hits.runs[0].size());
    }
    say("usual blow called soft, scatter of width", scatter, rate);
  }
}

void clipping(unsigned seed, int count) {
  std::mt19937_64 random(seed + 2);
  Rate alarms;
  for (; alarms.all < count; ++alarms.all) {
    const Eigen::VectorXd x = testing::decay16(
        between(1.0, 1000.0, random), between(0.05, 0.95, random), 1.0);
    const double noise = acquisition::difference_noise(x);
    alarms.yes += is_overloaded(x, 1.0, noise) ? 1 : 0;
  }
  say("unclipped decay called overload", 0.0, alarms);
  for (const double noise : {0.0, 1e-5, 1e-4, 1e-3}) {
    Rate rate;
    for (; rate.all < count; ++rate.all) {
      const double clip = between(0.3, 0.9, random);
      Eigen::VectorXd x = testing::decay16(
          between(2.0, 400.0, random), between(1.2, 3.0, random) * clip, clip);
      testing::add_noise(x, noise, random);
      rate.yes += is_overloaded(x, 1.0, noise) ? 1 : 0;
    }
    say("clipped below full scale found, noise after", noise, rate);
  }
  clipping_in_noise(seed + 3, count);
}

std::ptrdiff_t overloads(const acquisition::HitSet& hits) {
  return std::ranges::count_if(hits.runs[0], [](const acquisition::Hit& hit) {
    return std::ranges::count(hit.reasons, acquisition::HitFault::Overload) > 0;
  });
}

// Honest blows of all shapes that are called overloads, and how many hits are
// in records that a warning speaks of.
void honest_blows(acquisition::SeededRandom& random, int count) {
  Rate alarms;
  Rate warnings;
  for (int k = 0; k < count; ++k) {
    const acquisition::HitSet hits = acquisition::find_hits(
        testing::hammer_bundle(),
        {testing::saturated(testing::any_blows(random), random).recording},
        {});
    const auto all = static_cast<int>(hits.runs[0].size());
    alarms.yes += static_cast<int>(overloads(hits));
    alarms.all += all;
    warnings.yes += testing::tells_of_ceiling(hits) ? all : 0;
    warnings.all += all;
  }
  say("honest blow called overload", 0.0, alarms);
  say("honest blow in a record warned of", 0.0, warnings);
}

// Blows that a conditioner cuts off ahead of the filter, by how much too large
// |H| is: judged out, and judged out or warned of.
void saturated_blows(acquisition::SeededRandom& random, int count) {
  constexpr std::array<double, 6> bounds = {0.005, 0.02, 0.04, 0.07, 0.14, 0.3};
  std::array<Rate, 5> out;
  std::array<Rate, 5> told;
  for (int k = 0; k < count; ++k) {
    testing::Blows blows = testing::any_blows(random);
    testing::saturate(blows, random);
    const testing::Saturated record = testing::saturated(blows, random);
    const acquisition::HitSet hits = acquisition::find_hits(
        testing::hammer_bundle(), {record.recording}, {});
    if (hits.runs[0].size() != record.errors.size()) continue;
    for (std::size_t i = 0; i < record.errors.size(); ++i) {
      const auto above = std::ranges::upper_bound(bounds, record.errors[i]);
      if (above == bounds.begin() || above == bounds.end()) continue;
      const auto bin = static_cast<std::size_t>(above - bounds.begin() - 1);
      const std::vector<acquisition::HitFault>& reasons =
          hits.runs[0][i].reasons;
      const bool judged =
          std::ranges::count(reasons, acquisition::HitFault::Overload) > 0;
      out[bin].yes += judged ? 1 : 0;
      told[bin].yes += judged || testing::tells_of_ceiling(hits) ? 1 : 0;
      ++out[bin].all;
      ++told[bin].all;
    }
  }
  constexpr std::array<double, 5> about = {0.01, 0.03, 0.05, 0.1, 0.2};
  for (std::size_t bin = 0; bin < out.size(); ++bin) {
    say("blow cut ahead of the filter found, |H| +", about[bin], out[bin]);
    say("  or its record warned of", about[bin], told[bin]);
  }
}

}  // namespace
}  // namespace tapfit

int main(int argc, char** argv) {
  const int seed = argc > 1 ? std::atoi(argv[1]) : 1;
  const int count = argc > 2 ? std::atoi(argv[2]) : 500;
  tapfit::second_blows(static_cast<unsigned>(seed), count);
  tapfit::soft_blows(static_cast<unsigned>(seed), count);
  tapfit::clipping(static_cast<unsigned>(seed), count);
  tapfit::acquisition::SeededRandom random(static_cast<unsigned>(seed),
                                           "conditioner");
  tapfit::honest_blows(random, count);
  tapfit::saturated_blows(random, count);
  return 0;
}
