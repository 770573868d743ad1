// What is chosen on the screen of FRFs.
#pragma once

#include "tui/views/frf_curves.hpp"
#include "tui/widgets/plot_range.hpp"
#include "tui/widgets/table.hpp"

#include <cstddef>
#include <optional>
#include <set>

namespace tapfit::tui {

struct FrfState {
  ListState list;
  PlotRange range;  ///< [Hz]
  MagnitudeScale scale = MagnitudeScale::Logarithmic;
  signal::FrfForm form = signal::FrfForm::Accelerance;
  bool log_f = false;  ///< frequency
  bool band = true;    ///< the confidence band
  enum class Panel {
    Phase,      ///< magnitude and phase
    Coherence,  ///< magnitude and coherence
    Parts,      ///< real and imaginary
    Nyquist,    ///< the plane, with the circle of the peak at the cursor
    Magnitude,
  } panel = Panel::Phase;
  std::set<std::size_t> tagged;  ///< drawn along with the selected one
  bool both_ways = false;        ///< and the one measured the other way round
  std::optional<double> mark;    ///< the band cursor's other end [Hz]
  bool checks = false;           ///< driving points and reciprocity instead
  ListState check_list;
};

}  // namespace tapfit::tui
