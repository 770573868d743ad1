#include "modal/mass_from_shifts.hpp"

#include "modal/unloaded_modes.hpp"
#include "modal/weighted_fit.hpp"

#include <algorithm>
#include <cmath>

namespace tapfit::modal {
namespace {

using Eigen::Index;

// What modes that were not identified add to a shift d is of the order d^2;
// twice that for those below and above the band together.
constexpr double kSecondOrder = 2.0;
constexpr int kMostSteps = 40;

/// The table freed of masses, and how it changes with them.
struct Freed {
  Eigen::VectorXd y;
  Eigen::MatrixXd J;
};

/// Directions of all sensors of one mass in a set-up, for some modes.
Eigen::MatrixXd directions(const ShiftData& data,
                           const std::vector<Index>& mass_of,
                           Index mass,
                           Index set_up,
                           const std::vector<Index>& modes) {
  Eigen::MatrixXd phi(0, static_cast<Index>(modes.size()));
  for (std::size_t q = 0; q < mass_of.size(); ++q) {
    if (mass_of[q] != mass) continue;
    const Eigen::MatrixXd& own = data.phi[q][static_cast<std::size_t>(set_up)];
    const Index before = phi.rows();
    phi.conservativeResize(before + own.rows(), Eigen::NoChange);
    phi.bottomRows(own.rows()) = own(Eigen::all, modes);
  }
  return phi;
}

std::optional<Freed> freed(const ShiftData& data,
                           const ShiftTable& table,
                           const std::vector<Index>& mass_of,
                           const Eigen::VectorXd& kg) {
  Freed result{table.log_omega, Eigen::MatrixXd(table.rows(), kg.size())};
  for (Index k = 0; k < data.log_omega.rows(); ++k) {
    std::vector<Index> rows;
    std::vector<Index> modes;
    for (Index i = 0; i < table.rows(); ++i) {
      const auto row = static_cast<std::size_t>(i);
      if (table.set_up[row] != k) continue;
      rows.push_back(i);
      modes.push_back(table.mode[row]);
    }
    if (rows.empty()) continue;
    std::vector<Eigen::MatrixXd> phi;
    for (Index mass = 0; mass < kg.size(); ++mass) {
      phi.push_back(directions(data, mass_of, mass, k, modes));
    }
    const Eigen::VectorXd loaded = table.log_omega(rows);
    const std::optional<UnloadedModes> own = unload(loaded, phi, kg);
    if (!own) return std::nullopt;
    result.y(rows) = own->log_omega;
    result.J(rows, Eigen::all) = own->derivative;
  }
  return result;
}

/// Variance of the freed frequencies beyond that of the poles: what the shapes
/// are wrong by, one error for all values of a mode, and what was left out.
Eigen::MatrixXd model_covariance(const ShiftTable& table,
                                 const std::vector<Index>& mass_of,
                                 const Eigen::VectorXd& kg) {
  Eigen::VectorXd shift = Eigen::VectorXd::Zero(table.rows());
  Eigen::VectorXd sd = Eigen::VectorXd::Zero(table.rows());
  for (std::size_t q = 0; q < mass_of.size(); ++q) {
    const auto column = static_cast<Index>(q);
    shift += kg(mass_of[q]) * table.g.col(column);
    sd += std::abs(kg(mass_of[q])) * table.g_sd.col(column);
  }
  Eigen::MatrixXd V = Eigen::MatrixXd::Zero(table.rows(), table.rows());
  for (Index i = 0; i < table.rows(); ++i) {
    for (Index j = 0; j < table.rows(); ++j) {
      const bool same = table.mode[static_cast<std::size_t>(i)] ==
                        table.mode[static_cast<std::size_t>(j)];
      if (same) V(i, j) = sd(i) * sd(j);
    }
  }
  V.diagonal().array() +=
      std::pow(kSecondOrder, 2) * shift.array().square().square();
  return V;
}

/// One Gauss-Newton step and what it was made with.
struct Step {
  Eigen::VectorXd change;
  WeightedFit fit;
  Eigen::MatrixXd X;
  Eigen::MatrixXd V;
};

Step solve_step(const ShiftTable& table,
                const Freed& now,
                const Eigen::MatrixXd& extra,
                bool common) {
  Step step;
  step.X = beside(mode_columns(table), -now.J);
  if (common) step.X = beside(step.X, set_up_columns(table));
  step.V = extra;
  step.V.diagonal() += robust_variance(step.X, now.y, extra, table.variance);
  step.fit = fit_weighted(step.X, now.y, step.V);
  const Index first = mode_columns(table).cols();
  step.change = step.fit.coefficients.segment(first, now.J.cols());
  return step;
}

MassFit summary(const ShiftTable& table,
                const Freed& now,
                const Eigen::VectorXd& kg,
                const Step& step,
                bool common) {
  MassFit result;
  result.kg = kg;
  result.dof = step.fit.dof;
  const double scale =
      std::max(1.0, step.fit.chi2 / static_cast<double>(step.fit.dof));
  const Index first = mode_columns(table).cols();
  const Index masses = kg.size();
  result.covariance =
      scale * step.fit.covariance.block(first, first, masses, masses);
  if (!common) return result;
  const WeightedFit without =
      fit_weighted(step.X.leftCols(first + masses), now.y, step.V);
  result.p_same_fraction = chance_of_gain(step.fit, without);
  const Index set_ups = step.X.cols() - first - masses;
  Eigen::VectorXd c = step.fit.coefficients.tail(set_ups);
  c.array() -= c.mean();
  result.same_fraction =
      c.norm() /
      std::sqrt(static_cast<double>(std::max<Index>(1, set_ups - 1)));
  return result;
}

}  // namespace

std::optional<MassFit> mass_from_shifts(const ShiftData& data,
                                        const ShiftTable& table,
                                        const std::vector<Index>& mass_of,
                                        bool common) {
  const Index masses = *std::ranges::max_element(mass_of) + 1;
  Eigen::VectorXd kg = Eigen::VectorXd::Zero(masses);
  std::optional<Freed> now = freed(data, table, mass_of, kg);
  for (int i = 0; i < kMostSteps && now; ++i) {
    const Eigen::MatrixXd extra = model_covariance(table, mass_of, kg);
    const Step step = solve_step(table, *now, extra, common);
    if (step.fit.dof < 1) return std::nullopt;
    const MassFit result = summary(table, *now, kg, step, common);
    const Eigen::VectorXd sd = result.covariance.diagonal().cwiseSqrt();
    if ((step.change.array().abs() <= 1e-3 * sd.array()).all()) return result;
    std::optional<Freed> next;
    double share = 1.0;
    for (int half = 0; half < 20 && !next; ++half, share *= 0.5) {
      next = freed(data, table, mass_of, kg + share * step.change);
      if (next) kg += share * step.change;
    }
    now = next;
  }
  return std::nullopt;
}

}  // namespace tapfit::modal
