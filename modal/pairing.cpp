#include "modal/pairing.hpp"

#include "modal/mac.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tapfit::modal {
namespace {

using Eigen::Index;

constexpr double kForbidden = 1e3;  // far above any sum of real costs

/// 1 - score, or kForbidden.
Eigen::MatrixXd costs(const Eigen::MatrixXd& likeness,
                      const Eigen::VectorXd& f_measured,
                      const Eigen::VectorXd& f_model,
                      const PairingOptions& options) {
  Eigen::MatrixXd cost =
      Eigen::MatrixXd::Constant(likeness.rows(), likeness.cols(), kForbidden);
  for (Index i = 0; i < cost.rows(); ++i) {
    for (Index k = 0; k < cost.cols(); ++k) {
      if (f_measured(i) <= 0.0 || f_model(k) <= 0.0) continue;
      const double apart = std::abs(std::log(f_model(k) / f_measured(i)));
      if (apart > std::log(options.most_frequency_ratio)) continue;
      if (likeness(i, k) < options.least_mac) continue;
      cost(i, k) = 1.0 - likeness(i, k) + options.frequency_weight * apart;
    }
  }
  return cost;
}

/// One row joins: cheapest chain of changes that ends in a free column. Rows
/// and columns count from 1; owner[0] is the row that looks for a place.
void insert_row(const Eigen::MatrixXd& cost,
                Index row,
                std::vector<double>& u,
                std::vector<double>& v,
                std::vector<Index>& owner) {
  const auto columns = static_cast<std::size_t>(cost.cols());
  std::vector<double> least(columns + 1,
                            std::numeric_limits<double>::infinity());
  std::vector<std::size_t> from(columns + 1, 0);
  std::vector<bool> seen(columns + 1, false);
  owner[0] = row;
  std::size_t at = 0;
  do {
    seen[at] = true;
    const Index r = owner[at];
    double step = std::numeric_limits<double>::infinity();
    std::size_t next = 0;
    for (std::size_t c = 1; c <= columns; ++c) {
      if (seen[c]) continue;
      const double reduced = cost(r - 1, static_cast<Index>(c) - 1) -
                             u[static_cast<std::size_t>(r)] - v[c];
      if (reduced < least[c]) {
        least[c] = reduced;
        from[c] = at;
      }
      if (least[c] < step) {
        step = least[c];
        next = c;
      }
    }
    for (std::size_t c = 0; c <= columns; ++c) {
      if (seen[c]) {
        u[static_cast<std::size_t>(owner[c])] += step;
        v[c] -= step;
      } else {
        least[c] -= step;
      }
    }
    at = next;
  } while (owner[at] != 0);
  for (; at != 0; at = from[at]) owner[at] = owner[from[at]];
}

}  // namespace

std::vector<Index> assign(const Eigen::MatrixXd& cost) {
  std::vector<double> u(static_cast<std::size_t>(cost.rows()) + 1, 0.0);
  std::vector<double> v(static_cast<std::size_t>(cost.cols()) + 1, 0.0);
  std::vector<Index> owner(v.size(), 0);
  for (Index row = 1; row <= cost.rows(); ++row) {
    insert_row(cost, row, u, v, owner);
  }
  std::vector<Index> result(static_cast<std::size_t>(cost.rows()), -1);
  for (std::size_t c = 1; c < owner.size(); ++c) {
    if (owner[c] == 0) continue;
    result[static_cast<std::size_t>(owner[c] - 1)] = static_cast<Index>(c) - 1;
  }
  return result;
}

std::vector<Pair> pair_modes(const Eigen::MatrixXcd& measured,
                             const Eigen::VectorXd& f_measured,
                             const Eigen::MatrixXcd& model,
                             const Eigen::VectorXd& f_model,
                             const PairingOptions& options) {
  std::vector<Pair> pairs;
  if (measured.cols() == 0 || model.cols() == 0) return pairs;
  const Eigen::MatrixXd likeness = mac(measured, model);
  const Eigen::MatrixXd cost = costs(likeness, f_measured, f_model, options);
  const bool wide = cost.rows() <= cost.cols();
  const std::vector<Index> found =
      assign(wide ? cost : Eigen::MatrixXd(cost.transpose()));
  for (std::size_t k = 0; k < found.size(); ++k) {
    const auto index = static_cast<Index>(k);
    const Index i = wide ? index : found[k];
    const Index m = wide ? found[k] : index;
    if (cost(i, m) < kForbidden) pairs.push_back({i, m, likeness(i, m)});
  }
  if (!wide) {
    std::ranges::sort(pairs, {}, &Pair::measured);
  }
  return pairs;
}

}  // namespace tapfit::modal
