#include "modal/select/close_modes.hpp"

#include "modal/fit/fit_residual.hpp"
#include "modal/fit/pole_covariance.hpp"
#include "modal/fit/shape_uncertainty.hpp"
#include "modal/poles/frf_matrix.hpp"
#include "modal/select/double_poles.hpp"
#include "modal/select/out_of_band_modes.hpp"
#include "modal/select/pole_validation.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

namespace tapfit::modal {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;

constexpr double readable = 0.2;  // error of a shape: MAC 0.96
constexpr double needed = 4.0;    // F of a pole's residues, as in select_modes
// Half bandwidths: the expansion of nearer poles around one is off by the
// square of it, their residues by the noise over it.
constexpr double one_pole = 0.1;
constexpr double trusted = 0.3;        // half bandwidths, for the covariance
constexpr double one_reference = 0.5;  // half bandwidths, two by one reference

/// Error of each pole's residues as a share of them, weighted.
Eigen::VectorXd residue_error(const WeightedFrfs& curves, const ModalFit& fit) {
  const auto u = fit.frf_weight.asDiagonal();
  const Eigen::MatrixXd deviation =
      residue_variance(curves, fit).cwiseMax(0.0).cwiseSqrt();
  const Eigen::VectorXd size =
      (u * fit.residues).colwise().norm().transpose().cwiseMax(1e-300);
  return (u * deviation).colwise().norm().transpose().cwiseQuotient(size);
}

/// Distance of two poles in half bandwidths of the wider one.
double distance(const ModalFit& fit, Index q, Index r) {
  const double width = -std::min(fit.poles(q).real(), fit.poles(r).real());
  return std::abs(fit.poles(r) - fit.poles(q)) / width;
}

/// To the nearest other pole, in half bandwidths.
double nearest_distance(const ModalFit& fit, Index r) {
  double least = std::numeric_limits<double>::max();
  for (Index q = 0; q < fit.poles.size(); ++q) {
    if (q != r) least = std::min(least, distance(fit, q, r));
  }
  return least;
}

/// Whether the last poles are apart and each with a shape that can be read.
bool are_known(const WeightedFrfs& curves, const ModalFit& fit, Index count) {
  if (residue_error(curves, fit).tail(count).maxCoeff() > readable) {
    return false;
  }
  const Eigen::MatrixXd covariance = pole_covariance(curves, fit);
  const Index all = fit.poles.size();
  for (Index r = all - count; r < all; ++r) {
    for (Index q = all - count; q < r; ++q) {
      if (!are_told_apart(covariance, fit, q, r)) return false;
    }
  }
  return true;
}

/// The largest distance between two poles.
double extent(const Eigen::VectorXcd& poles) {
  double most = 0.0;
  for (const Complex& pole : poles) {
    most = std::max(most, (poles.array() - pole).abs().maxCoeff());
  }
  return most;
}

using Pair = std::pair<Index, Index>;

/// Whether two poles may be one that differs a little from FRF to FRF: for
/// residues R and shifts d both leave R / (s - p) + R d / (s - p)^2, up to the
/// square of the distance. Only a second reference tells them apart.
bool look_like_a_shift(const FrfMatrix& matrix,
                       const ModalFit& fit,
                       const Pair& pair) {
  return matrix.references < 2 &&
         distance(fit, pair.first, pair.second) < one_reference;
}

/// Pairs of poles in the band that may be one, nearest first: not told apart,
/// or too near for the covariance to be trusted.
std::vector<Pair> doubtful_pairs(const WeightedFrfs& curves,
                                 const FrfMatrix& matrix,
                                 const ModalFit& fit) {
  std::vector<std::pair<double, Pair>> pairs;
  bool crowded = false;
  for (Index r = 0; r < fit.poles.size(); ++r) crowded |= is_crowded(fit, r);
  if (!crowded) return {};
  const Eigen::MatrixXd covariance = pole_covariance(curves, fit);
  const Eigen::VectorXd error = residue_error(curves, fit);
  for (Index r = 0; r < fit.poles.size(); ++r) {
    for (Index q = 0; q < r; ++q) {
      if (!in_band(curves, fit.poles(q)) || !in_band(curves, fit.poles(r))) {
        continue;
      }
      const double apart = distance(fit, q, r);
      const bool known = apart > trusted &&
                         !look_like_a_shift(matrix, fit, {q, r}) &&
                         std::max(error(q), error(r)) < readable &&
                         are_told_apart(covariance, fit, q, r);
      if (apart < 1.0 && !known) pairs.push_back({apart, {q, r}});
    }
  }
  std::ranges::sort(pairs);
  std::vector<Pair> result;
  for (const auto& [apart, pair] : pairs) result.push_back(pair);
  return result;
}

/// What a fit leaves within a bandwidth and a half of a pole, weighted.
struct LeftOver {
  double sum = 0.0;
  double values = 0.0;  ///< real ones
};

LeftOver left_over_near(const WeightedFrfs& curves,
                        const ModalFit& fit,
                        const Complex& pole) {
  const double reach =
      std::max(3.0 * (curves.sigma - pole.real()), 6.0 * curves.spacing);
  const auto [begin, count] = lines_within(curves, pole, reach);
  const Eigen::VectorXd power =
      left_per_line(curves, fit, {{begin, begin + count}});
  return {power.segment(begin, count).sum(),
          2.0 * static_cast<double>(count * curves.count())};
}

/// Whether other poles have moved to do what one of two did.
bool take_over(const WeightedFrfs& curves,
               const Eigen::VectorXcd& before,
               const Eigen::VectorXcd& after) {
  for (Index r = 0; r < before.size(); ++r) {
    const bool inside = in_band(curves, before(r));
    if (inside != in_band(curves, after(r))) return true;
    if (inside && std::abs(after(r) - before(r)) > -before(r).real()) {
      return true;
    }
  }
  return false;
}

/// Whether two poles explain the FRFs around them clearly better than one fit.
bool two_are_needed(const WeightedFrfs& curves,
                    const ModalFit& two,
                    const ModalFit& one,
                    const Complex& pole) {
  const LeftOver of_two = left_over_near(curves, two, pole);
  const LeftOver of_one = left_over_near(curves, one, pole);
  const double parameters = 2.0 * static_cast<double>(curves.count()) + 2.0;
  // An exponential window makes neighbouring lines share their noise.
  const double shared =
      std::max(1.0, 2.0 * std::numbers::pi * curves.sigma / curves.spacing);
  const double noise = shared * of_two.sum / std::max(of_two.values, 1.0);
  return of_one.sum - of_two.sum > needed * parameters * noise;
}

/// Whether poles of their own serve better than the expansion of one. Its modes
/// are told apart, and are so far from each other, or so little disturbed, that
/// what it leaves out is more than the noise. Residues of near poles let some
/// ten times as much noise into their distance.
bool are_apart_in(const PoleExpansion& expansion, double half) {
  if (expansion.residues.rank < 2) return false;
  const double apart = extent(expansion.apart);
  const double left_out = apart * apart / half;
  const bool far = apart > one_pole * half;
  const bool clean = 10.0 * expansion.deviation < left_out;
  return apart > least_separation_sd * expansion.deviation && (far || clean);
}

/// Between two poles, nearer to the one that the FRFs show more of.
Complex between(const ModalFit& fit, Index q, Index r) {
  const double a = fit.contribution(q);
  const double b = fit.contribution(r);
  return (a * fit.poles(q) + b * fit.poles(r)) / (a + b);
}

/// A fit with one pole, the last, in place of two; none where two are needed.
std::optional<ModalFit> as_one_pole(const WeightedFrfs& curves,
                                    const FrfMatrix& matrix,
                                    const ModalFit& fit,
                                    const Pair& pair) {
  const auto [q, r] = pair;
  const Eigen::VectorXcd rest = without(without(fit.poles, r), q);
  Eigen::VectorXcd poles(rest.size() + 1);
  poles << rest, between(fit, q, r);
  ModalFit one = refine_poles(curves, poles, 20);
  const Index last = rest.size();
  if (take_over(curves, rest, one.poles)) return {};
  if (look_like_a_shift(matrix, fit, pair)) return one;
  // Too near a third there is no expansion that could take the two apart again.
  if (matrix.references > 1 && (nearest_distance(one, last) < trusted ||
                                !stands_alone(curves, one, last))) {
    return {};
  }
  const PoleExpansion expansion = expand_pole(curves, matrix, one, last);
  if (are_apart_in(expansion, -one.poles(last).real())) return {};
  // Two shapes under one pole keep what the expansion tells of them.
  const bool two_shapes = expansion.residues.rank > 1;
  const ModalFit rival = two_shapes ? expanded_fit(curves, one, last) : one;
  if (two_are_needed(curves, fit, rival, one.poles(last))) return {};
  return one;
}

/// The poles in the band within a bandwidth of pole r, which is in it.
std::vector<Index> within_bandwidth(const WeightedFrfs& curves,
                                    const ModalFit& fit,
                                    Index r) {
  std::vector<Index> group;
  for (Index q = 0; q < fit.poles.size(); ++q) {
    if (are_close(fit, q, r) && in_band(curves, fit.poles(q))) {
      group.push_back(q);
    }
  }
  return group;
}

/// A fit with one pole, the last, in place of a group's.
ModalFit as_one(const WeightedFrfs& curves,
                const ModalFit& fit,
                const std::vector<Index>& group) {
  Eigen::VectorXcd rest = fit.poles;
  for (auto r = group.rbegin(); r != group.rend(); ++r) {
    rest = without(rest, *r);
  }
  Eigen::VectorXcd poles(rest.size() + 1);
  poles << rest, fit.poles(group).mean();
  return group.size() < 2 ? fit_residues(curves, poles)
                          : refine_poles(curves, poles, 20);
}

/// Poles found put in place of the last one of a fit, and refined; none where
/// one is no mode, or they leave their place without clearly explaining more.
std::optional<ModalFit> with_poles(const WeightedFrfs& curves,
                                   const ModalFit& one,
                                   const Eigen::VectorXcd& found,
                                   const IdentifyOptions& options) {
  const Index last = one.poles.size() - 1;
  const Complex around = one.poles(last);
  const auto are_near = [&around](const Eigen::VectorXcd& poles) {
    return (poles.array() - around).abs().maxCoeff() < -2.0 * around.real();
  };
  if (!are_near(found) || found.real().maxCoeff() >= 0.0) return {};
  Eigen::VectorXcd poles(last + found.size());
  poles << one.poles.head(last), found;
  ModalFit fit = refine_poles(curves, poles, 20);
  const Eigen::VectorXcd refined = fit.poles.tail(found.size());
  if (!are_near(refined)) return {};
  for (const Complex& pole : refined) {
    if (is_impossible(pole, options) || !in_band(curves, pole)) return {};
  }
  const bool stayed =
      (refined - found).array().abs().maxCoeff() < extent(found);
  if (!stayed && !two_are_needed(curves, fit, one, around)) return {};
  return fit;
}

}  // namespace

