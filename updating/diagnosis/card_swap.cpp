#include "updating/diagnosis/card_swap.hpp"

#include "updating/comparison/compare.hpp"
#include "updating/diagnosis/worth.hpp"
#include "updating/search/screened.hpp"
#include "updating/search/slip_fits.hpp"
#include "updating/set_up/mistakes.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

namespace tapfit::updating {
namespace {

// Looked at; a deck of more cards has them generated.
constexpr std::size_t most_slips = 12;

// Of these with a base of their own.
constexpr std::size_t most_bases = 2;

// Those that leave clearly less than the deck as it is, the best first: to
// exchange numbers that the measurement does not tell apart is no correction.
std::vector<CardSlip> worth_a_base(const std::vector<CardSlip>& likely,
                                   const Fitter& fitter,
                                   const Progress& progress) {
  const SlipFits screened = screen_slips(fitter, likely, progress);
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t k = 0; k < screened.slips.size(); ++k) {
    const double error = screened.slips[k].error;
    if (error < worth_it * screened.plain.error) order.emplace_back(error, k);
  }
  std::ranges::sort(order);
  std::vector<CardSlip> best;
  for (const auto& [error, k] : order) {
    if (best.size() < most_bases) best.push_back(likely[k]);
  }
  return best;
}

// The one that leaves least, if it is.
// @param tried how many were: each could have been found
std::optional<SetUpMistake> far_likelier(const SlipFits& fits,
                                         std::size_t tried) {
  const auto best = std::ranges::min_element(fits.slips, {}, &SlipFit::error);
  if (best == fits.slips.end()) return std::nullopt;
  const double gain = best->log_likelihood - fits.plain.log_likelihood -
                      std::log(static_cast<double>(tried));
  const bool less = best->error < worth_it * fits.plain.error;
  if (!less || gain < very_strong) return std::nullopt;
  Location where;
  where.elements = best->elements;
  where.variant = best->kind;
  return SetUpMistake{effects::card_swap().name(),
                      std::move(where),
                      1.0 / (1.0 + std::exp(-gain)),
                      best->error,
                      best->edit};
}

// By one effect, or by none.
double least_error(const Diagnosis& found) {
  double least = found.error_fitted;
  for (const Candidate& effect : found.candidates) {
    least = std::min(least, effect.error);
  }
  return least;
}

}  // namespace

bool may_be_slip(const Fit& plain, const Fitter& fitter) {
  return fitter.problem().modes || hides_errors(plain.result.error);
}

std::optional<SetUpMistake> likely_slip(const Fitter& fitter,
                                        const Progress& progress) {
  std::vector<CardSlip> others = card_slips(*fitter.problem().context.deck);
  // A number out of scale first: what else such a deck says wrongly its vectors
  // do not tell.
  std::vector<CardSlip> units;
  std::ranges::copy_if(
      others, std::back_inserter(units), &CardSlip::from_other_unit);
  std::erase_if(others, &CardSlip::from_other_unit);
  for (std::vector<CardSlip>* slips : {&units, &others}) {
    slips->resize(std::min(most_slips, slips->size()));
    const std::size_t tried = slips->size();
    if (slips == &others) *slips = worth_a_base(others, fitter, progress);
    const SlipFits fits = fit_slips(fitter, *slips, progress);
    if (auto slip = far_likelier(fits, tried)) return slip;
  }
  return std::nullopt;
}

bool is_out_of_scale(const SetUpMistake& slip, const structure::Deck& deck) {
  return std::ranges::any_of(slips_at(deck, slip.where),
                             &CardSlip::from_other_unit);
}

bool explains_all(double mended, double as_written, double floor) {
  return mended <= clear_of_floor * floor &&
         as_written > clear_of_floor * mended;
}

bool none_explains(const Diagnosis& found, double floor) {
  return least_error(found) > clear_of_floor * floor;
}

bool leaves_less(const SetUpMistake& slip, const Diagnosis& found) {
  return slip.error < worth_it * least_error(found);
}

}  // namespace tapfit::updating
