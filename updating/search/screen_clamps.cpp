#include "updating/search/screen_clamps.hpp"

#include "acquisition/foundation/constants.hpp"
#include "acquisition/foundation/parallel.hpp"
#include "updating/catalogue/catalogue.hpp"
#include "updating/frf_model/modes_held.hpp"
#include "updating/places/held_support.hpp"
#include "updating/search/worth_fitting.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

// Each is a base and a fit.
constexpr std::size_t most_clamps = 2;

// Of the logarithm of a frequency: what modes_held() may be off by, and steps
// in which the widest line still tells two apart.
constexpr double own_scatter = 0.05;
constexpr double scale_step = 0.05;

// By what frequencies are tried: all within two standard deviations of what the
// uncertain properties and the modes' own scatter make of them.
std::vector<double> scales(const FitProblem& problem) {
  double variance = own_scatter * own_scatter;
  const std::size_t own =
      problem.uncertain_sd.size() - problem.corrections.size();
  for (std::size_t k = 0; k < own; ++k) {
    variance += std::pow(0.5 * problem.uncertain_sd[k], 2);
  }
  const auto most =
      static_cast<int>(std::ceil(2.0 * std::sqrt(variance) / scale_step));
  std::vector<double> result;
  for (int k = -most; k <= most; ++k)
    result.push_back(std::exp(k * scale_step));
  return result;
}

// Of a structure that is held what was fitted to it free says little: the
// properties are the deck's, the damping what was identified.
ModelState state_held(const Fit& current, const FitProblem& problem) {
  ModelState state = current.result.state;
  state.factor.assign(state.factor.size(), 1.0);
  state.zeta.resize(0);
  state.zeta_other = problem.damping_ratio;
  return state;
}

// What a place holds that the deck does not.
HeldRows rows_held(const FrfModel& model, const Location& where) {
  const structure::Deck& deck = *model.context().deck;
  std::vector<Eigen::RowVectorXd> moved;
  std::vector<Eigen::RowVectorXd> turned;
  for (const HeldGrid& grid : newly_held(deck, where)) {
    const MatrixXd rows =
        model.base().rows.rows_of_grid(deck.grid_index(grid.node));
    for (const char digit : grid.components) {
      (digit <= '3' ? moved : turned).emplace_back(rows.row(digit - '1'));
    }
  }
  const auto stacked = [&model](const std::vector<Eigen::RowVectorXd>& rows) {
    MatrixXd all(std::ssize(rows), model.base().size());
    for (std::size_t k = 0; k < rows.size(); ++k) {
      all.row(static_cast<Index>(k)) = rows[k];
    }
    return all;
  };
  return {stacked(moved), stacked(turned)};
}

}  // namespace

std::vector<Screened> screen_clamps(const Fit& current,
                                    const Fitter& fitter,
                                    const Target& target,
                                    const ProjectedMisfit& misfit,
                                    const Eigen::MatrixXcd& now) {
  std::vector<Screened> result;
  for (const effects::Effect* effect : effects::catalogue()) {
    if (effect->changes_stiffness() != ChangeKind::Support) continue;
    for (const Location& where : fitter.places(*effect)) {
      EffectInstance support{effect, where, {}};
      if (!is_held(where) || is_present(current, support)) continue;
      result.push_back({std::move(support)});
    }
  }
  if (result.empty()) return result;
  const FrfModel& model = *current.model;
  const double top = two_pi * model.context().high_hz;
  const ModelState state = state_held(current, fitter.problem());
  const BaseModes free = model.base_modes(state);
  const std::vector<double> tried = scales(fitter.problem());
  for_each_parallel(result.size(), [&](std::size_t k) {
    const BaseModes held =
        modes_held(free, rows_held(model, result[k].placed.where), top);
    BaseModes scaled = held;
    MatrixXd changes(misfit.directions().rows(), std::ssize(tried));
    for (std::size_t t = 0; t < tried.size(); ++t) {
      scaled.omega = tried[t] * held.omega;
      changes.col(static_cast<Index>(t)) =
          misfit.change(model.respond_through(scaled, state, target.s) - now);
    }
    result[k].error = misfit.errors(changes).minCoeff();
  });
  std::ranges::stable_sort(result, {}, &Screened::error);
  return result;
}

std::vector<Screened> promising_clamps(std::vector<Screened> screened,
                                       const ProjectedMisfit& misfit) {
  const auto all = static_cast<double>(screened.size());
  const double most = worth_it * misfit.unchanged();
  std::erase_if(screened,
                [most](const Screened& s) { return s.error >= most; });
  if (screened.size() > most_clamps) {
    screened.erase(screened.begin() + most_clamps, screened.end());
  }
  for (Screened& s : screened) {
    s.places = all / static_cast<double>(screened.size());
  }
  return screened;
}

}  // namespace tapfit::updating
