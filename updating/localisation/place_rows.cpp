#include "updating/localisation/place_rows.hpp"

#include "updating/effects/joint_cards.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// G with G' G = U' K U, without what the motion U hardly strains.
MatrixXd strain_rows(const MatrixXd& K, const MatrixXd& motion) {
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(K);
  const VectorXd& lambda = solver.eigenvalues();
  const double largest = std::max(lambda(lambda.size() - 1), 1e-300);
  MatrixXd rows(K.rows(), motion.cols());
  Index kept = 0;
  for (Index k = 0; k < lambda.size(); ++k) {
    if (lambda(k) < 1e-10 * largest) continue;
    rows.row(kept++) = std::sqrt(lambda(k)) *
                       (solver.eigenvectors().col(k).transpose() * motion);
  }
  rows.conservativeResize(kept, Eigen::NoChange);
  const double norm = rows.rowwise().norm().maxCoeff();
  Index strained = 0;
  for (Index k = 0; k < kept; ++k) {
    if (rows.row(k).norm() > 1e-5 * norm) rows.row(strained++) = rows.row(k);
  }
  rows.conservativeResize(strained, Eigen::NoChange);
  return rows;
}

}  // namespace

PlaceRows::PlaceRows(const FrfModel& model) : model_(&model) {
  const structure::Deck& deck = *model.setting().deck;
  const auto take = [&](const auto& elements, auto matrices) {
    for (const auto& e : elements) {
      matrices_[e.id] = [&deck, &e, matrices] { return matrices(deck, e); };
      Eigen::Vector3d& middle = middles_[e.id];
      middle.setZero();
      for (const int grid : e.grids) {
        middle += deck.grids[deck.grid_index(grid)].position /
                  static_cast<double>(e.grids.size());
      }
    }
  };
  take(deck.shells, [](const structure::Deck& of, const auto& e) {
    return structure::shell_matrices(of, e);
  });
  take(deck.bars, [](const structure::Deck& of, const auto& e) {
    return structure::bar_matrices(of, e);
  });
  take(deck.rods, [](const structure::Deck& of, const auto& e) {
    return structure::rod_matrices(of, e);
  });
  take(deck.solids, [](const structure::Deck& of, const auto& e) {
    return structure::solid_matrices(of, e);
  });
}

const PlaceRows::ElementRows& PlaceRows::rows_of(int id) {
  const auto [it, fresh] = known_.try_emplace(id);
  ElementRows& element = it->second;
  if (!fresh) return element;
  const structure::Deck& deck = *model_->setting().deck;
  element.own = matrices_.at(id)();
  const std::vector<int>& grids = element.own.grids;
  element.motion.resize(6 * std::ssize(grids), model_->base().size());
  for (Index k = 0; k < std::ssize(grids); ++k) {
    const std::size_t grid =
        deck.grid_index(grids[static_cast<std::size_t>(k)]);
    const auto [motion, first] = motions_.try_emplace(grid);
    if (first) motion->second = model_->base().rows.rows_of_grid(grid);
    element.motion.middleRows(6 * k, 6) = motion->second;
  }
  return element;
}

MatrixXd PlaceRows::grid(int node, int component) const {
  return model_->row(node, component);
}

MatrixXd PlaceRows::cell(const ElementCell& cell) {
  const int middle = *std::ranges::min_element(cell.elements, {}, [&](int id) {
    return (middles_.at(id) - cell.middle).norm();
  });
  const ElementRows& element = rows_of(middle);
  return std::sqrt(static_cast<double>(cell.elements.size())) *
         strain_rows(element.own.K, element.motion);
}

MatrixXd PlaceRows::joint(const Where& where) {
  const JointLine line = effects::joint_at(where, model_->setting());
  MatrixXd rows = MatrixXd::Zero(static_cast<Index>(line.grids.size()),
                                 model_->base().size());
  for (std::size_t k = 0; k < line.grids.size(); ++k) {
    const JointGrid& grid = line.grids[k];
    for (const int id : line.side) {
      const ElementRows& e = rows_of(id);
      for (std::size_t n = 0; n < e.own.grids.size(); ++n) {
        if (e.own.grids[n] != grid.node) continue;
        const Index first = 6 * static_cast<Index>(n) + 3;
        rows.row(static_cast<Index>(k)) +=
            grid.axis.transpose() * e.own.K.middleRows(first, 3) * e.motion;
      }
    }
    rows.row(static_cast<Index>(k)) /= std::sqrt(grid.length);
  }
  return rows;
}

}  // namespace tapfit::updating
