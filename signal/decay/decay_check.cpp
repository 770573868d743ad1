#include "signal/decay/decay_check.hpp"

#include "acquisition/hits/choose_block.hpp"
#include "acquisition/samples/octave_decay.hpp"
#include "acquisition/samples/statistics.hpp"
#include "signal/decay/segment_decay.hpp"
#include "signal/spectra/fft.hpp"
#include "signal/spectra/offset.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace tapfit::signal {
namespace {

using Eigen::Index;

constexpr double above_noise = 30;  // 15 dB over the median of the lines
constexpr double worth = 1e-4;      // of the strongest that is left
constexpr Index fewest_lines = 8;
// What decays less than this within the block may be no response at all.
constexpr double hardly = 0.2;
constexpr Index beside = 8;  // lines
constexpr Index around = 12;

// Power summed over each line and its two neighbours, which count half.
Eigen::VectorXd power_near(const Eigen::VectorXcd& lines) {
  const Eigen::VectorXd power = lines.cwiseAbs2();
  Eigen::VectorXd result = 2.0 * power;
  const Index n = power.size();
  result.head(n - 1) += power.tail(n - 1);
  result.tail(n - 1) += power.head(n - 1);
  return result;
}

/// Halves of one response, as power per line.
struct Halves {
  Eigen::VectorXd early;
  Eigen::VectorXd late;
};

// Whether a line is the highest among its neighbours, two on either side.
bool is_peak(const Eigen::VectorXd& power, Index i) {
  const Index first = std::max<Index>(0, i - 2);
  const Index count = std::min(power.size(), i + 3) - first;
  return power(i) >= power.segment(first, count).maxCoeff();
}

/// One line that stands out of the noise behind the blow.
struct Line {
  double hz = 0.0;
  double time_constants = 0.0;  ///< by the halves
  double over_noise = 0.0;      ///< late power over the median's
  bool counts = true;           ///< where it is excited anew
  SegmentDecay course;
};

/// The lines of one response, where they are and what can be told of each.
struct Lines {
  Halves halves;
  Segments segments;
  double first_hz = 0.0;
  double step_hz = 0.0;
  double half_s = 0.0;
  double window_power = 0.0;  ///< of a half's window
};

// Whether the halves tell what there is: a decay, or a level that stays.
bool is_told(const Line& line) {
  return line.course.decays || line.course.steady;
}

// What rings on through six time constants or less, and hum, are as sharp as
// half a block resolves: half the width at half power of a decay is a / 2 pi,
// half a line at the most. A peak of the skirt of something wider that is
// excited anew does not stand out of the lines around it.
bool is_sharp(const Eigen::VectorXd& power, Index i) {
  const Index first = std::max<Index>(0, i - around);
  const Index count = std::min(power.size(), i + around + 1) - first;
  return power(i) >
         above_noise * acquisition::median(power.segment(first, count));
}

// Peaks of the late half that stand out of the noise.
std::vector<Line> standing_out(const Lines& lines) {
  const Eigen::VectorXd& early = lines.halves.early;
  const Eigen::VectorXd& late = lines.halves.late;
  const double median = acquisition::median(late);
  const double least = std::max(above_noise * median, worth * late.maxCoeff());
  // Each line is counted with its neighbours, 1 + 2 + 1.
  const double noise = 0.25 * median / lines.window_power;
  std::vector<Line> result;
  for (Index i = 0; i < late.size(); ++i) {
    if (!(late(i) > least) || !is_peak(late, i)) continue;
    Line line;
    line.hz = lines.first_hz + static_cast<double>(i) * lines.step_hz;
    line.time_constants = std::max(0.0, std::log(early(i) / late(i)));
    line.over_noise = late(i) / median;
    const Index from = std::max<Index>(0, i - beside);
    const Index to = std::min(late.size() - 1, i + beside);
    // A skirt rises and falls with what it belongs to.
    line.counts =
        late(i) > 0.01 * late.maxCoeff() &&
        early.segment(from, to - from + 1).maxCoeff() < 10.0 * early(i);
    line.course = lines.segments.course(line.hz, noise);
    // By chance a skirt looks like decays, or as if it stayed.
    if (!is_told(line) || is_sharp(late, i)) result.push_back(line);
  }
  return result;
}

// Whether more is heard in the late half than the fall from the blow leaves.
bool is_excited(const Line& line, double half_s) {
  if (is_told(line)) return false;
  if (!line.course.fall) return true;
  constexpr double clearly = 1.4;  // ln of the power's ratio, 6 dB
  const double left = 2.0 * line.course.fall->rate * half_s;
  return left - line.time_constants > clearly;
}

// What is heard all the time; lines beside it are of both, and say nothing.
bool is_hum(const Line& line) {
  return line.time_constants < hardly && is_told(line);
}

// Time constants in the block, as far as they can be known: fewer than enough
// only where they surely are.
std::optional<double> time_constants_of(const Line& line, double half_s) {
  if (is_told(line)) return line.time_constants;
  if (!line.course.fall) return std::nullopt;
  if (2.0 * line.course.fall->most * half_s >
      acquisition::decayed_time_constants) {
    return std::nullopt;
  }
  return 2.0 * line.course.fall->rate * half_s;
}

// What one line adds.
DecayCheck lasting_of(const Line& line, double half_s) {
  DecayCheck found;
  if (!is_told(line) && !line.counts) return found;
  if (is_excited(line, half_s)) {
    found.excited = {line.hz,
                     line.course.fall ? line.course.fall->end_s : 0.0,
                     line.over_noise};
  }
  const std::optional<double> known = time_constants_of(line, half_s);
  if (!known || *known >= acquisition::decayed_time_constants) return found;
  found.time_constants = *known;
  found.rate = 0.5 * *known / half_s;
  found.hz = found.low_hz = found.high_hz = line.hz;
  return found;
}

DecayCheck lasting_lines(const Lines& lines) {
  const std::vector<Line> out = standing_out(lines);
  DecayCheck found;
  std::vector<double> hum;
  for (const Line& line : out) {
    if (is_hum(line)) hum.push_back(line.hz);
  }
  if (!hum.empty()) found.hum_hz = hum.front();
  const double spoilt_hz = (static_cast<double>(beside) + 0.5) * lines.step_hz;
  for (const Line& line : out) {
    const bool spoilt = std::ranges::any_of(
        hum, [&](double hz) { return std::abs(hz - line.hz) < spoilt_hz; });
    if (!spoilt) found.join(lasting_of(line, lines.half_s));
  }
  return found;
}

}  // namespace

