// CBAR and CBEAM: Timoshenko beam (Euler-Bernoulli where
// no shear factor is given) with offsets and released components. The
// consistent mass of a CBEAM holds the inertia of its cross sections' rotation;
// that of a CBAR does not, as in Nastran. Of a beam whose axial force acts off
// its shear centre, at r = (0, N1, N2), the ends' axial displacements are those
// there, u + theta x r; its mass is there, too.
//
// Source: J. S. Przemieniecki, Theory of Matrix Structural Analysis, 1968,
// sections 5.6 and 11.4.
#include "acquisition/foundation/input_error.hpp"
#include "updating/structure/elements/bar_axes.hpp"
#include "updating/structure/elements/element_matrices.hpp"

#include <Eigen/Dense>
#include <fmt/format.h>

#include <cmath>

namespace tapfit::structure {
namespace {

using Matrix12 = Eigen::Matrix<double, 12, 12>;

// Deflection and rotation at both ends in one plane, with the sign that turns
// the rotation's right-hand sense into a slope.
struct Plane {
  std::array<Eigen::Index, 4> dof;
  double sign;
};
constexpr Plane plane1{{1, 5, 7, 11}, 1.0};
constexpr Plane plane2{{2, 4, 8, 10}, -1.0};

void add_plane(const Plane& plane,
               const Eigen::Matrix4d& part,
               Matrix12& whole) {
  for (std::size_t a = 0; a < 4; ++a) {
    for (std::size_t b = 0; b < 4; ++b) {
      const double sign =
          (a % 2 == 1 ? plane.sign : 1.0) * (b % 2 == 1 ? plane.sign : 1.0);
      whole(plane.dof[a], plane.dof[b]) +=
          sign *
          part(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b));
    }
  }
}

// How much softer shear makes the deflection than bending alone.
double shear_ratio(double EI, double GAs, double L) {
  return GAs > 0.0 ? 12.0 * EI / (GAs * L * L) : 0.0;
}

Eigen::Matrix4d plane_stiffness(double EI, double GAs, double L) {
  const double phi = shear_ratio(EI, GAs, L);
  Eigen::Matrix4d K;
  K << 12, 6 * L, -12, 6 * L,                               //
      6 * L, (4 + phi) * L * L, -6 * L, (2 - phi) * L * L,  //
      -12, -6 * L, 12, -6 * L,                              //
      6 * L, (2 - phi) * L * L, -6 * L, (4 + phi) * L * L;
  return K * EI / (L * L * L * (1.0 + phi));
}

// Consistent with the deflection of plane_stiffness; `rotary` is rho I L.
Eigen::Matrix4d plane_mass(double m, double rotary, double phi, double L) {
  const double p2 = phi * phi;
  const double a = 13.0 / 35.0 + 0.7 * phi + p2 / 3.0;
  const double b = 9.0 / 70.0 + 0.3 * phi + p2 / 6.0;
  const double c = (11.0 / 210.0 + 11.0 / 120.0 * phi + p2 / 24.0) * L;
  const double d = (13.0 / 420.0 + 3.0 / 40.0 * phi + p2 / 24.0) * L;
  const double e = (1.0 / 105.0 + phi / 60.0 + p2 / 120.0) * L * L;
  const double f = (1.0 / 140.0 + phi / 60.0 + p2 / 120.0) * L * L;
  Eigen::Matrix4d M;
  M << a, c, b, -d,  //
      c, e, d, -f,   //
      b, d, a, -c,   //
      -d, -f, -c, e;
  const double g = (0.1 - 0.5 * phi) * L;
  const double h = (2.0 / 15.0 + phi / 6.0 + p2 / 3.0) * L * L;
  const double k = (1.0 / 30.0 + phi / 6.0 - p2 / 6.0) * L * L;
  Eigen::Matrix4d R;
  R << 1.2, g, -1.2, g,   //
      g, h, -g, -k,       //
      -1.2, -g, 1.2, -g,  //
      g, -k, -g, h;
  return (m * M + rotary / (L * L) * R) / ((1.0 + phi) * (1.0 + phi));
}

void add_pair(Eigen::Index dof, double same, double other, Matrix12& A) {
  A(dof, dof) += same;
  A(dof + 6, dof + 6) += same;
  A(dof, dof + 6) += other;
  A(dof + 6, dof) += other;
}

// Displacements at a place off the shear centre, from those of it.
Matrix12 at_place(const Eigen::Vector2d& r) {
  Matrix12 T = Matrix12::Identity();
  for (const Eigen::Index end : {0, 6}) {
    T(end, end + 4) = r.y();
    T(end, end + 5) = -r.x();
    T(end + 1, end + 3) = -r.y();
    T(end + 2, end + 3) = r.x();
  }
  return T;
}

Matrix12 local_stiffness(const BarProperty& p, const Material& m, double L) {
  Matrix12 K = Matrix12::Zero();
  add_pair(0, m.E * p.area / L, -m.E * p.area / L, K);
  if (!p.neutral.isZero(0.0)) {
    const Matrix12 T = at_place(p.neutral);
    K = (T.transpose() * K * T).eval();
  }
  add_pair(3, m.G * p.J / L, -m.G * p.J / L, K);
  add_plane(plane1, plane_stiffness(m.E * p.I1, p.K1 * m.G * p.area, L), K);
  add_plane(plane2, plane_stiffness(m.E * p.I2, p.K2 * m.G * p.area, L), K);
  return K;
}

// What of a bar's mass is where.
struct Lineal {
  double mass = 0.0;   // [kg/m]
  double polar = 0.0;  // about the axis [kg m]
};

Matrix12 mass_of(const Bar& bar,
                 const BarProperty& p,
                 const Material& m,
                 const Lineal& lineal,
                 double L,
                 bool coupled) {
  const double mass = lineal.mass * L;
  const double polar = lineal.polar * L;
  Matrix12 M = Matrix12::Zero();
  if (!coupled) {
    for (Eigen::Index c = 0; c < 3; ++c) add_pair(c, mass / 2.0, 0.0, M);
    add_pair(3, polar / 2.0, 0.0, M);
    return M;
  }
  add_pair(0, mass / 3.0, mass / 6.0, M);
  add_pair(3, polar / 3.0, polar / 6.0, M);
  if (!bar.rotary_inertia) {
    add_plane(plane1, plane_mass(mass, 0.0, 0.0, L), M);
    add_plane(plane2, plane_mass(mass, 0.0, 0.0, L), M);
    return M;
  }
  // The sections' own inertia goes with the part that has some.
  const double own = lineal.polar > 0.0 ? m.rho * L : 0.0;
  const double phi1 = shear_ratio(m.E * p.I1, p.K1 * m.G * p.area, L);
  const double phi2 = shear_ratio(m.E * p.I2, p.K2 * m.G * p.area, L);
  add_plane(plane1, plane_mass(mass, own * p.I1, phi1, L), M);
  add_plane(plane2, plane_mass(mass, own * p.I2, phi2, L), M);
  return M;
}

Matrix12 local_mass(const Bar& bar,
                    const BarProperty& p,
                    const Material& m,
                    double L,
                    bool coupled) {
  const double polar = bar.rotary_inertia ? m.rho * (p.I1 + p.I2) : 0.0;
  const double inertia = bar.rotary_inertia ? p.nonstructural_inertia : 0.0;
  if (p.neutral.isZero(0.0) && p.nonstructural_at.isZero(0.0)) {
    return mass_of(bar,
                   p,
                   m,
                   {m.rho * p.area + p.nonstructural, polar + inertia},
                   L,
                   coupled);
  }
  const Matrix12 T = at_place(p.neutral);
  const Matrix12 S = at_place(p.nonstructural_at);
  Matrix12 added = mass_of(bar, p, m, {p.nonstructural, 0.0}, L, coupled);
  add_pair(3,
           coupled ? inertia * L / 3.0 : inertia * L / 2.0,
           coupled ? inertia * L / 6.0 : 0.0,
           added);
  return T.transpose() *
             mass_of(bar, p, m, {m.rho * p.area, polar}, L, coupled) * T +
         S.transpose() * added * S;
}

// Released local dofs follow the others statically: T' K T, T' M T.
void release(const Bar& bar, Matrix12& K, Matrix12& M) {
  std::vector<Eigen::Index> free;
  for (Eigen::Index end = 0; end < 2; ++end) {
    for (const char digit : bar.released[static_cast<std::size_t>(end)]) {
      free.push_back(6 * end + digit - '1');
    }
  }
  if (free.empty()) return;
  const Eigen::MatrixXd Krr = K(free, free);
  const Eigen::MatrixXd Kra = K(free, Eigen::all);
  Eigen::MatrixXd follow = -Krr.completeOrthogonalDecomposition().solve(Kra);
  follow(Eigen::all, free).setZero();
  Matrix12 T = Matrix12::Identity();
  T(free, Eigen::all) = follow;
  K = (T.transpose() * K * T).eval();
  M = (T.transpose() * M * T).eval();
}

// Mass that moves along with both ends in each local direction.
Eigen::Vector3d carried(const Matrix12& M) {
  Eigen::Vector3d mass;
  for (Eigen::Index c = 0; c < 3; ++c) {
    mass(c) = M(c, c) + M(c + 6, c + 6) + 2.0 * M(c, c + 6);
  }
  return mass;
}

// Pins at both ends may leave the bar to float: its mass would be lost.
void refuse_loose(const Deck& deck,
                  const Bar& bar,
                  const Eigen::Vector3d& before,
                  const Eigen::Vector3d& after) {
  constexpr double rounding = 1e-6;
  if ((before - after).maxCoeff() <= rounding * before.maxCoeff()) return;
  throw InputError(
      fmt::format("its pins (PA {}, PB {}) let go of the bar, whose mass would "
                  "be lost",
                  bar.released[0],
                  bar.released[1]),
      card_place(deck, bar.where, fmt::format("bar {}", bar.id)),
      "Release each direction at one end only.");
}

// Turns plane 1 and 2 into the section's principal planes.
void make_principal(BarProperty& p, Eigen::Matrix3d& local) {
  if (p.I12 == 0.0) return;
  // Mohr's circle: `angle` leads to the axis of the larger moment.
  const double angle = 0.5 * std::atan2(2.0 * p.I12, p.I1 - p.I2);
  const double mean = 0.5 * (p.I1 + p.I2);
  const double radius = std::hypot(0.5 * (p.I1 - p.I2), p.I12);
  Eigen::Matrix2d V;
  V << -std::sin(angle), -std::cos(angle), std::cos(angle), -std::sin(angle);
  local.rightCols<2>() = (local.rightCols<2>() * V).eval();
  for (Eigen::Vector2d* r : {&p.neutral, &p.nonstructural_at}) {
    *r = (V.transpose() * *r).eval();
  }
  p.I1 = mean - radius;
  p.I2 = mean + radius;
  p.K1 = p.K2 = 0.5 * (p.K1 + p.K2);
}

// Local dofs at the bar's ends from basic dofs at its grids.
Matrix12 transformation(const Bar& bar, const Eigen::Matrix3d& local) {
  Matrix12 T = Matrix12::Zero();
  const Eigen::Matrix3d R = local.transpose();
  for (Eigen::Index end = 0; end < 2; ++end) {
    const Eigen::Vector3d& o = bar.offsets[static_cast<std::size_t>(end)];
    Eigen::Matrix3d cross;
    cross << 0.0, -o.z(), o.y(), o.z(), 0.0, -o.x(), -o.y(), o.x(), 0.0;
    T.block<3, 3>(6 * end, 6 * end) = R;
    T.block<3, 3>(6 * end + 3, 6 * end + 3) = R;
    T.block<3, 3>(6 * end, 6 * end + 3) = -R * cross;
  }
  return T;
}

}  // namespace

ElementMatrices bar_matrices(const Deck& deck, const Bar& bar) {
  BarProperty p = deck.bar_properties.at(bar.property);
  const Material& m = deck.materials.at(p.material);
  BarAxes axes = bar_axes(deck, bar);
  Matrix12 K;
  Matrix12 M;
  if (bar.released[0].empty() && bar.released[1].empty()) {
    make_principal(p, axes.local);  // releases mean the deck's own planes
  }
  K = local_stiffness(p, m, axes.length);
  M = local_mass(bar, p, m, axes.length, deck.coupled_mass);
  const Eigen::Vector3d before = carried(M);
  release(bar, K, M);
  refuse_loose(deck, bar, before, carried(M));
  const Matrix12 T = transformation(bar, axes.local);
  return {{bar.grids[0], bar.grids[1]},
          T.transpose() * K * T,
          T.transpose() * M * T};
}

}  // namespace tapfit::structure
