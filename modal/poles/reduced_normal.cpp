#include "modal/poles/reduced_normal.hpp"

#include <Eigen/Dense>

#include <cmath>

namespace tapfit::modal {
namespace {

using Eigen::Index;

/// Separable power weights nearest to the mean of each row of FRFs: per line
/// and per output.
struct Powers {
  Eigen::VectorXd line;
  Eigen::VectorXd output;
};

Powers separable_powers(const WeightedFrfs& curves, const FrfMatrix& matrix) {
  const auto outputs = static_cast<Index>(matrix.rows.size());
  Eigen::MatrixXd logs(curves.lines(), outputs);
  for (Index o = 0; o < outputs; ++o) {
    const std::vector<Index>& row = matrix.rows[static_cast<std::size_t>(o)];
    // By the mean variance over the references.
    Eigen::ArrayXd variance = Eigen::ArrayXd::Zero(curves.lines());
    for (const Index f : row) {
      variance += curves.weight.col(f).array().square().inverse();
    }
    logs.col(o) = -(variance / static_cast<double>(row.size())).log();
  }
  const Eigen::VectorXd per_output = logs.colwise().mean().transpose();
  const double mean = per_output.mean();
  return {(logs.rowwise().mean().array() - mean).exp(),
          per_output.array().exp()};
}

/// The sums that M is made of. Columns of S: all outputs of the first
/// reference, of the second, and so on.
struct Sums {
  Eigen::MatrixXd R;  ///< lags x 1
  Eigen::MatrixXd S;  ///< lags x (outputs references), largest lag first
  Eigen::MatrixXd T;  ///< lags x references^2
};

Sums make_sums(const WeightedFrfs& curves,
               const FrfMatrix& matrix,
               const BandCircle& circle,
               Index largest) {
  const auto outputs = static_cast<Index>(matrix.rows.size());
  const Index refs = matrix.references;
  const Powers powers = separable_powers(curves, matrix);
  Eigen::MatrixXcd H(curves.lines(), outputs * refs);
  for (Index o = 0; o < outputs; ++o) {
    for (Index i = 0; i < refs; ++i) {
      const Index f =
          matrix.rows[static_cast<std::size_t>(o)][static_cast<std::size_t>(i)];
      H.col(o + i * outputs) = std::sqrt(powers.output(o)) * curves.H.col(f);
    }
  }
  Eigen::MatrixXcd G(curves.lines(), refs * refs);
  for (Index j = 0; j < refs; ++j) {
    for (Index i = 0; i < refs; ++i) {
      G.col(i + j * refs) =
          (H.middleCols(i * outputs, outputs).conjugate())
              .cwiseProduct(H.middleCols(j * outputs, outputs))
              .rowwise()
              .sum();
    }
  }
  Sums sums;
  sums.R = lag_sums(circle, powers.line.cast<std::complex<double>>(), largest);
  sums.S = -lag_sums(circle, powers.line.asDiagonal() * H, largest)
                .colwise()
                .reverse();
  sums.T = lag_sums(circle, powers.line.asDiagonal() * G, largest);
  return sums;
}

/// Block row 0 of M.
Eigen::MatrixXd first_row(const Sums& sums,
                          const Eigen::MatrixXd& z,
                          Index largest,
                          Index refs) {
  const Index outputs = sums.S.cols() / refs;
  Eigen::MatrixXd row(refs, (largest + 1) * refs);
  for (Index j = 0; j <= largest; ++j) {
    // Lags j, j - 1, ... j - largest.
    const auto s = sums.S.middleRows(largest - j, largest + 1);
    for (Index b = 0; b < refs; ++b) {
      for (Index a = 0; a < refs; ++a) {
        row(a, j * refs + b) =
            sums.T(largest + j, a + b * refs) -
            z.middleCols(a * outputs, outputs)
                .cwiseProduct(s.middleCols(b * outputs, outputs))
                .sum();
      }
    }
  }
  return row;
}

/// y' s_j of every output, as outputs x ((largest + 1) references).
Eigen::MatrixXd correlate_columns(const Sums& sums,
                                  const Eigen::VectorXd& y,
                                  Index refs) {
  const Index count = y.size();
  const Index outputs = sums.S.cols() / refs;
  Eigen::MatrixXd shifted = Eigen::MatrixXd::Zero(count, sums.S.rows());
  for (Index j = 0; j < count; ++j) {
    shifted.row(j).segment(count - 1 - j, count) = y.transpose();
  }
  const Eigen::MatrixXd product = shifted * sums.S;
  Eigen::MatrixXd result(outputs, count * refs);
  for (Index j = 0; j < count; ++j) {
    for (Index a = 0; a < refs; ++a) {
      result.col(j * refs + a) =
          product.row(j).segment(a * outputs, outputs).transpose();
    }
  }
  return result;
}

}  // namespace

Eigen::MatrixXd reduced_normal(const WeightedFrfs& curves,
                               const FrfMatrix& matrix,
                               const BandCircle& circle,
                               Index largest) {
  const Index refs = matrix.references;
  const Sums sums = make_sums(curves, matrix, circle, largest);
  Eigen::MatrixXd R(largest + 1, largest + 1);
  for (Index r = 0; r <= largest; ++r) {
    for (Index c = 0; c <= largest; ++c) {
      R(r, c) = sums.R(largest + std::abs(c - r), 0);
    }
  }
  // Numerators that the lines do not determine stay small; R stays Toeplitz.
  R.diagonal() *= 1.0 + 1e-11;
  const Eigen::LLT<Eigen::MatrixXd> factor(R);
  const Eigen::VectorXd x = factor.solve(Eigen::VectorXd::Unit(largest + 1, 0));
  const Eigen::MatrixXd z = factor.solve(sums.S.bottomRows(largest + 1));

  const Eigen::MatrixXd p = correlate_columns(sums, x, refs);
  const Eigen::MatrixXd q = correlate_columns(sums, x.reverse(), refs);
  const Index size = (largest + 1) * refs;
  const Index rest = size - refs;
  Eigen::MatrixXd M(size, size);
  M.topRows(refs) = first_row(sums, z, largest, refs);
  M.bottomLeftCorner(rest, refs) = M.topRightCorner(refs, rest).transpose();
  M.bottomRightCorner(rest, rest).noalias() =
      (q.leftCols(rest).transpose() * q.leftCols(rest) -
       p.rightCols(rest).transpose() * p.rightCols(rest)) /
      x(0);
  for (Index c = refs; c < size; ++c) {
    M.col(c).tail(rest) += M.col(c - refs).head(rest);
  }
  return 0.5 * (M + M.transpose());
}

}  // namespace tapfit::modal
