// How many independent data there are: in what was measured, and in what a
// model leaves of it. One number weighs the prior while a fit is on its way,
// and models against each other afterwards.
#pragma once

#include "updating/residual/residual.hpp"

#include <Eigen/Core>

namespace tapfit::updating {

/// Independent real data in the target: lines on a damped line overlap.
[[nodiscard]] double effective_data(const Target& target);

/// Independent data in what a fit leaves. What mesh and model form leave is no
/// noise, but a few patterns over lines and FRFs that belong together: with
/// the singular values s_k of the residual (lines x FRFs),
/// P = (sum s^2)^2 / sum s^4 of them count, and the residual is worth 2 P^2
/// data, after the 1 / lines + 1 / FRFs that noise alone adds to 1 / P. At
/// most effective_data().
[[nodiscard]] double residual_data(const Target& target,
                                   const Eigen::VectorXd& residual);

/// The most that can be independent in a band with as many modes: FRFs of a
/// structure with m modes are fixed by m residues each and the m frequencies
/// that they share (damping is fitted along in every model), so that more lines
/// do not make more data, whatever their number. At most effective_data(),
/// which alone bounds where the modes in the band are not known.
[[nodiscard]] double most_data(const Target& target);

/// Independent real data for choosing between models, and between a model's
/// parameters: residual_data(), at most most_data() and at least a frequency, a
/// damping and a residue of each mode.
/// @param residual as from stack()
[[nodiscard]] double independent_data(const Target& target,
                                      const Eigen::VectorXd& residual);

}  // namespace tapfit::updating
