#include "updating/places/rigid_fit.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/SVD>

#include <algorithm>
#include <array>
#include <cmath>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;

// Directions in which points scatter, most last; right-handed.
Matrix3d principal_axes(const Matrix3Xd& x) {
  const Matrix3Xd centred = x.colwise() - x.rowwise().mean();
  Matrix3d axes = Eigen::SelfAdjointEigenSolver<Matrix3d>(
                      Matrix3d(centred * centred.transpose()))
                      .eigenvectors();
  if (axes.determinant() < 0.0) axes.col(0) = -axes.col(0);
  return axes;
}

// All rotations that take axes to axes.
std::vector<Matrix3d> quarter_turns() {
  std::vector<Matrix3d> turns;
  std::array<Index, 3> order{0, 1, 2};
  do {
    for (int signs = 0; signs < 8; ++signs) {
      Matrix3d turn = Matrix3d::Zero();
      for (std::size_t i = 0; i < 3; ++i) {
        turn(order[i], static_cast<Index>(i)) = (signs >> i) % 2 == 0 ? 1 : -1;
      }
      if (turn.determinant() > 0.0) turns.push_back(turn);
    }
  } while (std::next_permutation(order.begin(), order.end()));
  return turns;
}

Matrix3Xd grids_of(const structure::Deck& deck) {
  Matrix3Xd x(3, static_cast<Index>(deck.grids.size()));
  Index count = 0;
  for (const structure::Grid& grid : deck.grids) {
    if (!grid.scalar && grid.id > 0) x.col(count++) = grid.position;
  }
  x.conservativeResize(3, count);
  return x;
}

Matrix3Xd laid(const RigidFit& fit, const Matrix3Xd& points) {
  return (fit.rotation * points).colwise() + fit.translation;
}

Matrix3Xd feet_of(const Matrix3Xd& points, const MeshSurface& surface) {
  Matrix3Xd feet = points;
  for (Index k = 0; k < points.cols(); ++k) {
    if (const auto place = surface.nearest(points.col(k))) {
      feet.col(k) = place->foot;
    }
  }
  return feet;
}

Matrix3Xd nearest_grids(const Matrix3Xd& points, const Matrix3Xd& grids) {
  Matrix3Xd nearest = points;
  for (Index k = 0; k < points.cols(); ++k) {
    Index best = 0;
    (grids.colwise() - points.col(k)).colwise().squaredNorm().minCoeff(&best);
    nearest.col(k) = grids.col(best);
  }
  return nearest;
}

// Steps until none helps.
template <class Nearest>
RigidFit settled(RigidFit fit,
                 const Matrix3Xd& points,
                 int steps,
                 const Nearest& nearest) {
  for (int step = 0; step < steps; ++step) {
    const RigidFit next = fit_pairs(points, nearest(laid(fit, points)));
    const bool done = step > 0 && next.rms > fit.rms * (1.0 - 1e-6);
    if (!done || next.rms < fit.rms) fit = next;
    if (done) break;
  }
  return fit;
}

double mesh_size(const Matrix3Xd& points, const MeshSurface& surface) {
  double sum = 0.0;
  for (Index k = 0; k < points.cols(); ++k) {
    const auto place = surface.nearest(points.col(k));
    if (place) sum += place->size;
  }
  return points.cols() > 0 ? sum / static_cast<double>(points.cols()) : 0.0;
}

RigidFit unmoved(const Matrix3Xd& points, const MeshSurface& surface) {
  RigidFit fit;
  fit.rms = std::sqrt(
      (feet_of(points, surface) - points).colwise().squaredNorm().mean());
  return fit;
}

double largest_move(const RigidFit& a,
                    const RigidFit& b,
                    const Matrix3Xd& points) {
  return (laid(a, points) - laid(b, points)).colwise().norm().maxCoeff();
}

}  // namespace

bool on_a_line(const Matrix3Xd& points) {
  constexpr double straight = 1e-3;
  if (points.cols() < 3) return true;
  const Vector3d spread =
      Eigen::JacobiSVD<Matrix3Xd>(points.colwise() - points.rowwise().mean())
          .singularValues();
  return !(spread(1) > straight * spread(0));
}

RigidFit fit_pairs(const Matrix3Xd& from, const Matrix3Xd& to) {
  const Eigen::Matrix4d plain = Eigen::umeyama(from, to, false);
  const Eigen::Matrix4d scaled = Eigen::umeyama(from, to, true);
  RigidFit fit;
  fit.rotation = plain.topLeftCorner<3, 3>();
  fit.translation = plain.topRightCorner<3, 1>();
  fit.scale = scaled.topLeftCorner<3, 1>().norm();
  const Matrix3d larger = scaled.topLeftCorner<3, 3>();
  const Vector3d moved = scaled.topRightCorner<3, 1>();
  fit.scaled_rms = std::sqrt((((larger * from).colwise() + moved) - to)
                                 .colwise()
                                 .squaredNorm()
                                 .mean());
  fit.rms = std::sqrt((laid(fit, from) - to).colwise().squaredNorm().mean());
  fit.determined = !on_a_line(from) && !on_a_line(to);
  return fit;
}

std::optional<RigidFit> as_they_are(const Matrix3Xd& points,
                                    const MeshSurface& surface,
                                    const BestFitOptions& options) {
  const RigidFit fit = unmoved(points, surface);
  if (fit.rms > options.on_mesh * mesh_size(points, surface)) return {};
  return fit;
}

std::vector<RigidFit> fit_to_mesh(const Matrix3Xd& points,
                                  const structure::Deck& deck,
                                  const MeshSurface& surface,
                                  const BestFitOptions& options) {
  const Matrix3Xd grids = grids_of(deck);
  if (grids.cols() == 0 || points.cols() == 0) return {};
  const double size = mesh_size(points, surface);
  std::vector<RigidFit> starts{unmoved(points, surface)};
  const Matrix3d of_points = principal_axes(points);
  const Matrix3d of_grids = principal_axes(grids);
  for (const Matrix3d& turn : quarter_turns()) {
    RigidFit start;
    start.rotation = of_grids * turn * of_points.transpose();
    start.translation =
        grids.rowwise().mean() - start.rotation * points.rowwise().mean();
    starts.push_back(start);
  }
  std::vector<RigidFit> fits;
  for (const RigidFit& start : starts) {
    fits.push_back(
        settled(start, points, options.steps, [&grids](const Matrix3Xd& x) {
          return nearest_grids(x, grids);
        }));
  }
  std::ranges::stable_sort(fits, {}, &RigidFit::rms);
  std::vector<RigidFit> ways;
  for (const RigidFit& fit : fits) {
    const bool far = !ways.empty() && fit.rms > ways.front().rms + size;
    if (far) break;
    const RigidFit fine =
        settled(fit, points, options.steps, [&surface](const Matrix3Xd& x) {
          return feet_of(x, surface);
        });
    const bool known = std::ranges::any_of(ways, [&](const RigidFit& way) {
      return largest_move(way, fine, points) < 0.5 * size;
    });
    if (!known) ways.push_back(fine);
  }
  std::ranges::stable_sort(ways, {}, &RigidFit::rms);
  const double limit =
      options.as_good_factor * ways.front().rms + options.as_good_size * size;
  std::erase_if(ways, [limit](const RigidFit& way) { return way.rms > limit; });
  return ways;
}

}  // namespace tapfit::updating
