#include "updating/localisation/location_operators.hpp"

#include "updating/effects/joint_cards.hpp"
#include "updating/effects/preload.hpp"
#include "updating/structure/elements/geometric_stiffness.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

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

// Rows of many elements as no more than there are columns, with the same G' G.
class GatheredRows {
 public:
  explicit GatheredRows(Index columns)
      : rows_(0, columns), square_(MatrixXd::Zero(columns, columns)) {}

  void add(const MatrixXd& more) {
    const Index known = rows_.rows();
    rows_.conservativeResize(known + more.rows(), Eigen::NoChange);
    rows_.bottomRows(more.rows()) = more;
    if (rows_.rows() > rows_.cols()) square();
  }
  [[nodiscard]] MatrixXd result() {
    if (square_.isZero(0.0)) return rows_;
    square();
    return strain_rows(square_,
                       MatrixXd::Identity(square_.rows(), square_.cols()));
  }

 private:
  void square() {
    square_ += rows_.transpose() * rows_;
    rows_.resize(0, Eigen::NoChange);
  }

  MatrixXd rows_;
  MatrixXd square_;
};

}  // namespace

LocationOperators::LocationOperators(const FrfModel& model) : model_(&model) {
  const structure::Deck& deck = *model.context().deck;
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

MatrixXd LocationOperators::motion_of(const std::vector<int>& grids) {
  const structure::Deck& deck = *model_->context().deck;
  MatrixXd motions(6 * std::ssize(grids), model_->base().size());
  for (Index k = 0; k < std::ssize(grids); ++k) {
    const std::size_t grid =
        deck.grid_index(grids[static_cast<std::size_t>(k)]);
    const auto [motion, first] = motions_.try_emplace(grid);
    if (first) motion->second = model_->base().rows.rows_of_grid(grid);
    motions.middleRows(6 * k, 6) = motion->second;
  }
  return motions;
}

const structure::ElementMatrices& LocationOperators::element(int id) {
  const auto [it, fresh] = known_.try_emplace(id);
  if (fresh) {
    it->second = matrices_.at(id)();
    it->second.M.resize(0, 0);
  }
  return it->second;
}

MatrixXd LocationOperators::grid(int node, int component) const {
  return model_->row(node, component);
}

MatrixXd LocationOperators::cell(const ElementCell& cell) {
  const int middle = *std::ranges::min_element(cell.elements, {}, [&](int id) {
    return (middles_.at(id) - cell.middle).norm();
  });
  const structure::ElementMatrices& own = element(middle);
  return std::sqrt(static_cast<double>(cell.elements.size())) *
         strain_rows(own.K, motion_of(own.grids));
}

MatrixXd LocationOperators::joint(const Location& where) {
  const JointLine line = effects::joint_at(where, model_->context());
  MatrixXd rows = MatrixXd::Zero(static_cast<Index>(line.grids.size()),
                                 model_->base().size());
  for (std::size_t k = 0; k < line.grids.size(); ++k) {
    const JointGrid& grid = line.grids[k];
    for (const int id : line.side) {
      const structure::ElementMatrices& e = element(id);
      for (std::size_t n = 0; n < e.grids.size(); ++n) {
        if (e.grids[n] != grid.node) continue;
        const Index first = 6 * static_cast<Index>(n) + 3;
        rows.row(static_cast<Index>(k)) += grid.axis.transpose() *
                                           e.K.middleRows(first, 3) *
                                           motion_of(e.grids);
      }
    }
    rows.row(static_cast<Index>(k)) /= std::sqrt(grid.length);
  }
  return rows;
}

MatrixXd LocationOperators::preload(const Location& where) {
  const structure::Deck& deck = *model_->context().deck;
  const Index r = model_->base().size();
  const auto member = effects::member_at(deck, where.elements, where);
  if (!member || !member->can_be_pulled()) return MatrixXd::Zero(0, r);
  const std::set<int> own(where.elements.begin(), where.elements.end());
  GatheredRows all(r);
  const auto add = [&](const structure::GeometricMatrix& e, double factor) {
    if (e.K.isZero(0.0)) return;
    all.add(strain_rows(factor * e.K, motion_of(e.grids)));
  };
  for (const auto& bar : deck.bars) {
    if (own.contains(bar.id)) add(structure::geometric_matrix(deck, bar), 1.0);
  }
  for (const auto& rod : deck.rods) {
    if (own.contains(rod.id)) add(structure::geometric_matrix(deck, rod), 1.0);
  }
  double area = 0.0;
  for (const auto& shell : deck.shells) {
    if (own.contains(shell.id)) {
      area += structure::shell_plane(deck, shell).area;
    }
  }
  const Eigen::Matrix3d N = member->length / std::max(area, 1e-300) *
                            member->axis * member->axis.transpose();
  for (const auto& shell : deck.shells) {
    if (!own.contains(shell.id)) continue;
    add(structure::geometric_matrix(deck, shell, N), 1.0);
  }
  if (const updating::MemberEnd* end = member->pulled()) {
    MatrixXd across = MatrixXd::Zero(6, 6);
    across.topLeftCorner<3, 3>() =
        Eigen::Matrix3d::Identity() - member->axis * member->axis.transpose();
    const auto grids = static_cast<double>(end->grids.size());
    for (const int grid : end->grids) {
      add({{grid}, across}, 1.0 / (member->length * grids));
    }
  }
  return all.result();
}

}  // namespace tapfit::updating
