#include "updating/structure/mesh/stiff_corners.hpp"

#include "updating/structure/mesh/member_corners.hpp"
#include "updating/structure/mesh/property_copies.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace tapfit::structure {
namespace {

using Eigen::Vector3d;

Vector3d position(const Deck& deck, int grid) {
  return deck.grids[deck.grid_index(grid)].position;
}

void add_share(std::map<int, double>& shares, int element, double share) {
  double& known = shares[element];
  known = std::min(known + share, largest_share);
}

void add_bars(const Deck& deck, std::map<int, double>& shares) {
  const MemberCorners corners = member_corners(deck);
  for (const CornerEnd& end : corners.ends) {
    for (const auto& [member, share] : end.inside) {
      add_share(shares, deck.bars[corners.members[member].bar].id, share);
    }
  }
}

// A shell with its normal, area and thickness.
struct Sheet {
  const Shell* shell = nullptr;
  Vector3d normal;
  double area = 0.0;
  double thickness = 0.0;
};

void add_shells(const Deck& deck, std::map<int, double>& shares) {
  std::map<std::pair<int, int>, std::vector<Sheet>> along;
  for (const Shell& shell : deck.shells) {
    const auto p = deck.shell_properties.find(shell.property);
    if (p == deck.shell_properties.end() || p->second.bending == 0) continue;
    const std::vector<int>& g = shell.grids;
    const std::size_t n = g.size();
    if (n < 3) continue;
    Vector3d twice = Vector3d::Zero();  // the area's vector
    const Vector3d first = position(deck, g[0]);
    for (std::size_t k = 1; k + 1 < n; ++k) {
      twice += (position(deck, g[k]) - first)
                   .cross(position(deck, g[k + 1]) - first);
    }
    if (!(twice.norm() > 0.0)) continue;
    const double t =
        shell.thickness > 0.0 ? shell.thickness : p->second.thickness;
    const Sheet sheet{&shell, twice.normalized(), 0.5 * twice.norm(), t};
    for (std::size_t k = 0; k < n; ++k) {
      along[std::minmax(g[k], g[(k + 1) % n])].push_back(sheet);
    }
  }
  for (const auto& [edge, sheets] : along) {
    const double length =
        (position(deck, edge.first) - position(deck, edge.second)).norm();
    for (const Sheet& own : sheets) {
      double inside = 0.0;
      for (const Sheet& other : sheets) {
        const double sine = own.normal.cross(other.normal).norm();
        if (sine < corner_sine) continue;
        inside = std::max(inside, 0.5 * other.thickness / sine);
      }
      const double width = own.area / length;
      if (inside > 0.0) {
        add_share(shares, own.shell->id, std::min(inside / width, 1.0));
      }
    }
  }
}

// A material with its moduli multiplied, kept by what it was made of.
class Stiffer {
 public:
  explicit Stiffer(Deck& deck) : deck_(&deck) {}

  int material(int id, double factor) {
    if (id == 0) return 0;
    return made_.of(id, factor, [&](int plain) {
      Material& m = copied(deck_->materials, plain);
      for (double* modulus : {&m.E, &m.E2, &m.G, &m.G1z, &m.G2z}) {
        *modulus *= factor;
      }
      m.plane *= factor;
      return m.id;
    });
  }

 private:
  Deck* deck_;
  PropertyCopies made_;
};

// Shares that differ by less make no difference.
double factor_of(double share) {
  constexpr double step = 1e-3;
  return 1.0 / (1.0 - step * std::round(share / step));
}

}  // namespace

std::map<int, double> inside_corners(const Deck& deck) {
  std::map<int, double> shares;
  add_bars(deck, shares);
  add_shells(deck, shares);
  return shares;
}

Deck with_stiff_corners(Deck deck, const std::map<int, double>& inside) {
  Stiffer stiffer(deck);
  PropertyCopies bars;
  for (Bar& bar : deck.bars) {
    const auto found = inside.find(bar.id);
    if (found == inside.end()) continue;
    const double factor = factor_of(found->second);
    bar.property = bars.of(bar.property, factor, [&](int property) {
      BarProperty& p = copied(deck.bar_properties, property);
      p.material = stiffer.material(p.material, factor);
      p.J /= factor;
      return p.id;
    });
  }
  PropertyCopies shells;
  for (Shell& shell : deck.shells) {
    const auto found = inside.find(shell.id);
    if (found == inside.end()) continue;
    const double factor = factor_of(found->second);
    shell.property = shells.of(shell.property, factor, [&](int property) {
      ShellProperty& p = copied(deck.shell_properties, property);
      p.bending = stiffer.material(p.bending, factor);
      return p.id;
    });
  }
  return deck;
}

}  // namespace tapfit::structure
