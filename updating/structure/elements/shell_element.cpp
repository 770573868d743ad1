// A shell element in basic axes: local frame, projection of a warped quad onto
// its mean plane by rigid arms, membrane, bending and mass put together.
// Quadratic shells and panels have files of their own.
#include "acquisition/foundation/input_error.hpp"
#include "updating/structure/elements/element_matrices.hpp"
#include "updating/structure/elements/shell_bending.hpp"
#include "updating/structure/elements/shell_mass.hpp"
#include "updating/structure/elements/shell_membrane.hpp"

#include <Eigen/Dense>
#include <fmt/format.h>

namespace tapfit::structure {
namespace {

struct Frame {
  Eigen::Matrix3d axes;    // columns x, y, normal
  Corners xy;              // corners in the mean plane
  Eigen::VectorXd height;  // corners above the mean plane
};

[[noreturn]] void bad_shape(const Deck& deck,
                            const Shell& shell,
                            const std::string& what) {
  throw InputError(
      what,
      card_place(deck, shell.where, fmt::format("shell {}", shell.id)),
      "Check the element's grids: they must go round it in order and enclose "
      "an area, with no corner beyond 180 degrees.");
}

Frame make_frame(const Deck& deck, const Shell& shell) {
  Eigen::MatrixX3d X = deck.position_rows(shell.grids);
  const Eigen::Index n = X.rows();
  const Eigen::RowVector3d centre = X.colwise().mean();
  X.rowwise() -= centre;
  const Eigen::Vector3d d1 = (X.row(n == 4 ? 2 : 1) - X.row(0)).transpose();
  const Eigen::Vector3d d2 =
      (X.row(n == 4 ? 3 : 2) - X.row(n == 4 ? 1 : 0)).transpose();
  const Eigen::Vector3d normal = d1.cross(d2);
  if (!(normal.norm() > 1e-8 * d1.norm() * d2.norm()) || normal.norm() == 0) {
    bad_shape(deck, shell, "the element has no area");
  }
  Frame frame;
  const Eigen::Vector3d z = normal.normalized();
  const Eigen::Vector3d side = (X.row(1) - X.row(0)).transpose();
  const Eigen::Vector3d x = (side - z * z.dot(side)).normalized();
  frame.axes << x, z.cross(x), z;
  frame.xy = X * frame.axes.leftCols<2>();
  frame.height = X * z;
  // Rounding is no warp: it would give rotations a mass of its own size.
  if (frame.height.norm() < 1e-12 * d1.norm()) frame.height.setZero();
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::RowVector2d a = frame.xy.row((i + 1) % n) - frame.xy.row(i);
    const Eigen::RowVector2d b =
        frame.xy.row((i + n - 1) % n) - frame.xy.row(i);
    // A flat corner has stiffness beyond all others and makes them rounding.
    if (!(a.x() * b.y() - a.y() * b.x() > 1e-6 * a.norm() * b.norm())) {
      bad_shape(deck,
                shell,
                "the element is turned in on itself, or flat at a corner");
    }
  }
  return frame;
}

// Local dofs at the projected corners from basic dofs at the grids.
Eigen::MatrixXd transformation(const Frame& frame) {
  const Eigen::Index n = frame.xy.rows();
  Eigen::MatrixXd T = Eigen::MatrixXd::Zero(6 * n, 6 * n);
  const Eigen::Matrix3d R = frame.axes.transpose();
  for (Eigen::Index i = 0; i < n; ++i) {
    T.block<3, 3>(6 * i, 6 * i) = R;
    T.block<3, 3>(6 * i + 3, 6 * i + 3) = R;
    // u - h theta_y, v + h theta_x at a point h below the grid.
    T.block<1, 3>(6 * i, 6 * i + 3) = -frame.height(i) * R.row(1);
    T.block<1, 3>(6 * i + 1, 6 * i + 3) = frame.height(i) * R.row(0);
  }
  return T;
}

// Membrane and bending of a section in which each brings forth the other.
Eigen::MatrixXd coupled_stiffness(const Corners& xy,
                                  const ShellSection& section) {
  const Eigen::Index n = xy.rows();
  const MembraneParts membrane = membrane_parts(xy, section);
  const std::vector<Eigen::MatrixXd> bending = curvatures(xy, section);
  // Membrane, bending, inner modes.
  const Eigen::Index inner = membrane.inner;
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(6 * n + inner, 6 * n + inner);
  K.topLeftCorner(3 * n, 3 * n) = membrane.K.topLeftCorner(3 * n, 3 * n);
  K.topRightCorner(3 * n, inner) = membrane.K.topRightCorner(3 * n, inner);
  K.bottomLeftCorner(inner, 3 * n) = membrane.K.bottomLeftCorner(inner, 3 * n);
  K.bottomRightCorner(inner, inner) =
      membrane.K.bottomRightCorner(inner, inner);
  K.block(3 * n, 3 * n, 3 * n, 3 * n) = bending_stiffness(xy, section);
  const std::vector<GaussPoint> points = gauss_points(n, 2);
  for (std::size_t k = 0; k < points.size(); ++k) {
    const double dA =
        points[k].weight * jacobian(xy, points[k].at).determinant();
    const Eigen::MatrixXd cross =
        dA * membrane.strains[k].transpose() * section.coupling * bending[k];
    K.block(0, 3 * n, 3 * n, 3 * n) += cross.topRows(3 * n);
    K.block(3 * n, 0, 3 * n, 3 * n) += cross.topRows(3 * n).transpose();
    K.block(6 * n, 3 * n, inner, 3 * n) += cross.bottomRows(inner);
    K.block(3 * n, 6 * n, 3 * n, inner) += cross.bottomRows(inner).transpose();
  }
  const Eigen::MatrixXd own = condensed(K, inner);
  // Per grid u, v, theta_z, then w, theta_x, theta_y.
  constexpr std::array<Eigen::Index, 6> place_of{0, 1, 5, 2, 3, 4};
  const auto place = [&](Eigen::Index i) {
    const Eigen::Index part = i / (3 * n);
    return 6 * (i % (3 * n) / 3) +
           place_of.at(static_cast<std::size_t>(3 * part + i % 3));
  };
  Eigen::MatrixXd sorted(6 * n, 6 * n);
  for (Eigen::Index i = 0; i < 6 * n; ++i) {
    for (Eigen::Index j = 0; j < 6 * n; ++j) {
      sorted(place(i), place(j)) = own(i, j);
    }
  }
  return sorted;
}

void add_part(const Eigen::MatrixXd& part,
              const std::array<Eigen::Index, 3>& dofs,
              Eigen::MatrixXd& whole) {
  for (Eigen::Index a = 0; a < part.rows(); ++a) {
    const Eigen::Index row =
        6 * (a / 3) + dofs[static_cast<std::size_t>(a % 3)];
    for (Eigen::Index b = 0; b < part.cols(); ++b) {
      const Eigen::Index col =
          6 * (b / 3) + dofs[static_cast<std::size_t>(b % 3)];
      whole(row, col) += part(a, b);
    }
  }
}

}  // namespace

