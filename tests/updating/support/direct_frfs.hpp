// FRFs by their definition, every line solved whole, and the checks of a
// model's FRFs against them and against differences.
#pragma once

#include "signal/frf_set/frf_set.hpp"
#include "updating/fit/fitter.hpp"
#include "updating/frf_model/frf_model.hpp"
#include "updating/structure/deck/deck.hpp"

#include <Eigen/Core>

#include <complex>
#include <tuple>
#include <vector>

namespace tapfit::updating {

/// What is put at a grid, acting across the plate: its number, the power of s,
/// the size. A mass, of power 2, moves in all directions.
using PointTerm = std::tuple<int, int, std::complex<double>>;

/// Z(s) = K + s^2 M + B D B', accelerances of the pairs, n_lines x pairs.
/// @param also_free degrees of freedom that the deck holds, released and held
///   by springs of k_free per metre of an edge of 5 grids
[[nodiscard]] Eigen::MatrixXcd direct_frfs(
    const structure::Deck& deck,
    const signal::FrfSet& pairs,
    const std::vector<PointTerm>& terms,
    const Eigen::VectorXcd& s,
    const std::vector<int>& also_free = {},
    double k_free = 0.0);

/// The state at which a fit starts, with next to no damping.
[[nodiscard]] ModelState undamped_state(
    const Fitter& fitter,
    const FrfModel& model,
    const std::vector<EffectInstance>& effects);

/// Largest relative difference between analytic derivatives and central
/// differences.
[[nodiscard]] double derivative_error(const FrfModel& model,
                                      const ModelState& state,
                                      const Eigen::VectorXcd& s);

}  // namespace tapfit::updating