void DecayCheck::join(const DecayCheck& other) {
  if (other.time_constants < time_constants) {
    time_constants = other.time_constants;
    rate = other.rate;
    hz = other.hz;
  }
  if (hum_hz == 0.0) hum_hz = other.hum_hz;
  if (other.excited.over_noise > excited.over_noise) excited = other.excited;
  low_hz = std::min(low_hz, other.low_hz);
  high_hz = std::max(high_hz, other.high_hz);
}

DecayCheck check_decay(const HitBlocks& blocks,
                       const std::array<double, 2>& band_hz) {
  DecayCheck found;
  if (blocks.force.cols() == 0) return found;
  Index strongest = 0;
  blocks.force.colwise().squaredNorm().maxCoeff(&strongest);
  const Index half =
      acquisition::smooth_length((blocks.force.rows() - blocks.trigger) / 2);
  const double step_hz = 1.0 / (static_cast<double>(half) * blocks.dt);
  const auto first = std::max<Index>(
      2, static_cast<Index>(std::ceil(band_hz[0] / step_hz - 1e-9)));
  const auto last = std::min<Index>(
      half / 2, static_cast<Index>(std::floor(band_hz[1] / step_hz + 1e-9)));
  if (last - first + 1 < fewest_lines) return found;
  RealFft fft(half);
  const Eigen::VectorXd window = hann(half);
  const auto power = [&](const Eigen::MatrixXd& response, Index row) {
    Eigen::VectorXcd lines(last - first + 1);
    fft.transform(
        response.col(strongest).segment(row, half), window, first, lines);
    return power_near(lines);
  };
  for (const Eigen::MatrixXd& response : blocks.responses) {
    const Halves halves{power(response, blocks.trigger),
                        power(response, blocks.trigger + half)};
    found.join(lasting_lines(
        {halves,
         Segments(response.col(strongest).segment(blocks.trigger, 2 * half),
                  blocks.dt),
         static_cast<double>(first) * step_hz,
         step_hz,
         static_cast<double>(half) * blocks.dt,
         window.squaredNorm()}));
  }
  return found;
}

}  // namespace tapfit::signal
