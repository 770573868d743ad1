#include "modal/select/repeated_poles.hpp"

#include "modal/fit/fit_residual.hpp"
#include "modal/fit/residue_rank.hpp"
#include "modal/fit/shape_uncertainty.hpp"
#include "modal/mode_set/complexity.hpp"
#include "modal/poles/frf_matrix.hpp"
#include "modal/select/close_modes.hpp"
#include "modal/select/double_poles.hpp"
#include "modal/select/out_of_band_modes.hpp"
#include "modal/select/pole_validation.hpp"

#include <Eigen/Dense>
#include <unsupported/Eigen/MatrixFunctions>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace tapfit::modal {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXcd;

constexpr double over_misfit = 3.0;  // of a shape, as a share of the FRFs
constexpr double least_mpc_of_repeated = 0.8;  // MPC of each shape
constexpr double reciprocal = 0.3;             // asymmetry of X X'

/// The two sides of a complete matrix of FRFs, and shapes on them.
struct Sides {
  std::vector<Dof> outputs;
  std::vector<Dof> references;
  MatrixXcd of_outputs;     ///< n_outputs x n_modes
  MatrixXcd of_references;  ///< n_references x n_modes
};

Sides sides_of(const WeightedFrfs& curves, const FrfMatrix& matrix) {
  const auto& first = matrix.rows.front();
  const auto dof = [](const std::vector<Dof>& dofs, Index f) {
    return dofs[static_cast<std::size_t>(f)];
  };
  const bool sensors_are_references =
      dof(curves.reference, first[0]) == dof(curves.reference, first[1]);
  const std::vector<Dof>& out =
      sensors_are_references ? curves.reference : curves.response;
  const std::vector<Dof>& in =
      sensors_are_references ? curves.response : curves.reference;
  Sides sides;
  for (const auto& row : matrix.rows) sides.outputs.push_back(dof(out, row[0]));
  for (const Index f : first) sides.references.push_back(dof(in, f));
  return sides;
}

/// Turns the columns of A to real as far as that goes, and B's back.
void turn_columns(MatrixXcd& A, MatrixXcd& B) {
  for (Index k = 0; k < A.cols(); ++k) {
    const Complex turn = turn_to_real(A.col(k));
    A.col(k) *= turn;
    B.col(k) /= turn;
  }
}

/// Rows of both sides that belong to one point.
std::vector<std::pair<Index, Index>> driving_points(const Sides& sides) {
  std::vector<std::pair<Index, Index>> pairs;
  for (std::size_t o = 0; o < sides.outputs.size(); ++o) {
    const auto found = std::ranges::find(sides.references, sides.outputs[o]);
    if (found == sides.references.end()) continue;
    pairs.emplace_back(static_cast<Index>(o), found - sides.references.begin());
  }
  return pairs;
}

/// Gives both sides the same shapes at their common points; false where these
/// are too few or contradict each other.
bool join(Sides& sides) {
  MatrixXcd& A = sides.of_outputs;
  MatrixXcd& B = sides.of_references;
  const auto pairs = driving_points(sides);
  const auto rows = static_cast<Index>(pairs.size());
  MatrixXcd A_d(rows, A.cols());
  MatrixXcd B_d(rows, A.cols());
  for (Index k = 0; k < rows; ++k) {
    const auto [output, reference] = pairs[static_cast<std::size_t>(k)];
    A_d.row(k) = A.row(output);
    B_d.row(k) = B.row(reference);
  }
  const Eigen::ColPivHouseholderQR<MatrixXcd> solver(A_d);
  if (solver.rank() < A.cols()) return false;
  const MatrixXcd G = solver.solve(B_d);
  if ((G - G.transpose()).norm() > reciprocal * G.norm()) return false;
  const MatrixXcd X = (0.5 * (G + G.transpose())).sqrt();
  if (!X.allFinite()) return false;
  A = (A * X).eval();
  B = X.transpose().partialPivLu().solve(B.transpose()).transpose().eval();
  return true;
}