ElementMatrices shell_matrices(const Deck& deck, const Shell& shell) {
  if (deck.shell_properties.at(shell.property).panel) {
    return panel_matrices(deck, shell);
  }
  return shell_matrices(deck, shell, shell_section(deck, shell));
}

ElementMatrices shell_matrices(const Deck& deck,
                               const Shell& shell,
                               const ShellSection& section) {
  if (!shell.mids.empty()) return quadratic_matrices(deck, shell, section);
  Frame frame = make_frame(deck, shell);
  // The element lies above its grids by the offset.
  frame.height.array() -= shell.offset;
  const Eigen::Index n = frame.xy.rows();
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(6 * n, 6 * n);
  if (section.is_coupled()) {
    K = coupled_stiffness(frame.xy, section);
  } else if (section.membrane.trace() > 0.0) {
    add_part(membrane_stiffness(frame.xy, section), {0, 1, 5}, K);
  }
  if (!section.is_coupled() && section.bending.trace() > 0.0) {
    add_part(bending_stiffness(frame.xy, section), {2, 3, 4}, K);
  }
  const Eigen::MatrixXd M = shell_mass(frame.xy, section, deck.coupled_mass);
  const Eigen::MatrixXd T = transformation(frame);
  return {shell.grids, T.transpose() * K * T, T.transpose() * M * T};
}

}  // namespace tapfit::structure
