// The room modal/select. Which poles are modes: candidates that last over the
// orders are dropped, added, merged and split until the FRFs need all of them.
// In:  Weighted FRFs and the tracks of the diagram.
// Out: Selection: the fit of the modes that stay, and what was left out and
//      why.
// May include: its row in CONTRIBUTING.md.
//
// From tracks to modes: every track that lasts is a candidate; the fit of the
// modal model then decides which candidates the FRFs need.
#pragma once

#include "modal/fit/modal_fit.hpp"
#include "modal/poles/stabilisation.hpp"

#include <complex>
#include <vector>

namespace tapfit::modal {

struct Selection {
  /// The modes that stay, by frequency; poles a little outside the band may be
  /// among them. No poles when nothing is found.
  ModalFit fit;
  /// Poles that lasted over the orders but whose damping cannot be told from
  /// none, as a hum's cannot [rad/s].
  std::vector<std::complex<double>> unresolved;
  /// Poles whose points do not move in phase as the options ask [rad/s].
  std::vector<std::complex<double>> out_of_phase;
  /// Those that are not quite the same in all FRFs of one reference.
  std::vector<std::complex<double>> shifting;
};

/// Poles of the tracks that return over most of the orders, each once, by
/// frequency [rad/s].
[[nodiscard]] Eigen::VectorXcd lasting_poles(const WeightedFrfs& curves,
                                             const std::vector<Track>& tracks,
                                             std::size_t orders);

/// Fits the lasting poles and takes out, weakest first, those without which the
/// model is as good or which fail a hard check; looks for what they missed.
[[nodiscard]] Selection select_modes(const WeightedFrfs& curves,
                                     const Eigen::VectorXcd& lasting,
                                     const IdentifyOptions& options,
                                     const Progress& progress);

}  // namespace tapfit::modal
