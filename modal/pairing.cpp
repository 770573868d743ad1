#include "modal/pairing.hpp"

#include "modal/mac.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tapfit::modal {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Shortest augmenting paths with potentials; rows and columns count from 1,
// row 0 and column 0 stand for "not yet assigned".
std::vector<Index> assign(const MatrixXd& cost) {
  const Index p = cost.rows();
  const Index q = cost.cols();
  VectorXd u = VectorXd::Zero(p + 1);
  VectorXd v = VectorXd::Zero(q + 1);
  std::vector<Index> row_of(static_cast<std::size_t>(q + 1), 0);
  for (Index i = 1; i <= p; ++i) {
    std::vector<Index> way(static_cast<std::size_t>(q + 1), 0);
    std::vector<bool> used(static_cast<std::size_t>(q + 1), false);
    VectorXd least =
        VectorXd::Constant(q + 1, std::numeric_limits<double>::max());
    row_of[0] = i;
    Index at = 0;
    do {
      used[static_cast<std::size_t>(at)] = true;
      const Index row = row_of[static_cast<std::size_t>(at)];
      double delta = std::numeric_limits<double>::max();
      Index next = 0;
      for (Index j = 1; j <= q; ++j) {
        if (used[static_cast<std::size_t>(j)]) continue;
        const double reduced = cost(row - 1, j - 1) - u(row) - v(j);
        if (reduced < least(j)) {
          least(j) = reduced;
          way[static_cast<std::size_t>(j)] = at;
        }
        if (least(j) < delta) {
          delta = least(j);
          next = j;
        }
      }
      for (Index j = 0; j <= q; ++j) {
        if (used[static_cast<std::size_t>(j)]) {
          u(row_of[static_cast<std::size_t>(j)]) += delta;
          v(j) -= delta;
        } else {
          least(j) -= delta;
        }
      }
      at = next;
    } while (row_of[static_cast<std::size_t>(at)] != 0);
    while (at != 0) {
      const Index before = way[static_cast<std::size_t>(at)];
      row_of[static_cast<std::size_t>(at)] =
          row_of[static_cast<std::size_t>(before)];
      at = before;
    }
  }
  std::vector<Index> column(static_cast<std::size_t>(p), 0);
  for (Index j = 1; j <= q; ++j) {
    const Index row = row_of[static_cast<std::size_t>(j)];
    if (row > 0) column[static_cast<std::size_t>(row - 1)] = j - 1;
  }
  return column;
}

std::vector<Pair> pair_modes(const MatrixXcd& measured,
                             const VectorXd& measured_hz,
                             const MatrixXcd& model,
                             const VectorXd& model_hz,
                             const PairingOptions& options) {
  std::vector<Pair> pairs;
  if (measured.cols() == 0 || model.cols() == 0) return pairs;
  const MatrixXd shapes = mac(measured, model);
  MatrixXd score(measured.cols(), model.cols());
  for (Index i = 0; i < score.rows(); ++i) {
    for (Index j = 0; j < score.cols(); ++j) {
      const double off =
          (model_hz(j) - measured_hz(i)) /
          (options.frequency_tolerance * std::max(measured_hz(i), 1e-12));
      score(i, j) = shapes(i, j) * std::exp(-0.5 * off * off);
    }
  }
  const bool wide = score.rows() <= score.cols();
  const MatrixXd cost = wide ? MatrixXd(-score) : MatrixXd(-score.transpose());
  const std::vector<Index> column = assign(cost);
  for (std::size_t k = 0; k < column.size(); ++k) {
    const auto row = static_cast<Index>(k);
    const Pair pair = wide ? Pair{row, column[k]} : Pair{column[k], row};
    if (shapes(pair.measured, pair.model) >= options.least_mac) {
      pairs.push_back(pair);
    }
  }
  std::sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) {
    return a.measured < b.measured;
  });
  return pairs;
}

}  // namespace tapfit::modal
