#include "tui/number.hpp"
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

/// Between the band cursor's ends: its width, the rms of |H|, the peak, and
/// the coherence.
std::string band_text(const FrfSet& frfs,
                      const Frf& frf,
                      double from,
                      double to) {
  const Eigen::VectorXd f = frfs.frequency_hz();
  double power = 0.0;
  double coherence = 0.0;
  Index peak = -1;
  Index count = 0;
  for (Index i = 0; i < f.size(); ++i) {
    if (f[i] < from || f[i] > to) continue;
    power += std::norm(frf.H[i]);
    if (frf.coherence.size() == f.size()) coherence += frf.coherence[i];
    if (peak < 0 || std::abs(frf.H[i]) > std::abs(frf.H[peak])) peak = i;
    ++count;
  }
  if (count == 0) return "no line in the band";
  const auto n = static_cast<double>(count);
  return fmt::format(
      "{} to {} Hz (Δ {} Hz): rms {} {}, largest at {} Hz, coherence {}",
      fixed(from, 2),
      fixed(to, 2),
      fixed(to - from, 2),
      number(std::sqrt(power / n)),
      accelerance_unit,
      fixed(f[peak], 2),
      fixed(coherence / n, 4));
}

std::string all_sizes(const FrfChoice& choice, Index line, double hz) {
  std::string text = fixed(hz, 3) + " Hz  |H|";
  for (const std::size_t i : choice.shown) {
    const Frf& frf = choice.frfs.frfs[i];
    text += fmt::format(
        "  {} {}", signal::name(frf), number(std::abs(frf.H[line])));
  }
  return text + "  " + accelerance_unit;
}

std::string one_line(const FrfSet& frfs,
                     const Frf& frf,
                     Index at,
                     bool as_parts) {
  const double hz = frfs.frequency_hz()[at];
  const double phase = std::arg(frf.H[at]) * 180.0 / std::numbers::pi;
  std::string text = as_parts ? fmt::format("{} Hz   Re {}   Im {} {}",
                                            fixed(hz, 3),
                                            number(frf.H[at].real()),
                                            number(frf.H[at].imag()),
                                            accelerance_unit)
                              : fmt::format("{} Hz   |H| {} {}   ∠ {}°",
                                            fixed(hz, 3),
                                            number(std::abs(frf.H[at])),
                                            accelerance_unit,
                                            fixed(phase, 1));
  if (frf.coherence.size() == frfs.lines()) {
    text += fmt::format("   coherence {}", fixed(frf.coherence[at], 4));
  }
  if (frf.variance.size() == frfs.lines()) {
    text += fmt::format("   sd {}",
                        number(std::sqrt(std::max(frf.variance[at], 0.0)), 2));
  }
  return text;
}

}  // namespace

std::string frf_read_out(const FrfChoice& choice, const FrfState& state) {
  const FrfSet& frfs = choice.frfs;
  const Frf& frf = frfs.frfs[choice.shown.front()];
  const Eigen::VectorXd f = frfs.frequency_hz();
  if (f.size() == 0 || frf.H.size() != f.size()) return "no lines";
  const PlotRange& range = state.range;
  if (!range.cursor_set) {
    return fmt::format("{} lines, {} to {} Hz, exponential window sigma {} 1/s",
                       f.size(),
                       number(f[0]),
                       number(f[f.size() - 1]),
                       number(frfs.s[0].real(), 3));
  }
  if (state.mark) {
    return band_text(frfs,
                     frf,
                     std::min(*state.mark, range.cursor),
                     std::max(*state.mark, range.cursor));
  }
  Index at = 0;
  (f.array() - range.cursor).abs().minCoeff(&at);
  if (choice.shown.size() > 1) return all_sizes(choice, at, f[at]);
  const bool as_parts = state.panel == FrfState::Panel::Parts ||
                        state.panel == FrfState::Panel::Nyquist;
  return one_line(frfs, frf, at, as_parts);
}

}  // namespace tapfit::tui
