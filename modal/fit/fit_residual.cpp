#include "modal/fit/fit_residual.hpp"

#include "acquisition/foundation/parallel.hpp"
#include "modal/fit/linear_fit.hpp"
#include "modal/poles/fit_columns.hpp"

#include <algorithm>

namespace tapfit::modal {
namespace {

using Eigen::Index;

constexpr Index lines_at_once = 64;  // what they need stays in the cache

/// Rows of Re and Im of each residue, then of each term: n_columns x n_frfs.
Eigen::MatrixXd coefficients_of(const ModalFit& fit) {
  Eigen::MatrixXcd all(fit.residues.rows(),
                       fit.residues.cols() + fit.terms.cols());
  all << fit.residues, fit.terms;
  Eigen::MatrixXd result(2 * all.cols(), all.rows());
  for (Index c = 0; c < all.cols(); ++c) {
    result.row(2 * c) = all.col(c).real().transpose();
    result.row(2 * c + 1) = all.col(c).imag().transpose();
  }
  return result;
}

/// Calls work(begin, count) for all lines, some at a time, on all cores.
template <typename Work>
void for_lines(const WeightedFrfs& curves,
               const ModalFit& fit,
               const Work& work) {
  const Index chunks = (curves.lines() + lines_at_once - 1) / lines_at_once;
  const double operations =
      8.0 * static_cast<double>(curves.lines() * curves.count() *
                                (fit.poles.size() + fit.terms.cols()));
  for_each_parallel(
      static_cast<std::size_t>(chunks), operations, [&](std::size_t k) {
        const Index begin = static_cast<Index>(k) * lines_at_once;
        work(begin, std::min(lines_at_once, curves.lines() - begin));
      });
}

bool meets(const std::vector<LineRange>& ranges, Index begin, Index count) {
  return std::ranges::any_of(ranges, [&](const LineRange& range) {
    return range.first < begin + count && begin < range.second;
  });
}

}  // namespace

Eigen::MatrixXcd fitted_accelerance(const WeightedFrfs& curves,
                                    const ModalFit& fit,
                                    Index begin,
                                    Index count) {
  return unstack(model_columns(curves, fit.poles, begin, count) *
                 coefficients_of(fit));
}

Eigen::MatrixXcd fitted_accelerance(const WeightedFrfs& curves,
                                    const ModalFit& fit) {
  Eigen::MatrixXcd H(curves.lines(), curves.count());
  const Eigen::MatrixXd coefficients = coefficients_of(fit);
  for_lines(curves, fit, [&](Index begin, Index count) {
    const Eigen::MatrixXd fitted =
        model_columns(curves, fit.poles, begin, count) * coefficients;
    H.middleRows(begin, count).real() = fitted.topRows(count);
    H.middleRows(begin, count).imag() = fitted.bottomRows(count);
  });
  return H;
}

Eigen::VectorXd left_per_line(const WeightedFrfs& curves,
                              const ModalFit& fit,
                              const std::vector<LineRange>& wanted) {
  Eigen::VectorXd power = Eigen::VectorXd::Zero(curves.lines());
  const Eigen::MatrixXd coefficients = coefficients_of(fit);
  const auto& [v, u] = curves.weights;
  for_lines(curves, fit, [&](Index begin, Index count) {
    if (!meets(wanted, begin, count)) return;
    const Eigen::MatrixXd fitted =
        model_columns(curves, fit.poles, begin, count) * coefficients;
    auto sum = power.segment(begin, count);
    for (Index f = 0; f < curves.count(); ++f) {
      const auto H = curves.H.col(f).segment(begin, count);
      sum += u(f) * u(f) *
             ((H.real() - fitted.col(f).head(count)).cwiseAbs2() +
              (H.imag() - fitted.col(f).tail(count)).cwiseAbs2());
    }
    sum = sum.cwiseProduct(v.segment(begin, count).cwiseAbs2()).eval();
  });
  return power;
}

}  // namespace tapfit::modal
