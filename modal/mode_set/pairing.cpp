#include "modal/mode_set/pairing.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "modal/mode_set/mac.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace tapfit::modal {
namespace {

using Eigen::Index;

constexpr double forbidden = 1e3;  // far above any sum of real costs

/// 1 - score, or forbidden.
Eigen::MatrixXd costs(const Eigen::MatrixXd& likeness,
                      const Eigen::VectorXd& f_measured,
                      const Eigen::VectorXd& f_model,
                      const PairingOptions& options) {
  Eigen::MatrixXd cost =
      Eigen::MatrixXd::Constant(likeness.rows(), likeness.cols(), forbidden);
  for (Index i = 0; i < cost.rows(); ++i) {
    for (Index k = 0; k < cost.cols(); ++k) {
      if (f_measured(i) <= 0.0 || f_model(k) <= 0.0) continue;
      const double apart = std::abs(std::log(f_model(k) / f_measured(i)));
      if (apart > std::log(options.most_frequency_ratio)) continue;
      if (likeness(i, k) < options.least_mac) continue;
      const double score = likeness(i, k) - options.frequency_weight * apart;
      if (score > 0.0) cost(i, k) = 1.0 - score;
    }
  }
  return cost;
}

void check(const std::vector<Pair>& by_hand, Index measured, Index model) {
  for (std::size_t k = 0; k < by_hand.size(); ++k) {
    const Pair& pair = by_hand[k];
    const bool exists = pair.measured >= 0 && pair.measured < measured &&
                        pair.model >= -1 && pair.model < model;
    const auto clash = [&](const Pair& other) {
      return other.measured == pair.measured ||
             (pair.model >= 0 && other.model == pair.model);
    };
    const auto end = by_hand.begin() + static_cast<std::ptrdiff_t>(k);
    if (exists && std::none_of(by_hand.begin(), end, clash)) continue;
    throw InputError(
        fmt::format("measured mode {} cannot be paired with {}",
                    pair.measured + 1,
                    pair.model + 1),
        "pairs set by hand",
        exists
            ? std::string("each mode can have one partner")
            : fmt::format(
                  "there are {} measured and {} other modes", measured, model));
  }
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
    if (next == 0) return;  // no column is left
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
  return pair_modes(measured, f_measured, model, f_model, options, {});
}

std::vector<Pair> pair_modes(const Eigen::MatrixXcd& measured,
                             const Eigen::VectorXd& f_measured,
                             const Eigen::MatrixXcd& model,
                             const Eigen::VectorXd& f_model,
                             const PairingOptions& options,
                             const std::vector<Pair>& by_hand) {
  std::vector<Pair> pairs;
  check(by_hand, measured.cols(), model.cols());
  if (measured.cols() == 0 || model.cols() == 0) return pairs;
  const bool shapes = measured.rows() > 0;
  Eigen::MatrixXd likeness =
      shapes ? mac(measured, model)
             : Eigen::MatrixXd::Ones(measured.cols(), model.cols());
  // Where no point moves, the frequency counts alone.
  for (Index i = 0; shapes && i < measured.cols(); ++i) {
    if (measured.col(i).isZero(0.0)) likeness.row(i).setOnes();
  }
  Eigen::MatrixXd cost = costs(likeness, f_measured, f_model, options);
  for (const Pair& pair : by_hand) {
    cost.row(pair.measured).setConstant(forbidden);
    if (pair.model < 0) continue;
    cost.col(pair.model).setConstant(forbidden);
    pairs.push_back(
        {pair.measured, pair.model, likeness(pair.measured, pair.model)});
  }
  const bool wide = cost.rows() <= cost.cols();
  const std::vector<Index> found =
      assign(wide ? cost : Eigen::MatrixXd(cost.transpose()));
  for (std::size_t k = 0; k < found.size(); ++k) {
    if (found[k] < 0) continue;
    const auto index = static_cast<Index>(k);
    const Index i = wide ? index : found[k];
    const Index m = wide ? found[k] : index;
    if (cost(i, m) < forbidden) pairs.push_back({i, m, likeness(i, m)});
  }
  for (Pair& pair : pairs) {
    if (!shapes || measured.col(pair.measured).isZero(0.0)) pair.mac = 0.0;
  }
  std::ranges::sort(pairs, {}, &Pair::measured);
  return pairs;
}

}  // namespace tapfit::modal