/// Turns the basis until the shapes are orthogonal over the outputs.
void make_orthogonal(Sides& sides) {
  const Eigen::MatrixXd gram =
      (sides.of_outputs.adjoint() * sides.of_outputs).real();
  const Eigen::MatrixXd Q =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(gram).eigenvectors();
  sides.of_outputs *= Q;
  sides.of_references *= Q;
}

/// Products of the shapes for every FRF; empty where one has a point that the
/// matrix has not.
MatrixXcd products(const WeightedFrfs& curves, const Sides& sides) {
  std::map<Dof, Eigen::RowVectorXcd> output;
  std::map<Dof, Eigen::RowVectorXcd> reference;
  for (std::size_t o = 0; o < sides.outputs.size(); ++o) {
    output[sides.outputs[o]] = sides.of_outputs.row(static_cast<Index>(o));
  }
  for (std::size_t i = 0; i < sides.references.size(); ++i) {
    reference[sides.references[i]] =
        sides.of_references.row(static_cast<Index>(i));
  }
  MatrixXcd result(curves.count(), sides.of_outputs.cols());
  for (Index f = 0; f < curves.count(); ++f) {
    Dof a = curves.response[static_cast<std::size_t>(f)];
    Dof b = curves.reference[static_cast<std::size_t>(f)];
    if (!output.contains(a) || !reference.contains(b)) std::swap(a, b);
    if (!output.contains(a) || !reference.contains(b)) return {};
    result.row(f) = output[a].cwiseProduct(reference[b]);
  }
  return result;
}

bool move_in_phase(const Sides& sides) {
  for (Index k = 0; k < sides.of_outputs.cols(); ++k) {
    if (phase_collinearity(sides.of_outputs.col(k)) < least_mpc_of_repeated)
      return false;
    if (phase_collinearity(sides.of_references.col(k)) < least_mpc_of_repeated)
      return false;
  }
  return true;
}

/// Each mode's own shapes, from the eigenvectors of the expansion.
Sides told_apart(const PoleExpansion& expansion, Sides sides) {
  const Index n = expansion.residues.rank;
  const auto& svd = expansion.residues.svd;
  const MatrixXcd right = svd.singularValues().head(n).asDiagonal() *
                          svd.matrixV().leftCols(n).adjoint();
  sides.of_outputs = svd.matrixU().leftCols(n) * expansion.vectors;
  sides.of_references =
      expansion.vectors.partialPivLu().solve(right).transpose();
  return sides;
}

/// A basis of the space of all shapes; none where the sides cannot be joined.
std::optional<Sides> any_basis(const PoleExpansion& expansion,
                               const Complex& pole,
                               bool scaled,
                               Sides sides) {
  const Index n = expansion.residues.rank;
  const auto& svd = expansion.residues.svd;
  const Complex to_products(0.0, 2.0 * pole.imag());
  const Eigen::VectorXcd root =
      svd.singularValues().head(n).cwiseSqrt().cast<Complex>();
  sides.of_outputs = svd.matrixU().leftCols(n) * root.asDiagonal();
  sides.of_references =
      to_products * svd.matrixV().leftCols(n).conjugate() * root.asDiagonal();
  turn_columns(sides.of_outputs, sides.of_references);
  if (scaled && !join(sides)) return {};
  make_orthogonal(sides);
  sides.of_references /= to_products;
  return sides;
}

/// What a fit leaves within the half-power bandwidth, over what is there.
double misfit_at(const WeightedFrfs& curves,
                 const ModalFit& fit,
                 const Complex& pole) {
  const double reach =
      std::max(curves.sigma - pole.real(), 2.0 * curves.spacing);
  const auto [begin, count] = lines_within(curves, pole, reach);
  const Eigen::MatrixXcd H = curves.H.middleRows(begin, count);
  const auto u = curves.weights.frf.asDiagonal();
  const double left =
      ((H - fitted_accelerance(curves, fit, begin, count)) * u).norm();
  return left / std::max((H * u).norm(), 1e-150);
}

