#include "modal/select/overlapped_modes.hpp"

#include "modal/select/needed_modes.hpp"
#include "modal/select/neighbour_modes.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <optional>
#include <utility>
#include <vector>

namespace tapfit::modal {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;

constexpr int kMostMissed = 4;
constexpr double kReach = 3.0;   // half bandwidths from one mode to the next
constexpr double kHeavy = 0.05;  // damping ratio that hides modes anywhere
constexpr int kMostPlaces = 4;   // between two poles

std::vector<Complex> modes_in_band(const Curves& curves, const ModalFit& fit) {
  std::vector<Complex> poles;
  for (const Complex& pole : fit.poles) {
    if (in_band(curves, pole)) poles.push_back(pole);
  }
  std::ranges::sort(poles, {}, [](const Complex& p) { return p.imag(); });
  return poles;
}

/// Where a mode could hide: between two poles whose resonances would reach it,
/// and between the outer ones and the ends of the band.
std::vector<Complex> hiding_places(const Curves& curves, const ModalFit& fit) {
  const std::vector<Complex> poles = modes_in_band(curves, fit);
  std::vector<Complex> places;
  if (poles.empty()) return places;
  const double zeta = usual_damping(curves, fit);
  const auto look = [&](double low, double high) {
    const double half = 0.5 * zeta * (low + high);  // bandwidth
    const bool reached = high - low < 2.0 * kReach * half || zeta > kHeavy;
    if (!reached || half < 3.0 * curves.spacing) return;
    const int count = std::clamp(
        static_cast<int>(std::lround((high - low) / (2.0 * kReach * half))),
        1,
        kMostPlaces);
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
double least_significance(const Curves& curves, const ModalFit& fit) {
  double least = kSurelyThere;
  for (Index r = 0; r < fit.poles.size(); ++r) {
    if (!in_band(curves, fit.poles(r))) continue;
    least = std::min(least, fit.significance(r));
  }
  return least;
}

std::optional<ModalFit> with_one_more(const Curves& curves,
                                      const ModalFit& fit,
                                      const IdentifyOptions& options) {
  const double least = least_significance(curves, fit);
  std::optional<ModalFit> best;
  for (const Complex& place : hiding_places(curves, fit)) {
    Eigen::VectorXcd poles(fit.poles.size() + 1);
    poles << fit.poles, place;
    ModalFit trial = refine_in_reach(curves, std::move(poles), 20);
    if (!are_needed(curves, trial, options)) continue;
    if (least_significance(curves, trial) < least) continue;
    if (!best || misfit(curves, trial) < misfit(curves, *best)) {
      best = std::move(trial);
    }
  }
  return best;
}

}  // namespace

ModalFit add_overlapped(const Curves& curves,
                        ModalFit fit,
                        const IdentifyOptions& options) {
  bool found = false;
  for (int k = 0; k < kMostMissed; ++k) {
    std::optional<ModalFit> next = with_one_more(curves, fit, options);
    if (!next) break;
    fit = std::move(*next);
    found = true;
  }
  return found ? by_frequency(curves, fit) : fit;
}

}  // namespace tapfit::modal
