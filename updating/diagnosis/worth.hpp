// What an effect must do to earn its place on the error ladder, and when there
// is nothing left to explain.
#pragma once

#include "updating/diagnosis/diagnose_options.hpp"
#include "updating/fit/fitter.hpp"
#include "updating/search/screened.hpp"

namespace tapfit::updating {

/// "Very strong" evidence on Kass and Raftery's scale, 150 : 1.
extern const double very_strong;
/// A fit within this factor of the floor leaves nothing to explain.
extern const double at_floor;
/// Beyond this times the floor there is surely more than one rung can explain.
extern const double clear_of_floor;

/// Parts of the runs that are left out in turn.
inline constexpr int held_out_folds = 4;

/// A rung must lower the error on runs that it was not fitted to, to a share of
/// what it was, and do so with very strong evidence.
struct Worth {
  double gain = 0.0;  ///< log evidence over leaving it out
  /// The error on left-out runs must fall below this of what it was.
  double share = worth_it;
  double held_out = 0.0;  ///< before
  double with_it = 0.0;   ///< and after

  [[nodiscard]] bool earned() const;
};

/// Whether there are runs to leave out: of modes alone, or of one run, what is
/// told as an error on others is the fit's own.
[[nodiscard]] bool has_other_runs(const Target& target);

/// Whether an effect of a fit that makes something give way is told from its
/// absence: the 95 % interval of one of its sizes, as wide as noise, mesh and
/// form make it, ends before, or it moves the modes by more than a careful
/// deck's form does. The evidence takes errors of form and mesh as independent
/// from mode to mode; at an inner corner or a clamp they are not. Of other
/// effects, which no deck is wrong by in form, the evidence alone tells.
/// @param k which of the fit's effects
[[nodiscard]] bool is_told(const Fit& fit, std::size_t k);
/// The same by the interval alone: what others in the model may make up for
/// tells nothing then.
[[nodiscard]] bool is_told_by_size(const Fit& fit, std::size_t k);
/// Its last.
[[nodiscard]] inline bool is_told(const Fit& fit) {
  return is_told(fit, fit.effects.size() - 1);
}

/// Whether two effects that make something give way are no more than an element
/// apart: what gives way at one place is one effect, and a deck is wrong in
/// form around it.
[[nodiscard]] bool give_way_together(const EffectInstance& one,
                                     const EffectInstance& other,
                                     const structure::Deck& deck);

/// What is left where nothing is missing.
struct Floor {
  double whole = 0.0;  ///< of noise, mesh and a careful deck's form
  double noise = 0.0;  ///< of noise alone
};

/// @param target that the fit's residual is of
[[nodiscard]] Floor floor_of(const Fit& fit,
                             const Target& target,
                             const DiagnoseOptions& options);

/// As it is told of a fit: with all that the form may have, not the usual
/// alone.
[[nodiscard]] double told_floor(const Fit& fit,
                                const Target& target,
                                const DiagnoseOptions& options);

/// @param error of a fit, as everywhere below
[[nodiscard]] bool is_at_floor(double error, const Floor& floor);

/// At the floor only for what mesh and form may leave, and often do not: an
/// effect may hide.
[[nodiscard]] bool may_hide_effect(double error, const Floor& floor);

/// The error below which there is nothing to explain: at the floor, and not far
/// above the noise.
[[nodiscard]] double explained_error(const Floor& floor);
[[nodiscard]] bool is_explained(double error, const Floor& floor);

/// Far above the floor; with effects in the model also above a tenth of the
/// error without them, where the floor is far below what any model reaches.
/// @param floor the form's share included
/// @param base the error with none of the effects
/// @param effects whether there are any in the model
[[nodiscard]] bool is_unexplained(double error,
                                  double floor,
                                  double base,
                                  bool effects);

}  // namespace tapfit::updating
