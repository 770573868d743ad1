// Poles taken out and put in by hand, after the automatic selection.
#pragma once

#include "modal/fit/modal_fit.hpp"
#include "modal/poles/pole_edit.hpp"
#include "modal/poles/stabilisation.hpp"

#include <vector>

namespace tapfit::modal {

/// The mode to take out: the nearest of `omega`.
/// @param omega of the modes [rad/s], not empty of those that are there
/// @throws InputError when none lies within 2 % of `hz`
[[nodiscard]] Eigen::Index mode_to_drop(const Eigen::ArrayXd& omega, double hz);

/// Takes a pole out and refines the others.
/// @param fit changed in place; the order of what stays too
void drop_pole(const WeightedFrfs& curves, Eigen::Index pole, ModalFit& fit);

/// Puts in, as the last, the steadiest pole of the diagram near a frequency
/// that is no mode yet (where the diagram has none, a pole started there), and
/// refines all. It passes no hard check but that it is damped.
/// @param fit changed in place
/// @throws InputError when the pole runs away by more than 2 %, loses its
///   damping or cannot be told from one that is there
void add_pole(const WeightedFrfs& curves,
              const std::vector<Track>& tracks,
              double hz,
              ModalFit& fit);

/// Carries out edits in their order.
/// @param fit changed in place
/// @throws InputError of mode_to_drop() and add_pole()
void edit_poles(const WeightedFrfs& curves,
                const std::vector<Track>& tracks,
                const std::vector<PoleEdit>& edits,
                ModalFit& fit);

}  // namespace tapfit::modal
