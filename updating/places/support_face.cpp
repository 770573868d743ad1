#include "updating/places/support_face.hpp"

#include "updating/places/shell_edges.hpp"
#include "updating/structure/elements/bar_axes.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <set>

namespace tapfit::updating {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using structure::Deck;

struct Section {
  double area = 0.0;  // [m^2]
  Matrix3d moments;   // about the centroid [m^4]
  Vector3d centroid;  // from the grid [m]
};

GridMatrix bed_under(const Section& section) {
  const Vector3d& x = section.centroid;
  Matrix3d X;
  X << 0.0, -x.z(), x.y(), x.z(), 0.0, -x.x(), -x.y(), x.x(), 0.0;
  const Matrix3d& C = section.moments;
  GridMatrix S;
  S.topLeftCorner<3, 3>() = section.area * Matrix3d::Identity();
  S.topRightCorner<3, 3>() = -section.area * X;
  S.bottomLeftCorner<3, 3>() = -section.area * X.transpose();
  S.bottomRightCorner<3, 3>() =
      section.area * X.transpose() * X + C.trace() * Matrix3d::Identity() - C;
  return S;
}

Section section_of(const Deck& deck,
                   const structure::Bar& bar,
                   std::size_t end) {
  const structure::BarProperty& p = deck.bar_properties.at(bar.property);
  const Matrix3d axes = structure::bar_axes(deck, bar).local;
  const Vector3d y = axes.col(1);
  const Vector3d z = axes.col(2);
  Section section{p.area, Matrix3d::Zero(), bar.offsets[end]};
  section.moments = p.I1 * y * y.transpose() + p.I2 * z * z.transpose() +
                    p.I12 * (y * z.transpose() + z * y.transpose());
  section.centroid += p.neutral(0) * y + p.neutral(1) * z;
  return section;
}

// Half of an edge.
Section section_of(const Deck& deck,
                   const structure::Shell& shell,
                   double half_edge) {
  const Vector3d normal = normal_of(deck, shell);
  const double t = thickness_of(deck, shell);
  const double inertia = half_edge * t * t * t / 12.0;
  return {half_edge * t,
          inertia * normal * normal.transpose(),
          shell.offset * normal};
}

// Sides of shells between two held grids, with half of each as a section.
template <class Take>
void for_each_edge(const Deck& deck, const std::set<int>& held, Take take) {
  for (const structure::Shell& shell : deck.shells) {
    const std::size_t n = shell.grids.size();
    for (std::size_t k = 0; k < n; ++k) {
      const int a = shell.grids[k];
      const int b = shell.grids[(k + 1) % n];
      if (!held.contains(a) || !held.contains(b)) continue;
      const Vector3d along = deck.grid(b).position - deck.grid(a).position;
      take(a, b, along, section_of(deck, shell, 0.5 * along.norm()));
    }
  }
}

bool holds_all_of(const std::set<int>& held, const structure::Shell& shell) {
  return std::ranges::all_of(shell.grids,
                             [&held](int id) { return held.contains(id); });
}

}  // namespace

std::map<int, GridMatrix> support_face(const Deck& deck,
                                       const std::vector<int>& nodes) {
  const std::set<int> held(nodes.begin(), nodes.end());
  std::map<int, GridMatrix> face;
  const auto add = [&face](int node, const Section& section) {
    const auto known = face.try_emplace(node, GridMatrix::Zero()).first;
    known->second += bed_under(section);
  };
  for (const structure::Bar& bar : deck.bars) {
    const bool first = held.contains(bar.grids[0]);
    const bool last = held.contains(bar.grids[1]);
    if (first && last) return {};
    if (!first && !last) continue;
    const std::size_t end = first ? 0 : 1;
    add(bar.grids[end], section_of(deck, bar, end));
  }
  for (const structure::Shell& shell : deck.shells) {
    if (holds_all_of(held, shell)) return {};
  }
  for_each_edge(
      deck, held, [&](int a, int b, const Vector3d&, const Section& section) {
        add(a, section);
        add(b, section);
      });
  return face;
}

double edges_turn(const Deck& deck, const std::vector<int>& nodes) {
  double turn = 0.0;
  for_each_edge(
      deck,
      {nodes.begin(), nodes.end()},
      [&turn](int, int, const Vector3d& along, const Section& section) {
        const Vector3d d = along.normalized();
        const Matrix3d S = bed_under(section).bottomRightCorner<3, 3>();
        turn += 2.0 * d.dot(S * d);
      });
  return turn;
}

}  // namespace tapfit::updating