/// Modes that the residues hold beside what the fit leaves: unlike noise that
/// may have a shape, such as that of a mode next to it that was missed.
Index modes_in(const WeightedFrfs& curves,
               const ModalFit& fit,
               Index r,
               const PoleExpansion& expansion) {
  if (expansion.residues.rank < 2) return 1;
  const ModalFit both = expanded_fit(curves, fit, r);
  const double misfit = misfit_at(curves, both, fit.poles(r));
  const Eigen::VectorXd values = expansion.residues.svd.singularValues();
  const bool is_clear =
      values(expansion.residues.rank - 1) > over_misfit * misfit * values(0);
  return is_clear ? expansion.residues.rank : 1;
}

/// Shapes in the residues of pole r that no pole close to it has: what
/// near poles take of each other's residues is no second shape.
Index shapes_of_its_own(const WeightedFrfs& curves,
                        const FrfMatrix& matrix,
                        const ModalFit& fit,
                        Index r) {
  const Eigen::MatrixXd variance = residue_variance(curves, fit);
  MatrixXcd R = arranged(matrix, fit.residues.col(r));
  for (Index q = 0; q < fit.poles.size(); ++q) {
    if (q == r || !are_close(fit, q, r)) continue;
    const ResidueRank other =
        residue_rank(matrix, fit.residues.col(q), variance.col(q));
    const MatrixXcd U = other.svd.matrixU().leftCols(other.rank);
    R -= U * (U.adjoint() * R);
  }
  return rank_above_noise(matrix, R, variance.col(r));
}

/// Whether poles are where the expansion holds and none fails a hard check.
bool may_be_modes(const WeightedFrfs& curves,
                  const Complex& around,
                  const Eigen::VectorXcd& poles,
                  const IdentifyOptions& options) {
  return std::ranges::all_of(poles, [&](const Complex& pole) {
    return std::abs(pole - around) < -around.real() &&
           !is_impossible(pole, options) && in_band(curves, pole);
  });
}

bool stand_out(const PoleExpansion& expansion) {
  for (Index k = 0; k < expansion.apart.size(); ++k) {
    for (Index l = 0; l < k; ++l) {
      const double apart = std::abs(expansion.apart(k) - expansion.apart(l));
      if (apart < least_separation_sd * expansion.deviation) return false;
    }
  }
  return true;
}

}  // namespace

ModesOfPole modes_of_pole(const WeightedFrfs& curves,
                          const ModalFit& fit,
                          Index r,
                          bool scaled,
                          const IdentifyOptions& options) {
  const Complex pole = fit.poles(r);
  ModesOfPole alone{fit.poles.segment(r, 1), 0.0, fit.residues.col(r)};
  if (!in_band(curves, pole)) return alone;
  const FrfMatrix matrix =
      arrange_frfs(curves, std::numeric_limits<Index>::max());
  if (!holds_second_shape(matrix, fit.residues.col(r))) return alone;
  if (!stands_alone(curves, fit, r)) return alone;
  const PoleExpansion expansion = expand_pole(curves, matrix, fit, r);
  const Index n = modes_in(curves, fit, r, expansion);
  if (n < 2) return alone;
  if (is_crowded(fit, r) && shapes_of_its_own(curves, matrix, fit, r) < n) {
    return alone;
  }
  alone.shapes = n;
  const Sides points = sides_of(curves, matrix);
  const Eigen::VectorXcd apart = (expansion.apart.array() + pole).matrix();
  std::optional<Sides> sides;
  if (stand_out(expansion) && may_be_modes(curves, pole, apart, options)) {
    sides = told_apart(expansion, points);
  }
  const bool told = sides && move_in_phase(*sides);
  if (!told) sides = any_basis(expansion, pole, scaled, points);
  if (!sides || !move_in_phase(*sides)) return alone;
  ModesOfPole modes;
  modes.shapes = n;
  modes.residues = products(curves, *sides);
  if (modes.residues.size() == 0) return alone;
  // What contradicts the shapes is shared among them.
  const Eigen::VectorXcd rest =
      fit.residues.col(r) - modes.residues.rowwise().sum();
  modes.residues.colwise() += (rest / static_cast<double>(n)).eval();
  modes.poles = told ? apart : Eigen::VectorXcd::Constant(n, pole);
  modes.deviation = expansion.deviation;
  return modes;
}

}  // namespace tapfit::modal
