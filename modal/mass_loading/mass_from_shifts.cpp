#include "modal/mass_loading/mass_from_shifts.hpp"

#include "acquisition/samples/statistics.hpp"
#include "modal/mass_loading/unloaded_modes.hpp"
#include "signal/statistics/weighted_fit.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace tapfit::modal {
namespace {

using Eigen::Index;

// A mode q that was not identified adds to a shift d_r of mode r
//   2 d_r d_q w_r^2 / (w_q^2 - w_r^2),   d = m phi^2 / 2.
// With d_q as large as the mean of the modes found at the point and modes
// evenly spaced, the sum over q is 2 d_r d times 0.8 in the middle of the band
// and 6 at its end; times 2 is taken for all.
constexpr double second_order = 4.0;
constexpr int most_steps = 40;

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

/// Rows of the table that are of a set-up, and their modes.
struct Part {
  std::vector<Index> rows;
  std::vector<Index> modes;
};

Part part_of(const ShiftTable& table, Index set_up) {
  Part part;
  for (Index i = 0; i < table.rows(); ++i) {
    const auto row = static_cast<std::size_t>(i);
    if (table.set_up[row] != set_up) continue;
    part.rows.push_back(i);
    part.modes.push_back(table.mode[row]);
  }
  return part;
}

/// Frees the set-ups of masses.
class Unloading {
 public:
  Unloading(const ShiftData& data,
            const ShiftTable& table,
            const std::vector<Index>& mass_of,
            const Eigen::VectorXd& kg)
      : data_(&data), table_(&table), mass_of_(&mass_of), kg_(&kg) {
    if (data.driving) find_hammer(static_cast<Index>(*data.driving));
  }

  /// One set-up. FRFs give the products phi_s phi_h of sensor and hammer, and
  /// the shapes have the phi_h of the set-up whose driving point was measured.
  /// In another one the masses mix the modes another way: its phi_h is such
  /// that without the masses it is the same.
  [[nodiscard]] std::optional<UnloadedModes> unload_set_up(
      Index k, const Part& part) const {
    std::vector<Eigen::MatrixXd> phi;
    for (Index mass = 0; mass < kg_->size(); ++mass) {
      phi.push_back(directions(*data_, *mass_of_, mass, k, part.modes));
    }
    const Eigen::VectorXd loaded = table_->log_omega(part.rows);
    std::optional<UnloadedModes> own = unload(loaded, phi, *kg_);
    if (!own || !follows_hammer(k, part.modes)) return own;
    const Eigen::RowVectorXd stated = hammer(k)(0, part.modes);
    const Eigen::RowVectorXd wanted = free_hammer_(part.modes);
    for (int i = 0; i < most_rounds && own; ++i) {
      const Eigen::RowVectorXd now = own->vectors.transpose()
                                         .partialPivLu()
                                         .solve(wanted.transpose())
                                         .transpose();
      // A hammer next to a mode's node says nothing of that mode's scale.
      const Eigen::RowVectorXd factor =
          stated.cwiseQuotient(now).cwiseMax(0.5).cwiseMin(2.0);
      std::vector<Eigen::MatrixXd> scaled;
      for (const Eigen::MatrixXd& rows : phi) {
        scaled.emplace_back(rows * factor.asDiagonal());
      }
      own = unload(loaded, scaled, *kg_);
    }
    return own;
  }

 private:
  static constexpr int most_rounds = 8;

