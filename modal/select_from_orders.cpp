#include "modal/select_from_orders.hpp"

#include "modal/edit_poles.hpp"
#include "modal/neighbour_modes.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>

namespace tapfit::modal {
namespace {

using Complex = std::complex<double>;

constexpr int kLeastOrder = 20;   // for most of the orders to mean something
constexpr double kClearly = 4.0;  // F of what is explained beyond

int largest(const std::vector<OrderPoles>& orders) {
  return orders.empty() ? 0 : orders.back().order;
}

/// Whether a pole lies further than its half bandwidth from all of a fit.
bool is_new(const Curves& curves, const ModalFit& fit, const Complex& pole) {
  if (!in_band(curves, pole)) return false;
  return std::ranges::none_of(fit.poles, [&pole](const Complex& known) {
    return std::abs(known - pole) < -pole.real();
  });
}

double left_over(const Curves& curves, const ModalFit& fit) {
  return (fit.line_weight.asDiagonal() * (curves.H - fit.H) *
          fit.frf_weight.asDiagonal())
      .squaredNorm();
}

/// Whether a fit leaves so much less than another that chance, or the modes
/// that it has more, do not explain it.
bool explains_more(const Curves& curves,
                   const ModalFit& fit,
                   const ModalFit& other) {
  if (fit.poles.size() == 0) return false;
  if (other.poles.size() == 0) return true;
  const double more =
      std::max(1.0, static_cast<double>(fit.poles.size() - other.poles.size()));
  const double parameters =
      more * (2.0 * static_cast<double>(curves.count()) + 2.0);
  // An exponential window makes neighbouring lines share their noise.
  const double shared =
      std::max(1.0, 2.0 * std::numbers::pi * curves.sigma / curves.spacing);
  const double left = left_over(curves, fit);
  const double noise =
      shared * left / (2.0 * static_cast<double>(curves.H.size()));
  return left_over(curves, other) - left > kClearly * parameters * noise;
}

}  // namespace

Selection select_from_orders(const Curves& curves,
                             const FrfMatrix& matrix,
                             const std::vector<OrderPoles>& orders,
                             const std::vector<Track>& tracks,
                             const IdentifyOptions& options,
                             const Progress& progress) {
  Selection best = select_modes(
      curves, lasting_poles(curves, tracks, orders.size()), options, progress);
  const Progress quiet{{}, progress.stop};
  for (int most = largest(orders) / 2; most >= kLeastOrder; most /= 2) {
    const std::vector<OrderPoles> low =
        plscf_poles(curves, matrix, most, quiet);
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
    Selection trial = select_modes(curves, lasting, options, quiet);
    if (explains_more(curves, trial.fit, best.fit)) best = std::move(trial);
  }
  edit_poles(curves, tracks, options, best.fit);
  return best;
}

}  // namespace tapfit::modal
