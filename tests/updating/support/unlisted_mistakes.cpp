#include "tests/updating/support/unlisted_mistakes.hpp"

#include "tests/updating/support/resampled.hpp"
#include "tests/updating/support/sizes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace tapfit::updating::testing {
namespace {

using acquisition::Recording;
using Eigen::Index;
using Eigen::VectorXd;
using Sheet = SheetAndRecords;
using Plain = PlainOptions;

double rms(const VectorXd& x) {
  return std::sqrt(x.squaredNorm() / static_cast<double>(x.size()));
}

VectorXd noise(Index count, double sd, unsigned seed) {
  std::mt19937 engine(seed);
  std::normal_distribution<double> normal(0.0, sd);
  VectorXd x(count);
  for (double& value : x) value = normal(engine);
  return x;
}

VectorXd tone(const Recording& recording, double hz, double phase) {
  VectorXd x(recording.samples.rows());
  for (Index i = 0; i < x.size(); ++i) {
    x(i) = std::sin(2.0 * std::numbers::pi * hz * static_cast<double>(i) /
                        recording.sample_rate_hz +
                    phase);
  }
  return x;
}

// One pole: low-pass, or what it leaves.
VectorXd filtered(const VectorXd& x, double corner_hz, double rate, bool high) {
  const double keep = std::exp(-2.0 * std::numbers::pi * corner_hz / rate);
  VectorXd low(x.size());
  double state = x(0);
  for (Index i = 0; i < x.size(); ++i) {
    state = keep * state + (1.0 - keep) * x(i);
    low(i) = state;
  }
  return high ? VectorXd(x - low) : low;
}

// Weighted mean of neighbours, as long as a blow with a softer tip.
VectorXd softened(const VectorXd& x, Index width) {
  VectorXd y = VectorXd::Zero(x.size());
  for (Index i = width; i + width < x.size(); ++i) {
    double sum = 0.0;
    for (Index j = -width; j <= width; ++j) {
      const double c =
          std::cos(0.5 * std::numbers::pi * static_cast<double>(j) /
                   static_cast<double>(width + 1));
      y(i) += c * c * x(i + j);
      sum += c * c;
    }
    y(i) /= sum;
  }
  return y;
}

std::vector<UnlistedMistake> of_runs() {
  return {
      {{"two runs' files exchanged",
        {"another point|driving point|one point|another one|file"},
        [](Sheet& t, const Plain&, double) {
          std::swap(t.recordings[1].samples, t.recordings[6].samples);
        }},
       {1, 6},
       ""},
      {{"sampling rate of one run is another",
        {"sampling rate|sample rate|clock|time base"},
        [](Sheet& t, const Plain&, double size) {
          t.recordings[3].samples = resampled(
              t.recordings[3].samples, 0.0, size < 0.5 ? 1.0 / 1.024 : 0.5);
        }},
       {3},
       ""},
      {{"hammer's range changed in one run",
        {"range|amplifier|gain|sensitivit"},
        [](Sheet& t, const Plain&, double size) {
          t.recordings[1].samples.col(0) *= between(1.1, 10.0, size);
        }},
       {1},
       "hammer"},
      {{"hammer turned over in one run",
        {"polarity|turned|negative"},
        [](Sheet& t, const Plain&, double) {
          t.recordings[3].samples.col(0) *= -1.0;
        }},
       {3},
       "hammer"},
      {{"softer tip in the last runs",
        {"tip|soft|pulse"},
        [](Sheet& t, const Plain& o, double size) {
          const auto width = static_cast<Index>(between(4.0, 30.0, size));
          for (std::size_t r = 5; r < t.recordings.size(); ++r) {
            auto& x = t.recordings[r].samples;
            for (Index c = 0; c < x.cols(); ++c) {
              const double sd = (c == 0 ? 0.01 : 0.02) * o.noise;
              x.col(c) = softened(x.col(c), width) +
                         noise(x.rows(), sd, o.seed + static_cast<unsigned>(r));
            }
          }
        }},
       {5, 6, 7, 8, 9, 10, 11},
       "hammer"},
      {{"machine next door in one run",
        {"hum|machine|excite|ambient|tone|noise"},
        [](Sheet& t, const Plain&, double size) {
          Recording& r = t.recordings[3];
          for (Index c = 1; c < r.samples.cols(); ++c) {
            const double level =
                between(0.05, 2.0, size) * rms(r.samples.col(c));
            r.samples.col(c) +=
                level * (tone(r, 24.3, 1.3 * static_cast<double>(c)) +
                         0.5 * tone(r, 48.6, 0.4 * static_cast<double>(c)));
          }
        }},
       {3},
       ""},
  };
}

std::vector<UnlistedMistake> of_channels() {
  return {
      {{"sensor loose in the last runs",
        {"loose|comes off"},
        [](Sheet& t, const Plain& o, double size) {
          for (std::size_t r = 5; r < t.recordings.size(); ++r) {
            auto x = t.recordings[r].samples.col(2);
            const double level = rms(x);
            x = between(0.9, 0.3, size) * x +
                noise(x.size(),
                      between(0.02, 0.3, size) * level,
                      o.seed + static_cast<unsigned>(r));
          }
        }},
       {5, 6, 7, 8, 9, 10, 11},
       "acc2"},
      {{"hum on one channel",
        {"hum|mains|50 Hz"},
        [](Sheet& t, const Plain&, double size) {
          for (Recording& r : t.recordings) {
            r.samples.col(1) += between(0.05, 2.0, size) *
                                rms(r.samples.col(1)) * tone(r, 50.0, 0.7);
          }
        }},
       {},
       "acc1"},
      {{"sensor on its side",
        {"direction|axis|on its side"},
        [](Sheet& t, const Plain& o, double size) {
          for (std::size_t r = 0; r < t.recordings.size(); ++r) {
            auto x = t.recordings[r].samples.col(1);
            x = between(0.1, 0.02, size) * x +
                noise(x.size(),
                      0.02 * o.noise,
                      o.seed + static_cast<unsigned>(r));
          }
        }},
       {},
       "acc1"},
      {{"low-pass on one channel",
        {"filter"},
        [](Sheet& t, const Plain&, double size) {
          for (Recording& r : t.recordings) {
            r.samples.col(1) = filtered(r.samples.col(1),
                                        between(400.0, 40.0, size),
                                        r.sample_rate_hz,
                                        false);
          }
        }},
       {},
       "acc1"},
      {{"AC coupling on one channel",
        {"filter|coupl|high-pass"},
        [](Sheet& t, const Plain&, double size) {
          for (Recording& r : t.recordings) {
            r.samples.col(1) = filtered(r.samples.col(1),
                                        between(0.5, 10.0, size),
                                        r.sample_rate_hz,
                                        true);
          }
        }},
       {},
       "acc1"},
      {{"zero of a channel jumps in one run",
        {"jump|zero|offset"},
        [](Sheet& t, const Plain&, double size) {
          auto x = t.recordings[3].samples.col(1);
          x.tail(x.size() / 2).array() += between(0.5, 20.0, size) * rms(x);
        }},
       {3},
       "acc1"},
      {{"channel late in one run",
        {"behind|lags|late"},
        [](Sheet& t, const Plain&, double size) {
          auto x = t.recordings[3].samples.col(1);
          const auto late = static_cast<Index>(between(1.0, 20.0, size));
          x.tail(x.size() - late) = x.head(x.size() - late).eval();
        }},
       {3},
       "acc1"},
      {{"sensor saturates softly",
        {"saturat|overload|linear|clipped"},
        [](Sheet& t, const Plain&, double size) {
          for (Recording& r : t.recordings) {
            auto x = r.samples.col(1);
            const double limit =
                between(0.7, 0.15, size) * x.cwiseAbs().maxCoeff();
            x = limit * (x / limit).array().tanh();
          }
        }},
       {},
       "acc1"},
      {{"channel recorded twice",
        {"same samples|same signal|copy|identical"},
        [](Sheet& t, const Plain&, double) {
          for (Recording& r : t.recordings) {
            r.samples.col(2) = r.samples.col(1).eval();
          }
        }},
       {},
       "acc2"},
      {{"range changed within a run",
        {"range|gain|amplifier"},
        [](Sheet& t, const Plain&, double size) {
          auto x = t.recordings[3].samples.col(1);
          x.tail(x.size() / 2) *= between(1.1, 10.0, size);
        }},
       {3},
       "acc1"},
      {{"velocity in one run",
        {"velocity|integrated"},
        [](Sheet& t, const Plain&, double) {
          Recording& r = t.recordings[3];
          r.samples.col(1) =
              filtered(r.samples.col(1), 0.5, r.sample_rate_hz, false);
        }},
       {3},
       "acc1"},
  };
}

}  // namespace

const std::vector<UnlistedMistake>& unlisted_mistakes() {
  static const std::vector<UnlistedMistake> all = [] {
    std::vector<UnlistedMistake> joined = of_runs();
    for (const UnlistedMistake& one : of_channels()) joined.push_back(one);
    return joined;
  }();
  return all;
}

bool is_pointed_at(const UnlistedMistake& mistake,
                   const std::vector<Finding>& findings) {
  return std::ranges::any_of(findings, [&](const Finding& f) {
    if (f.severity == Severity::Note) return false;
    const bool no_other_run =
        mistake.runs.empty() ||
        std::ranges::all_of(f.where.runs, [&](std::size_t run) {
          return std::ranges::count(mistake.runs, run) > 0;
        });
    if (!no_other_run) return false;
    const bool of_runs = !mistake.runs.empty() && !f.where.runs.empty();
    const bool of_channel =
        !mistake.channel.empty() && f.where.channel == mistake.channel;
    return of_runs || of_channel;
  });
}

}  // namespace tapfit::updating::testing