bool are_close(const ModalFit& fit, Index q, Index r) {
  return distance(fit, q, r) < 1.0;
}

bool is_crowded(const ModalFit& fit, Index r) {
  for (Index q = 0; q < fit.poles.size(); ++q) {
    if (q != r && are_close(fit, q, r)) return true;
  }
  return false;
}

bool stands_alone(const WeightedFrfs& curves, const ModalFit& fit, Index r) {
  if (!is_crowded(fit, r)) return true;
  if (residue_error(curves, fit)(r) > readable) return false;
  const Eigen::MatrixXd covariance = pole_covariance(curves, fit);
  for (Index q = 0; q < fit.poles.size(); ++q) {
    if (q == r || !are_close(fit, q, r)) continue;
    if (!are_told_apart(covariance, fit, q, r)) return false;
  }
  return true;
}

bool are_told_apart(const Eigen::MatrixXd& covariance,
                    const ModalFit& fit,
                    Index q,
                    Index r) {
  const Complex apart = fit.poles(r) - fit.poles(q);
  const Eigen::Vector2d d(apart.real(), apart.imag());
  const auto block = [&](Index a, Index b) {
    return covariance.block<2, 2>(2 * a, 2 * b);
  };
  const Eigen::Matrix2d spread =
      block(r, r) + block(q, q) - block(r, q) - block(q, r);
  // Along the line between them.
  const double variance = std::max(0.0, d.dot(spread * d));
  return least_separation_sd * std::sqrt(variance) <= d.squaredNorm();
}

