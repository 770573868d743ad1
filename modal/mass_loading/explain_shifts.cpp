#include "modal/mass_loading/explain_shifts.hpp"

#include "modal/mass_loading/mass_from_shifts.hpp"
#include "signal/statistics/tail_probability.hpp"
#include "signal/statistics/weighted_fit.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tapfit::modal {
namespace {

using Eigen::Index;

constexpr double significant = 0.01;
// Of the half bandwidth: a pole that moves by less changes no FRF visibly.
constexpr double visible_share = 0.1;
constexpr double mostly = 0.8;  // of the squared shifts, to be their cause

/// The hypotheses as least squares fits, all with one covariance.
struct Fits {
  signal::WeightedFit still;   ///< a
  signal::WeightedFit mass;    ///< a, m
  signal::WeightedFit common;  ///< a, c
  signal::WeightedFit both;    ///< a, m, c
};

/// g of all sensors together where shapes are scaled, each mode with its own
/// unknown scale where they are not.
Eigen::MatrixXd mass_columns(const ShiftData& data, const ShiftTable& table) {
  const Eigen::VectorXd g = table.g.rowwise().sum();
  if (data.scaled) return -g;
  return -(g.asDiagonal() * mode_columns(table));
}

Fits fit_all(const ShiftTable& table, const Eigen::MatrixXd& m) {
  const Eigen::MatrixXd a = mode_columns(table);
  const Eigen::MatrixXd c = set_up_columns(table);
  const Eigen::MatrixXd all = beside(beside(a, m), c);
  const Eigen::MatrixXd V =
      robust_variance(all, table.log_omega, table.variance).asDiagonal();
  const auto fit = [&](const Eigen::MatrixXd& X) {
    return signal::fit_weighted(X, table.log_omega, V);
  };
  return {fit(a), fit(beside(a, m)), fit(beside(a, c)), fit(all)};
}

/// Share of what is left without that is gone with.
double gain(const signal::WeightedFit& with,
            const signal::WeightedFit& without) {
  return without.chi2 > 0.0 ? 1.0 - with.chi2 / without.chi2 : 0.0;
}

/// Share of the masses' evidence that comes from masses above zero.
double positive_share(const signal::WeightedFit& fit,
                      Index first,
                      Index count) {
  double up = 0.0;
  double all = 0.0;
  for (Index i = first; i < first + count; ++i) {
    const double variance = fit.covariance(i, i);
    if (!(variance > 0.0)) continue;
    const double weight = std::pow(fit.coefficients(i), 2) / variance;
    all += weight;
    if (fit.coefficients(i) > 0.0) up += weight;
  }
  return all > 0.0 ? up / all : 0.0;
}

double largest_shift(const ShiftData& data) {
  double largest = 0.0;
  for (Index r = 0; r < data.log_sd.cols(); ++r) {
    double low = 0.0;
    double high = 0.0;
    bool first = true;
    for (Index k = 0; k < data.log_sd.rows(); ++k) {
      if (!(data.log_sd(k, r) > 0.0)) continue;
      const double value = data.log_omega(k, r);
      low = first ? value : std::min(low, value);
      high = first ? value : std::max(high, value);
      first = false;
    }
    largest = std::max(largest, high - low);
  }
  return largest;
}

/// Whether the shifts are large enough to be seen in an FRF.
bool visible(const ShiftData& data,
             const ShiftTable& table,
             const signal::WeightedFit& still) {
  for (Index i = 0; i < table.rows(); ++i) {
    const double zeta = data.damping(table.mode[static_cast<std::size_t>(i)]);
    if (std::abs(still.left(i)) > visible_share * zeta) return true;
  }
  return false;
}

double noise_chance(const ShiftTable& table) {
  const signal::WeightedFit still =
      signal::fit_weighted(mode_columns(table),
                           table.log_omega,
                           table.variance.asDiagonal().toDenseMatrix());
  return still.dof > 0 ? signal::chi_squared_tail(
                             still.chi2, static_cast<double>(still.dof))
                       : 1.0;
}

MassEstimate estimate(const MassFit& fit, Index mass) {
  MassEstimate result;
  result.kg = fit.kg(mass);
  result.sd_kg = std::sqrt(fit.covariance(mass, mass));
  const double reach =
      signal::t_95(static_cast<double>(fit.dof)) * result.sd_kg;
  result.lo95_kg = result.kg - reach;
  result.hi95_kg = result.kg + reach;
  return result;
}

/// Whether the sensors' masses differ by more than their errors.
bool masses_differ(const MassFit& each) {
  const Index n = each.kg.size();
  Eigen::MatrixXd contrast(n - 1, n);
  contrast << Eigen::MatrixXd::Identity(n - 1, n - 1),
      Eigen::VectorXd::Constant(n - 1, -1.0);
  const Eigen::VectorXd difference = contrast * each.kg;
  const Eigen::MatrixXd V = contrast * each.covariance * contrast.transpose();
  const double q = difference.dot(V.ldlt().solve(difference));
  const auto columns = static_cast<double>(n - 1);
  return signal::f_tail(q / columns, columns, static_cast<double>(each.dof)) <
         significant;
}

std::optional<MassFit> fit_masses(const ShiftData& data,
                                  const ShiftTable& table,
                                  const std::vector<Index>& mass_of) {
  std::optional<MassFit> both = mass_from_shifts(data, table, mass_of, true);
  if (both && both->p_same_fraction < significant) return both;
  return mass_from_shifts(data, table, mass_of, false);
}

void add_masses(const ShiftData& data,
                const ShiftTable& table,
                PoleShifts& result) {
  const std::vector<Index> shared(data.phi.size(), 0);
  const std::optional<MassFit> one = fit_masses(data, table, shared);
  if (!one) return;
  result.p_same_fraction = one->p_same_fraction;
  result.same_fraction = one->same_fraction;
  result.explained = one->explained;
  // Where much is left, steps may have ended anywhere: no mass is better.
  if (one->explained < mostly) return;
  result.masses = {estimate(*one, 0)};
  if (data.phi.size() < 2) return;
  std::vector<Index> own(data.phi.size());
  std::iota(own.begin(), own.end(), Index{0});
  const std::optional<MassFit> each = fit_masses(data, table, own);
  if (!each || !masses_differ(*each)) return;
  result.masses.clear();
  for (const Index mass : own) result.masses.push_back(estimate(*each, mass));
}

}  // namespace

