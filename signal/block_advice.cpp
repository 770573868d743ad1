#include "signal/block_advice.hpp"

#include "acquisition/choose_block.hpp"
#include "acquisition/remove_offset.hpp"
#include "signal/fft.hpp"
#include "signal/offset.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tapfit::signal {
namespace {

using acquisition::Hit;
using acquisition::HitSet;
using Eigen::Index;

constexpr double enough = 6.0;      // time constants
constexpr double above_noise = 30;  // 15 dB over the median of the lines
constexpr double worth = 1e-4;      // of the strongest that is left
constexpr Index fewest_lines = 8;
// What decays less than this within the block may be no response at all.
constexpr double hardly = 0.2;
constexpr Index beside = 8;  // lines

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

Lasting lasting_lines(const Halves& halves,
                      double first_hz,
                      double step_hz,
                      double half_s) {
  const double noise = above_noise * acquisition::median(halves.late);
  const double least = std::max(noise, worth * halves.late.maxCoeff());
  const auto time_constants = [&](Index i) {
    return std::max(0.0, std::log(halves.early(i) / halves.late(i)));
  };
  Lasting found;
  // Lines next to hum are of both, and say nothing.
  std::vector<bool> spoilt(static_cast<std::size_t>(halves.late.size()));
  const auto last = static_cast<Index>(spoilt.size()) - 1;
  for (Index i = 0; i <= last; ++i) {
    if (!(halves.late(i) > least) || time_constants(i) >= hardly) continue;
    if (found.hum_hz == 0.0) {
      found.hum_hz = first_hz + static_cast<double>(i) * step_hz;
    }
    for (Index k = std::max<Index>(0, i - beside);
         k <= std::min(last, i + beside);
         ++k) {
      spoilt[static_cast<std::size_t>(k)] = true;
    }
  }
  for (Index i = 0; i <= last; ++i) {
    if (!(halves.late(i) > least) || spoilt[static_cast<std::size_t>(i)] ||
        time_constants(i) >= enough || !is_peak(halves.late, i)) {
      continue;
    }
    const double hz = first_hz + static_cast<double>(i) * step_hz;
    found.join(
        {time_constants(i), 0.5 * time_constants(i) / half_s, hz, hz, hz});
  }
  return found;
}

// Whether and how a band leaves [low, high] out and keeps half its width. A
// factor of 1.5 is far enough from a resonance for what the end of the block
// makes of it.
std::optional<std::array<double, 2>> narrower(
    const Lasting& lasting, const std::array<double, 2>& band) {
  const double half = 0.5 * (band[1] - band[0]);
  const double from = 1.5 * lasting.high_hz;
  const double to = lasting.low_hz / 1.5;
  if (band[1] - from >= half) return std::array{from, band[1]};
  if (to - band[0] >= half) return std::array{band[0], to};
  return std::nullopt;
}

std::string proposal(const BlockAdvice& advice) {
  std::string text;
  if (advice.every_run) {
    text = fmt::format("a block of {:.3g} s (block_s; {} of {} hits have room)",
                       advice.block_s,
                       advice.with_room,
                       advice.accepted);
  } else {
    text = fmt::format(
        "a block of {:.3g} s, for which this recording has no room (at most "
        "{:.3g} s): wait longer between blows",
        advice.block_s,
        advice.room_s);
  }
  if (!advice.band_hz) return text;
  return text + fmt::format(", or a band of {:.3g} to {:.3g} Hz",
                            (*advice.band_hz)[0],
                            (*advice.band_hz)[1]);
}

}  // namespace

void Lasting::join(const Lasting& other) {
  if (other.time_constants < time_constants) {
    time_constants = other.time_constants;
    rate = other.rate;
    hz = other.hz;
  }
  if (hum_hz == 0.0) hum_hz = other.hum_hz;
  low_hz = std::min(low_hz, other.low_hz);
  high_hz = std::max(high_hz, other.high_hz);
}

Lasting lasting_response(const HitBlocks& blocks,
                         const std::array<double, 2>& band_hz) {
  Lasting found;
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
    found.join(lasting_lines(halves,
                             static_cast<double>(first) * step_hz,
                             step_hz,
                             static_cast<double>(half) * blocks.dt));
  }
  return found;
}

std::optional<BlockAdvice> advise_block(const Lasting& lasting,
                                        const HitSet& hits,
                                        const std::vector<Index>& samples,
                                        const std::array<double, 2>& band_hz) {
  if (!lasting.any()) return std::nullopt;
  const double rate = hits.sample_rate_hz;
  const double pre_s = static_cast<double>(hits.pre_trigger) / rate;
  BlockAdvice advice;
  advice.lasting = lasting;
  advice.block_s = pre_s + enough / lasting.rate;
  advice.band_hz = narrower(lasting, band_hz);
  advice.every_run = true;
  for (std::size_t r = 0; r < hits.runs.size(); ++r) {
    const std::vector<Hit>& run = hits.runs[r];
    int accepted = 0;
    int with_room = 0;
    for (std::size_t k = 0; k < run.size(); ++k) {
      if (!run[k].accepted) continue;
      const Index end = k + 1 < run.size() ? run[k + 1].trigger : samples.at(r);
      const double room_s =
          pre_s + static_cast<double>(end - run[k].trigger) / rate;
      ++accepted;
      with_room += room_s >= advice.block_s ? 1 : 0;
      advice.room_s = std::max(advice.room_s, room_s);
    }
    advice.accepted += accepted;
    advice.with_room += with_room;
    advice.every_run = advice.every_run && (accepted == 0 || with_room > 0);
  }
  return advice;
}

std::string statement(const BlockAdvice& advice, double sigma) {
  const Lasting& lasting = advice.lasting;
  std::string text = fmt::format(
      "the response at {:.4g} Hz has {:.2g} time constants in the block where "
      "6 let it decay. Before any window, take {}",
      lasting.hz,
      lasting.time_constants,
      proposal(advice));
  if (!(sigma > 0.0)) return text;
  return text +
         fmt::format(
             ". With this block the exponential window widens resonances by "
             "{:.2g} Hz and adds {:.2g} % to the damping ratio there; that is "
             "taken off again, but close modes may not come apart",
             sigma / std::numbers::pi,
             100.0 * sigma / (2.0 * std::numbers::pi * lasting.hz));
}

std::string hum_statement(const Lasting& lasting) {
  if (lasting.hum_hz == 0.0) return {};
  return fmt::format(
      "what is heard at {:.4g} Hz does not decay within the block: hum, or a "
      "mode with next to no damping; look at the sensors before the first blow",
      lasting.hum_hz);
}

std::vector<std::string> lasting_statements(
    const Lasting& lasting,
    const HitSet& hits,
    const std::vector<Index>& samples,
    const std::array<double, 2>& band_hz,
    double sigma) {
  std::vector<std::string> said;
  if (const auto advice = advise_block(lasting, hits, samples, band_hz)) {
    said.push_back(statement(*advice, sigma));
  }
  const std::string hum = hum_statement(lasting);
  if (!hum.empty()) said.push_back(hum);
  return said;
}

}  // namespace tapfit::signal
