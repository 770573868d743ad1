#include "modal/select/overlapped_modes.hpp"

#include "acquisition/foundation/parallel.hpp"
#include "modal/select/needed_modes.hpp"
#include "modal/select/out_of_band_modes.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

namespace tapfit::modal {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;

constexpr int most_missed = 4;
constexpr double reach_of_mode =
    3.0;                            // half bandwidths from one mode to the next
constexpr double heavy = 0.05;      // damping ratio that hides modes anywhere
constexpr int most_places = 4;      // between two poles
constexpr double same_place = 0.1;  // half bandwidths

std::vector<Complex> modes_in_band(const WeightedFrfs& curves,
                                   const ModalFit& fit) {
  std::vector<Complex> poles;
  for (const Complex& pole : fit.poles) {
    if (in_band(curves, pole)) poles.push_back(pole);
  }
  std::ranges::sort(poles, {}, [](const Complex& p) { return p.imag(); });
  return poles;
}

/// Where a mode could hide: between two poles whose resonances would reach it,
/// and between the outer ones and the ends of the band.
std::vector<Complex> hiding_places(const WeightedFrfs& curves,
                                   const ModalFit& fit) {
  const std::vector<Complex> poles = modes_in_band(curves, fit);
  std::vector<Complex> places;
  if (poles.empty()) return places;
  const double zeta = usual_damping(curves, fit);
  const auto look = [&](double low, double high) {
    const double half = 0.5 * zeta * (low + high);  // bandwidth
    const bool reached =
        high - low < 2.0 * reach_of_mode * half || zeta > heavy;
    if (!reached || half < 3.0 * curves.spacing) return;
    const int count =
        std::clamp(static_cast<int>(std::lround((high - low) /
                                                (2.0 * reach_of_mode * half))),
                   1,
                   most_places);
    for (int k = 1; k <= count; ++k) {
      const double omega = low + (high - low) * k / (count + 1);
      places.emplace_back(-zeta * omega, omega);
    }
  };
  look(curves.s(0).imag(), poles.front().imag());
  for (std::size_t k = 1; k < poles.size(); ++k) {
    look(poles[k - 1].imag(), poles[k].imag());
  }
  look(poles.back().imag(), curves.s(curves.lines() - 1).imag());
  return places;
}

/// Least F of the modes in the band.
double least_significance(const WeightedFrfs& curves, const ModalFit& fit) {
  double least = surely_there;
  for (Index r = 0; r < fit.poles.size(); ++r) {
    if (!in_band(curves, fit.poles(r))) continue;
    least = std::min(least, fit.significance(r));
  }
  return least;
}

/// The fit with a mode more at a place, where the FRFs need it.
std::optional<ModalFit> with_mode_at(const WeightedFrfs& curves,
                                     const ModalFit& fit,
                                     const Complex& place,
                                     const IdentifyOptions& options) {
  Eigen::VectorXcd poles(fit.poles.size() + 1);
  poles << fit.poles, place;
  ModalFit trial = refine_in_reach(curves, std::move(poles), 20);
  if (trial.poles.size() <= fit.poles.size()) return {};
  if (!are_needed(curves, trial, options)) return {};
  if (least_significance(curves, trial) < least_significance(curves, fit)) {
    return {};
  }
  return trial;
}

/// Whether a place was in vain before: modes far from it do not change that.
bool is_known(const std::vector<Complex>& in_vain, const Complex& place) {
  return std::ranges::any_of(in_vain, [&place](const Complex& other) {
    return std::abs(other - place) < -same_place * place.real();
  });
}

/// The best of all fits with one mode more; none where no place has one.
///
/// @param in_vain places that need not be tried again; grows
/// @param tried told of the share of places
std::optional<ModalFit> with_one_more(
    const WeightedFrfs& curves,
    const ModalFit& fit,
    const IdentifyOptions& options,
    std::vector<Complex>& in_vain,
    const std::function<void(double)>& tried) {
  std::vector<Complex> places = hiding_places(curves, fit);
  std::erase_if(places, [&in_vain](const Complex& place) {
    return is_known(in_vain, place);
  });
  std::vector<std::optional<ModalFit>> trials(places.size());
  std::mutex telling;
  std::size_t begun = 0;
  for_each_parallel(places.size(), [&](std::size_t k) {
    {
      const std::lock_guard lock(telling);
      tried(static_cast<double>(begun++) / static_cast<double>(places.size()));
    }
    trials[k] = with_mode_at(curves, fit, places[k], options);
  });
  std::optional<ModalFit> best;
  for (std::size_t k = 0; k < places.size(); ++k) {
    if (!trials[k]) {
      in_vain.push_back(places[k]);
    } else if (!best || trials[k]->misfit < best->misfit) {
      best = std::move(trials[k]);
    }
  }
  return best;
}

}  // namespace

ModalFit add_overlapped(const WeightedFrfs& curves,
                        ModalFit fit,
                        const IdentifyOptions& options,
                        const Progress& progress) {
  bool found = false;
  std::vector<Complex> in_vain;
  for (int k = 0; k < most_missed; ++k) {
    const auto tell = [&progress, k](double share) {
      progress("hidden modes", (k + share) / most_missed);
    };
    std::optional<ModalFit> next =
        with_one_more(curves, fit, options, in_vain, tell);
    if (!next) break;
    fit = std::move(*next);
    found = true;
  }
  return found ? by_frequency(curves, fit) : fit;
}

}  // namespace tapfit::modal
