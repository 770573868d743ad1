#include "updating/localisation/place_rows.hpp"

#include "updating/places/joint_line.hpp"
#include "updating/structure/elements/element_matrices.hpp"

#include <Eigen/Eigenvalues>

#include <cmath>

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
  const MatrixXd rows = model.base().rows.all();
  const auto take = [&](int id, const structure::ElementMatrices& e) {
    ElementRows element{e.grids, e.K, {}, {}};
    element.motion.resize(6 * static_cast<Index>(e.grids.size()), rows.cols());
    for (std::size_t k = 0; k < e.grids.size(); ++k) {
      element.motion.middleRows(6 * static_cast<Index>(k), 6) = rows.middleRows(
          6 * static_cast<Index>(deck.grid_index(e.grids[k])), 6);
    }
    element.strain = strain_rows(e.K, element.motion);
    elements_.emplace(id, std::move(element));
  };
  for (const structure::Shell& e : deck.shells) {
    take(e.id, structure::shell_matrices(deck, e));
  }
  for (const structure::Bar& e : deck.bars) {
    take(e.id, structure::bar_matrices(deck, e));
  }
  for (const structure::Rod& e : deck.rods) {
    take(e.id, structure::rod_matrices(deck, e));
  }
  for (const structure::Solid& e : deck.solids) {
    take(e.id, structure::solid_matrices(deck, e));
  }
}

MatrixXd PlaceRows::grid(int node, int component) const {
  return model_->row(node, component);
}

const MatrixXd& PlaceRows::element(int id) const {
  return elements_.at(id).strain;
}

MatrixXd PlaceRows::joint(const Where& where) const {
  const effects::Setting& setting = model_->setting();
  const JointLine line = where.nodes.size() > 1
                             ? shell_joint(*setting.deck, where.nodes)
                             : bar_joint(*setting.deck,
                                         where.nodes.front(),
                                         where.elements,
                                         setting.component);
  MatrixXd rows = MatrixXd::Zero(static_cast<Index>(line.grids.size()),
                                 model_->base().size());
  for (std::size_t k = 0; k < line.grids.size(); ++k) {
    const JointGrid& grid = line.grids[k];
    for (const int id : line.side) {
      const ElementRows& e = elements_.at(id);
      for (std::size_t n = 0; n < e.grids.size(); ++n) {
        if (e.grids[n] != grid.node) continue;
        const Index first = 6 * static_cast<Index>(n) + 3;
        rows.row(static_cast<Index>(k)) +=
            grid.axis.transpose() * e.K.middleRows(first, 3) * e.motion;
      }
    }
    rows.row(static_cast<Index>(k)) /= std::sqrt(grid.length);
  }
  return rows;
}

}  // namespace tapfit::updating