std::optional<PoleShifts> explain_shifts(const ShiftData& data) {
  const ShiftTable table = shift_table(data);
  if (table.rows() < 3) return std::nullopt;
  const Eigen::MatrixXd m = mass_columns(data, table);
  const Fits fits = fit_all(table, m);
  if (fits.mass.dof < 1) return std::nullopt;
  PoleShifts result;
  result.largest = largest_shift(data);
  result.p_noise = noise_chance(table);
  const double p_common = signal::chance_of_gain(fits.both, fits.mass);
  const bool common = p_common < significant;
  const signal::WeightedFit& with = common ? fits.both : fits.mass;
  const signal::WeightedFit& without = common ? fits.common : fits.still;
  result.p_mass = signal::chance_of_gain(with, without);
  result.p_same_fraction = p_common;
  const double up = positive_share(with, mode_columns(table).cols(), m.cols());
  if (result.p_mass < significant && up > mostly) {
    result.cause = ShiftCause::SensorMass;
    result.explained = gain(with, fits.still);
    if (data.scaled) add_masses(data, table, result);
    return result;
  }
  if (result.p_noise > significant || !visible(data, table, fits.still)) {
    return result;
  }
  result.cause = ShiftCause::Unknown;
  result.explained = gain(fits.common, fits.still);
  if (common && result.explained > mostly) {
    result.cause = ShiftCause::SameFraction;
  }
  return result;
}

}  // namespace tapfit::modal
