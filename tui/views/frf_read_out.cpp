#include "signal/frf_set/measured_coherence.hpp"
#include "tui/screen/line_text.hpp"
#include "tui/screen/number.hpp"
#include "tui/views/frf_curves.hpp"
#include "tui/views/frf_panels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tapfit::tui {
namespace {

using Eigen::Index;
using signal::Frf;
using signal::FrfSet;

/// "3.21 (m/s²)/N", or "10.1 dB".
std::string magnitude_words(double magnitude,
                            const FrfChoice& choice,
                            MagnitudeScale scale) {
  return scale == MagnitudeScale::Decibels
             ? fixed(decibels(magnitude), 1) + " dB"
             : fmt::format("{} {}", number(magnitude), unit_of(choice.form));
}

/// Between the band cursor's ends: its width, the rms of |H|, the peak, and
/// the coherence.
std::string band_text(const FrfChoice& choice,
                      MagnitudeScale scale,
                      double from,
                      double to,
                      int width) {
  const Frf& frf = choice.selected();
  const Eigen::VectorXd f = choice.frfs.frequency_hz();
  const bool known = signal::has_coherence(frf);
  double power = 0.0;
  double coherence = 0.0;
  Index peak = -1;
  Index count = 0;
  for (Index i = 0; i < f.size(); ++i) {
    if (f[i] < from || f[i] > to) continue;
    power += std::norm(frf.H[i]);
    if (known) coherence += frf.coherence[i];
    if (peak < 0 || std::abs(frf.H[i]) > std::abs(frf.H[peak])) peak = i;
    ++count;
  }
  if (count == 0) return "no line in the band";
  const auto n = static_cast<double>(count);
  const std::string band =
      fmt::format("{} to {} Hz", fixed(from, 2), fixed(to, 2));
  const std::string width_hz = fixed(to - from, 2);
  const std::string rms =
      "rms " + magnitude_words(std::sqrt(power / n), choice, scale);
  const std::string peak_hz = fixed(f[peak], 2) + " Hz";
  const auto mean = [&](const char* word) {
    return known ? fmt::format(", {} {}", word, fixed(coherence / n, 4)) : "";
  };
  return fitting(
      {fmt::format("{} (Δ {} Hz): {}, largest at {}{}",
                   band,
                   width_hz,
                   rms,
                   peak_hz,
                   mean("coherence")),
       fmt::format("{} (Δ {}): {}, peak {}{}",
                   band,
                   width_hz,
                   rms,
                   peak_hz,
                   mean("coh")),
       fmt::format("{}: {}, peak {}{}", band, rms, peak_hz, mean("coh"))},
      width);
}

std::string all_sizes(const FrfChoice& choice,
                      MagnitudeScale scale,
                      Index line,
                      double hz,
                      int width) {
  const bool in_decibels = scale == MagnitudeScale::Decibels;
  std::vector<std::string> sizes;
  for (const Frf& frf : choice.frfs.frfs) {
    const double size = std::abs(frf.H[line]);
    sizes.push_back(
        fmt::format("{} {}",
                    signal::name(frf),
                    in_decibels ? fixed(decibels(size), 1) : number(size)));
  }
  return listed(fmt::format("{} Hz  |H| in {}  ",
                            fixed(hz, 3),
                            in_decibels ? "dB" : unit_of(choice.form)),
                sizes,
                "  ",
                width);
}

std::string one_line(const FrfChoice& choice,
                     MagnitudeScale scale,
                     Index at,
                     bool as_parts,
                     int width) {
  const FrfSet& frfs = choice.frfs;
  const Frf& frf = choice.selected();
  const double hz = frfs.frequency_hz()[at];
  const double phase = std::arg(frf.H[at]) * 180.0 / std::numbers::pi;
  const auto said = [&](const char* gap, const char* coherence) {
    const std::string value =
        as_parts
            ? fmt::format("Re {}{}Im {} {}",
                          number(frf.H[at].real()),
                          gap,
                          number(frf.H[at].imag()),
                          unit_of(choice.form))
            : fmt::format("|H| {}{}∠ {}°",
                          magnitude_words(std::abs(frf.H[at]), choice, scale),
                          gap,
                          fixed(phase, 1));
    std::string text = fmt::format("{} Hz{}{}", fixed(hz, 3), gap, value);
    if (signal::has_coherence(frf)) {
      text +=
          fmt::format("{}{} {}", gap, coherence, fixed(frf.coherence[at], 4));
    }
    const double sd = frf.variance.size() == frfs.lines()
                          ? std::sqrt(std::max(frf.variance[at], 0.0))
                          : 0.0;
    if (sd > 0.0) {
      const double size = std::abs(frf.H[at]);
      const bool in_decibels = scale == MagnitudeScale::Decibels && !as_parts;
      text += in_decibels
                  ? fmt::format(
                        "{}sd {} dB", gap, number(decibels(1.0 + sd / size), 2))
                  : fmt::format("{}sd {}", gap, number(sd, 2));
    }
    return text;
  };
  return fitting({said("   ", "coherence"), said("  ", "coh")}, width);
}

}  // namespace

std::string frf_read_out(const FrfChoice& choice,
                         const FrfState& state,
                         int width) {
  const FrfSet& frfs = choice.frfs;
  const Frf& frf = choice.selected();
  const Eigen::VectorXd f = frfs.frequency_hz();
  if (f.size() == 0 || frf.H.size() != f.size()) return "no lines";
  const PlotRange& range = state.range;
  if (!range.cursor_set) {
    const double sigma = frfs.s[0].real();
    return fmt::format(
        "{} lines, {} to {} Hz{}",
        f.size(),
        number(f[0]),
        number(f[f.size() - 1]),
        sigma > 0.0
            ? fmt::format(", exponential window sigma {} 1/s", number(sigma, 3))
            : "");
  }
  if (state.mark) {
    return band_text(choice,
                     state.scale,
                     std::min(*state.mark, range.cursor),
                     std::max(*state.mark, range.cursor),
                     width);
  }
  Index at = 0;
  (f.array() - range.cursor).abs().minCoeff(&at);
  if (frfs.frfs.size() > 1) {
    return all_sizes(choice, state.scale, at, f[at], width);
  }
  const bool as_parts = state.panel == FrfState::Panel::Parts ||
                        state.panel == FrfState::Panel::Nyquist;
  return one_line(choice, state.scale, at, as_parts, width);
}

}  // namespace tapfit::tui