ModalFit separate_close(const WeightedFrfs& curves,
                        ModalFit fit,
                        const IdentifyOptions& options) {
  const FrfMatrix matrix = arrange_frfs(curves);
  if (matrix.references < 2) return fit;
  for (Index r = fit.poles.size() - 1; r >= 0; --r) {
    const std::vector<Index> group = within_bandwidth(curves, fit, r);
    // A group is tried once, from the last of its poles.
    if (group.empty() || group.back() != r) continue;
    const ModalFit one = as_one(curves, fit, group);
    const Index last = one.poles.size() - 1;
    const PoleExpansion expansion = expand_pole(curves, matrix, one, last);
    if (expansion.residues.rank <= static_cast<Index>(group.size())) continue;
    const Eigen::VectorXcd found =
        (expansion.apart.array() + one.poles(last)).matrix();
    std::optional<ModalFit> trial = with_poles(curves, one, found, options);
    if (!trial || !are_known(curves, *trial, found.size())) continue;
    const Complex& place = one.poles(last);
    if (left_over_near(curves, *trial, place).sum >
        left_over_near(curves, fit, place).sum) {
      continue;
    }
    fit = std::move(*trial);
    r = std::min(r, fit.poles.size());
  }
  return fit;
}

ModalFit at_rest_by_one_reference(const WeightedFrfs& curves, ModalFit fit) {
  if (fit.poles.size() == 0 || arrange_frfs(curves).references > 1) return fit;
  return refine_in_reach(curves, fit.poles, 20);
}

ModalFit merge_unresolved_poles(const WeightedFrfs& curves,
                                ModalFit fit,
                                std::vector<Complex>& shifting) {
  const FrfMatrix matrix = arrange_frfs(curves);
  std::optional<ModalFit> united;
  do {
    united.reset();
    for (const Pair& pair : doubtful_pairs(curves, matrix, fit)) {
      united = as_one_pole(curves, matrix, fit, pair);
      if (!united) continue;
      const Complex pole = united->poles(united->poles.size() - 1);
      if (look_like_a_shift(matrix, fit, pair) &&
          two_are_needed(curves, fit, *united, pole)) {
        shifting.push_back(pole);
      }
      break;
    }
    if (united) fit = std::move(*united);
  } while (united);
  return fit;
}

}  // namespace tapfit::modal
