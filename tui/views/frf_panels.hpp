// The plots of the FRF screen: magnitude with phase or coherence, real and
// imaginary part, and the Nyquist plane with the circle of a peak.
#pragma once

#include "signal/frf_set/frf_set.hpp"
#include "tui/screen/screen.hpp"
#include "tui/views/frf_state.hpp"

#include <string>
#include <vector>

namespace tapfit::tui {

/// What is drawn: the selected FRF first, all as accelerance, mobility or
/// receptance.
struct FrfChoice {
  signal::FrfSet frfs;
  signal::FrfForm form = signal::FrfForm::Accelerance;

  [[nodiscard]] const signal::Frf& selected() const {
    return frfs.frfs.front();
  }
};

/// Without the line at s = 0 where that is another form than was measured.
/// @param shown places of some in the set, the selected one first
[[nodiscard]] FrfChoice chosen_frfs(const signal::FrfSet& frfs,
                                    const std::vector<std::size_t>& shown,
                                    signal::FrfForm form);

void draw_panel(Screen& screen,
                const Rect& rect,
                const FrfChoice& choice,
                const FrfState& state);

/// Peak of the selected FRF that is nearest to the cursor; without a cursor
/// the largest on show; -1 without any.
[[nodiscard]] Eigen::Index chosen_peak(const signal::FrfSet& frfs,
                                       const signal::Frf& frf,
                                       const PlotRange& range);

/// What lies under the cursor, with units; or under the band cursor.
/// @param width [cells] for which words are shortened, not numbers
[[nodiscard]] std::string frf_read_out(const FrfChoice& choice,
                                       const FrfState& state,
                                       int width);

}  // namespace tapfit::tui
