#include "updating/virtual_test/virtual_points.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "updating/structure/assembly/assemble.hpp"
#include "updating/structure/solve/free_motions.hpp"
#include "updating/structure/solve/system.hpp"

#include <algorithm>
#include <set>

namespace tapfit::updating {
namespace {

Eigen::Vector3d extent_of(const structure::Deck& deck) {
  Eigen::Vector3d low = Eigen::Vector3d::Constant(1e300);
  Eigen::Vector3d high = -low;
  for (const structure::Grid& grid : deck.grids) {
    low = low.cwiseMin(grid.position);
    high = high.cwiseMax(grid.position);
  }
  return high - low;
}

/// How well each grid sees the mode that it sees worst, 0..1.
Eigen::VectorXd visibility(const Eigen::MatrixXd& shapes) {
  const Eigen::RowVectorXd largest = shapes.cwiseAbs().colwise().maxCoeff();
  Eigen::VectorXd worst = Eigen::VectorXd::Ones(shapes.rows());
  for (Eigen::Index mode = 0; mode < shapes.cols(); ++mode) {
    if (!(largest(mode) > 0.0)) continue;
    worst = worst.cwiseMin(shapes.col(mode).cwiseAbs() / largest(mode));
  }
  return worst;
}

double distance(const structure::Deck& deck, std::size_t a, std::size_t b) {
  return (deck.grids[a].position - deck.grids[b].position).norm();
}

// A rounding of the visibility decides no choice between mirror images.
bool clearly_more(double a, double b) { return a > b + 1e-6 * (1.0 + b); }

std::vector<std::size_t> best_seen(const structure::Deck& deck,
                                   const Eigen::VectorXd& seen,
                                   int count) {
  const double apart = extent_of(deck).norm() / 3.0;
  std::vector<std::size_t> chosen;
  while (static_cast<int>(chosen.size()) < count) {
    std::size_t best = deck.grids.size();
    double most = 0.0;
    for (std::size_t k = 0; k < deck.grids.size(); ++k) {
      const bool close =
          std::any_of(chosen.begin(), chosen.end(), [&](std::size_t other) {
            return distance(deck, k, other) < apart;
          });
      const double value = seen(static_cast<Eigen::Index>(k));
      if (!close && clearly_more(value, most)) {
        best = k;
        most = value;
      }
    }
    if (best == deck.grids.size()) break;
    chosen.push_back(best);
  }
  return chosen;
}

std::vector<std::size_t> spread(const structure::Deck& deck,
                                const std::vector<bool>& moves,
                                std::vector<std::size_t> chosen,
                                int count) {
  std::vector<double> nearest(deck.grids.size(), 1e300);
  const auto note = [&](std::size_t point) {
    for (std::size_t k = 0; k < nearest.size(); ++k) {
      nearest[k] = std::min(nearest[k], distance(deck, k, point));
    }
  };
  for (const std::size_t point : chosen) note(point);
  for (std::size_t k = 0; k < moves.size(); ++k) {
    if (!moves[k]) note(k);
  }
  while (static_cast<int>(chosen.size()) < count) {
    std::size_t best = 0;
    for (std::size_t k = 1; k < nearest.size(); ++k) {
      if (clearly_more(nearest[k], nearest[best])) best = k;
    }
    if (!(nearest[best] > 0.0)) break;
    chosen.push_back(best);
    note(best);
  }
  return chosen;
}

}  // namespace

int test_direction(const structure::Deck& deck) {
  const Eigen::Vector3d extent = extent_of(deck);
  Eigen::Index axis = 2;
  const double least = extent.minCoeff(&axis);
  const double tie = 1e-6 * extent.maxCoeff();
  return extent(2) <= least + tie ? 3 : static_cast<int>(axis) + 1;
}

TestPoints choose_points(const structure::Deck& deck,
                         const Eigen::MatrixXd& shapes,
                         int sensors,
                         int count,
                         const std::vector<Dof>& fixed) {
  const int component = test_direction(deck);
  std::vector<bool> moves(deck.grids.size());
  for (std::size_t k = 0; k < moves.size(); ++k) {
    moves[k] = shapes.row(static_cast<Eigen::Index>(k)).cwiseAbs().sum() > 0.0;
  }
  std::vector<std::size_t> seen;
  for (const Dof& dof : fixed) seen.push_back(deck.grid_index(dof.node));
  if (fixed.empty()) seen = best_seen(deck, visibility(shapes), sensors);
  if (seen.empty()) {
    throw InputError("no grid of the model sees every mode of the band",
                     "virtual test",
                     "Choose a narrower band with --band.");
  }
  TestPoints points;
  for (const std::size_t k : seen) {
    points.sensors.push_back({deck.grids[k].id, component, 1});
  }
  for (const std::size_t k : spread(deck, moves, seen, count)) {
    points.others.push_back({deck.grids[k].id, component, 1});
  }
  return points;
}

ModelShapes model_shapes(const structure::Deck& deck,
                         int component,
                         double max_hz) {
  const structure::System system = structure::assemble(deck);
  const structure::FreeMotions motions = structure::free_motions(system);
  const structure::Eigenmodes modes = structure::eigenmodes_up_to(
      motions.reduce(system.K), motions.reduce(system.M), max_hz);
  const Eigen::MatrixXd u = motions.expand(modes.phi);
  // Rigid motion is below any mode of the band that a structure can have.
  const Eigen::Index rigid =
      (modes.frequency_hz.array() < 1e-3 * max_hz).count();
  Eigen::MatrixXd shapes =
      Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(deck.grids.size()),
                            modes.frequency_hz.size() - rigid);
  for (Eigen::Index k = 0; k < shapes.rows(); ++k) {
    shapes.row(k) = u.row(6 * k + component - 1).tail(shapes.cols());
  }
  // A mode that does not move in this direction is not looked for.
  const double overall = shapes.cwiseAbs().maxCoeff();
  std::vector<Eigen::Index> moving;
  for (Eigen::Index mode = 0; mode < shapes.cols(); ++mode) {
    if (shapes.col(mode).cwiseAbs().maxCoeff() > 1e-3 * overall) {
      moving.push_back(mode);
    }
  }
  const Eigen::VectorXd hz = modes.frequency_hz.tail(shapes.cols());
  return {hz(moving), shapes(Eigen::all, moving)};
}

}  // namespace tapfit::updating
