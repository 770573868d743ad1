#include "modal/select/select_from_orders.hpp"

#include "modal/select/out_of_band_modes.hpp"
#include "modal/select/overlapped_modes.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>

namespace tapfit::modal {
namespace {

using Complex = std::complex<double>;

constexpr int least_order = 20;  // for most of the orders to mean something
constexpr double clearly_less = 0.5;  // of the misfit, squared

int largest(const std::vector<OrderPoles>& orders) {
  return orders.empty() ? 0 : orders.back().order;
}

/// Whether a pole lies further than its half bandwidth from all of a fit.
bool is_new(const WeightedFrfs& curves,
            const ModalFit& fit,
            const Complex& pole) {
  if (!in_band(curves, pole)) return false;
  return std::ranges::none_of(fit.poles, [&pole](const Complex& known) {
    return std::abs(known - pole) < -pole.real();
  });
}

/// Whether a fit leaves so much less than another that this one must have lost
/// a mode: noise that is not white can be followed a good way by some poles.
bool explains_more(const ModalFit& fit, const ModalFit& other) {
  if (fit.poles.size() == 0) return false;
  return other.poles.size() == 0 || fit.misfit < clearly_less * other.misfit;
}

}  // namespace

Selection select_from_orders(const WeightedFrfs& curves,
                             const FrfMatrix& matrix,
                             const std::vector<OrderPoles>& orders,
                             const std::vector<Track>& tracks,
                             const IdentifyOptions& options,
                             const Progress& progress) {
  Selection best = select_modes(
      curves, lasting_poles(curves, tracks, orders.size()), options, progress);
  for (int most = largest(orders) / 2; most >= least_order; most /= 2) {
    const std::vector<OrderPoles> low =
        plscf_poles(curves, matrix, most, progress);
    const Eigen::VectorXcd lasting =
        lasting_poles(curves,
                      stabilise(low,
                                curves.s(0).imag(),
                                curves.s(curves.lines() - 1).imag(),
                                options)
                          .tracks,
                      low.size());
    const bool any_new = std::ranges::any_of(lasting, [&](const Complex& pole) {
      return is_new(curves, best.fit, pole);
    });
    if (!any_new) continue;
    Selection trial = select_modes(curves, lasting, options, progress);
    if (explains_more(trial.fit, best.fit)) best = std::move(trial);
  }
  best.fit = add_overlapped(curves, std::move(best.fit), options, progress);
  return best;
}

}  // namespace tapfit::modal