  [[nodiscard]] const Eigen::MatrixXd& hammer(Index k) const {
    return data_->hammer[static_cast<std::size_t>(k)];
  }
  [[nodiscard]] bool follows_hammer(Index k,
                                    const std::vector<Index>& modes) const {
    if (free_hammer_.size() == 0 || hammer(k).rows() == 0) return false;
    if (static_cast<std::size_t>(k) == *data_->driving) return false;
    return std::ranges::all_of(modes,
                               [&](Index r) { return free_hammer_(r) != 0.0; });
  }
  void find_hammer(Index k) {
    const Part part = part_of(*table_, k);
    const std::optional<UnloadedModes> own = unload_set_up(k, part);
    if (!own || part.modes.empty()) return;
    const Eigen::RowVectorXd loaded = hammer(k)(0, part.modes);
    const Eigen::RowVectorXd free = loaded * own->vectors;
    free_hammer_ = Eigen::RowVectorXd::Zero(data_->log_omega.cols());
    free_hammer_(part.modes) = free;
  }

  const ShiftData* data_;
  const ShiftTable* table_;
  const std::vector<Index>* mass_of_;
  const Eigen::VectorXd* kg_;
  Eigen::RowVectorXd free_hammer_;  // per mode, 0 where not known
};

std::optional<Freed> freed(const ShiftData& data,
                           const ShiftTable& table,
                           const std::vector<Index>& mass_of,
                           const Eigen::VectorXd& kg) {
  const Unloading unloading(data, table, mass_of, kg);
  Freed result{table.log_omega, Eigen::MatrixXd(table.rows(), kg.size())};
  for (Index k = 0; k < data.log_omega.rows(); ++k) {
    const Part part = part_of(table, k);
    if (part.rows.empty()) continue;
    const std::optional<UnloadedModes> own = unloading.unload_set_up(k, part);
    if (!own) return std::nullopt;
    result.y(part.rows) = own->log_omega;
    result.J(part.rows, Eigen::all) = own->derivative;
  }
  return result;
}

/// Covariance of the freed frequencies beyond that of the poles: what the
/// shapes are wrong by, at each point and, by the hammer's point, in a whole
/// mode; and the modes that were left out.
Eigen::MatrixXd model_covariance(const ShiftData& data,
                                 const ShiftTable& table,
                                 const std::vector<Index>& mass_of,
                                 const Eigen::VectorXd& kg) {
  const Index n = table.rows();
  Eigen::ArrayXd shift = Eigen::ArrayXd::Zero(n);
  Eigen::ArrayXd own = Eigen::ArrayXd::Zero(n);
  for (std::size_t q = 0; q < mass_of.size(); ++q) {
    const auto column = static_cast<Index>(q);
    shift += kg(mass_of[q]) * table.g.col(column).array();
    own += (kg(mass_of[q]) * table.g_sd.col(column).array()).square();
  }
  Eigen::MatrixXd V = Eigen::MatrixXd::Zero(n, n);
  for (Index i = 0; i < n; ++i) {
    const Index mode = table.mode[static_cast<std::size_t>(i)];
    const double scale = 2.0 * data.scale_sd(mode) * shift(i);
    for (Index j = 0; j < n; ++j) {
      if (table.mode[static_cast<std::size_t>(j)] != mode) continue;
      V(i, j) = scale * 2.0 * data.scale_sd(mode) * shift(j);
    }
  }
  // Of one sign for many poles, so that it does not average out; and more or
  // less from point to point.
  const Eigen::VectorXd missing = second_order * shift.mean() * shift;
  V += missing * missing.transpose();
  V.diagonal().array() += own + missing.array().square();
  return V;
}

/// One Gauss-Newton step and what it was made with.
struct Step {
  Eigen::VectorXd change;
  signal::WeightedFit fit;
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
  const Eigen::VectorXd known = table.variance + extra.diagonal();
  step.V = extra;
  step.V.diagonal() = robust_variance(step.X, now.y, known);
  step.fit = signal::fit_weighted(step.X, now.y, step.V);
  const Index first = mode_columns(table).cols();
  step.change = step.fit.coefficients.segment(first, now.J.cols());
  return step;
}

/// What a quarter of the values are above: a wrong pole or two do not move it.
double upper_quartile(Eigen::VectorXd values) {
  const auto at = values.begin() + 3 * values.size() / 4;
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

MassFit summary(const ShiftTable& table,
                const Freed& now,
                const Eigen::VectorXd& kg,
                const Step& step,
                bool common) {
  MassFit result;
  result.kg = kg;
  result.dof = step.fit.dof;
  const signal::WeightedFit still =
      signal::fit_weighted(mode_columns(table), table.log_omega, step.V);
  const Eigen::VectorXd known = table.variance.cwiseInverse();
  const double before =
      upper_quartile(still.left.cwiseAbs2().cwiseProduct(known));
  const double after =
      upper_quartile(step.fit.left.cwiseAbs2().cwiseProduct(known));
  if (before > 0.0) result.explained = std::max(0.0, 1.0 - after / before);
  const double scale =
      std::max(1.0, step.fit.chi2 / static_cast<double>(step.fit.dof));
  const Index first = mode_columns(table).cols();
  const Index masses = kg.size();
  result.covariance =
      scale * step.fit.covariance.block(first, first, masses, masses);
  if (!common) return result;
  const signal::WeightedFit without =
      signal::fit_weighted(step.X.leftCols(first + masses), now.y, step.V);
  result.p_same_fraction = signal::chance_of_gain(step.fit, without);
  const Index set_ups = step.X.cols() - first - masses;
  Eigen::VectorXd c = step.fit.coefficients.tail(set_ups);
  c.array() -= c.mean();
  result.same_fraction =
      c.norm() /
      std::sqrt(static_cast<double>(std::max<Index>(1, set_ups - 1)));
  return result;
}

/// Sum of |y - median of its mode|: how far apart the set-ups are.
double disagreement(const ShiftTable& table, const Eigen::VectorXd& y) {
  std::vector<std::vector<double>> of_mode;
  for (Index i = 0; i < table.rows(); ++i) {
    const auto mode =
        static_cast<std::size_t>(table.mode[static_cast<std::size_t>(i)]);
    if (of_mode.size() <= mode) of_mode.resize(mode + 1);
    of_mode[mode].push_back(y(i));
  }
  double sum = 0.0;
  for (const std::vector<double>& values : of_mode) {
    const double median = acquisition::median(values);
    for (const double value : values) sum += std::abs(value - median);
  }
  return sum;
}

/// The mass, the same for all, at which set-ups disagree least: where masses
/// mix neighbouring modes, steps from zero may end elsewhere.
Eigen::VectorXd start_masses(const ShiftData& data,
                             const ShiftTable& table,
                             const std::vector<Index>& mass_of,
                             Index masses) {
  Eigen::VectorXd best = Eigen::VectorXd::Zero(masses);
  const double largest = table.g.rowwise().sum().maxCoeff();
  if (!(largest > 0.0)) return best;
  double least = disagreement(table, table.log_omega);
  // From a ten-thousandth of the shapes' modal mass to all of it.
  constexpr int steps = 97;
  for (int step = 0; step < steps; ++step) {
    const double kg = 1e-4 * std::pow(1.1, step) / largest;
    const Eigen::VectorXd trial = Eigen::VectorXd::Constant(masses, kg);
    const std::optional<Freed> now = freed(data, table, mass_of, trial);
    if (!now) break;
    const double apart = disagreement(table, now->y);
    if (apart >= least) continue;
    least = apart;
    best = trial;
  }
  return best;
}

}  // namespace

std::optional<MassFit> mass_from_shifts(const ShiftData& data,
                                        const ShiftTable& table,
                                        const std::vector<Index>& mass_of,
                                        bool common) {
  const Index masses = *std::ranges::max_element(mass_of) + 1;
  Eigen::VectorXd kg = start_masses(data, table, mass_of, masses);
  std::optional<Freed> now = freed(data, table, mass_of, kg);
  for (int i = 0; i < most_steps && now; ++i) {
    const Eigen::MatrixXd extra = model_covariance(data, table, mass_of, kg);
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
