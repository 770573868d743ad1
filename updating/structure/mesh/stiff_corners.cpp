#include "updating/structure/mesh/stiff_corners.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace tapfit::structure {
namespace {

using Eigen::Vector3d;

// Sine of the angle from which members meet at a corner: those below go on in
// each other, as around a curve.
constexpr double corner_sine = 0.35;

// Of an element, so that something is left that bends.
constexpr double largest_share = 0.9;

Vector3d position(const Deck& deck, int grid) {
  return deck.grids[deck.grid_index(grid)].position;
}

void add_share(std::map<int, double>& shares, int element, double share) {
  double& known = shares[element];
  known = std::min(known + share, largest_share);
}

// A bar as a box: its line, and how far its section reaches from it.
struct Member {
  const Bar* bar = nullptr;
  std::array<Vector3d, 2> ends;
  Vector3d x, y, z;
  double length = 0.0;
  double half_y = 0.0;
  double half_z = 0.0;

  // How far it reaches from its own line along u.
  [[nodiscard]] double reach(const Vector3d& u) const {
    return half_y * std::abs(u.dot(y)) + half_z * std::abs(u.dot(z));
  }
};

std::vector<Member> members(const Deck& deck) {
  std::vector<Member> all;
  for (const Bar& bar : deck.bars) {
    const auto p = deck.bar_properties.find(bar.property);
    if (p == deck.bar_properties.end() || !(p->second.area > 0.0)) continue;
    Member m;
    m.bar = &bar;
    for (std::size_t k = 0; k < 2; ++k) {
      m.ends.at(k) = position(deck, bar.grids.at(k)) + bar.offsets.at(k);
    }
    m.length = (m.ends[1] - m.ends[0]).norm();
    if (!(m.length > 0.0)) continue;
    m.x = (m.ends[1] - m.ends[0]) / m.length;
    m.z = m.x.cross(bar.orientation);
    if (!(m.z.norm() > 0.0)) continue;
    m.z.normalize();
    m.y = m.z.cross(m.x);
    m.half_y = std::sqrt(3.0 * std::max(p->second.I1, 0.0) / p->second.area);
    m.half_z = std::sqrt(3.0 * std::max(p->second.I2, 0.0) / p->second.area);
    all.push_back(m);
  }
  return all;
}

// Where a line of bars leaves a crossing, and how far it runs inside the
// others.
struct Zone {
  int grid = 0;
  const Member* own = nullptr;
  Vector3d from, along;
  double length = 0.0;
  bool in_through = false;  // the others go on at the other side
  std::size_t meeting = 0;  // how many members
};

using Meeting = std::vector<std::pair<const Member*, Vector3d>>;

bool goes_on(const Meeting& meeting, const Vector3d& away) {
  return std::ranges::any_of(meeting, [&](const auto& other) {
    return other.second.dot(away) < 0.0 &&
           other.second.cross(away).norm() < corner_sine;
  });
}

std::vector<Zone> zones(const std::vector<Member>& all) {
  std::map<int, Meeting> at_grid;
  for (const Member& m : all) {
    at_grid[m.bar->grids[0]].emplace_back(&m, m.x);
    at_grid[m.bar->grids[1]].emplace_back(&m, -m.x);
  }
  std::vector<Zone> result;
  for (const auto& [grid, meeting] : at_grid) {
    for (const auto& [own, away] : meeting) {
      if (goes_on(meeting, away)) continue;
      double inside = 0.0;
      bool in_through = false;
      for (const auto& [other, direction] : meeting) {
        const double sine = away.cross(direction).norm();
        if (sine < corner_sine) continue;
        inside = std::max(inside, other->reach(away) / sine);
        in_through = in_through || goes_on(meeting, direction);
      }
      if (inside <= 0.0) continue;
      const bool first = own->bar->grids[0] == grid;
      result.push_back({grid,
                        own,
                        own->ends.at(first ? 0 : 1),
                        away,
                        inside,
                        in_through,
                        meeting.size()});
    }
  }
  return result;
}

// The bars in a zone and their shares of it: finer meshes than the zones are
// long have several in one.
std::vector<std::pair<const Member*, double>> bars_in(
    const Zone& zone, const std::vector<Member>& all) {
  std::vector<std::pair<const Member*, double>> inside;
  for (const Member& m : all) {
    const Vector3d middle = 0.5 * (m.ends[0] + m.ends[1]) - zone.from;
    const double at = middle.dot(zone.along);
    const bool on_line = (middle - at * zone.along).norm() < 1e-3 * m.length &&
                         std::abs(m.x.dot(zone.along)) > 1.0 - 1e-6;
    const double start = at - 0.5 * m.length;
    if (!on_line || start < -1e-6 * m.length || start >= zone.length) continue;
    inside.emplace_back(&m, std::min(zone.length - start, m.length) / m.length);
  }
  return inside;
}

void add_bars(const Deck& deck, std::map<int, double>& shares) {
  const std::vector<Member> all = members(deck);
  for (const Zone& zone : zones(all)) {
    for (const auto& [m, share] : bars_in(zone, all)) {
      add_share(shares, m->bar->id, share);
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

// Material that is there once, or elsewhere: a member that ends inside one that
// goes on, and two that end in each other. These fill a block about the
// crossing, but their lines one quarter of it twice and one not at all.
bool is_misplaced(const Zone& zone) {
  return zone.in_through || zone.meeting == 2;
}

// rho A of a bar [kg/m].
double line_density(const Deck& deck, const Bar& bar) {
  const BarProperty& p = deck.bar_properties.at(bar.property);
  const auto material = deck.materials.find(p.material);
  return material == deck.materials.end() ? 0.0 : material->second.rho * p.area;
}

// The block of two zones at a grid, as heavy as what is taken off their bars.
PointMass corner_block(const Zone& a, const Zone& b, double mass) {
  const Vector3d n = a.along.cross(b.along).normalized();
  Eigen::Matrix3d axes;
  axes << a.along, n.cross(a.along), n;
  const double across = a.own->reach(n) + b.own->reach(n);
  const Vector3d square =
      Vector3d(2.0 * a.length, 2.0 * b.length, across).cwiseAbs2();
  PointMass block;
  block.grid = a.grid;
  block.mass = mass;
  block.inertia =
      axes *
      (mass / 12.0 * (Vector3d::Constant(square.sum()) - square)).asDiagonal() *
      axes.transpose();
  return block;
}

std::vector<PointMass> corner_blocks(const Deck& deck,
                                     const std::map<int, double>& shares) {
  const std::vector<Member> all = members(deck);
  std::map<int, std::vector<Zone>> corners;
  for (const Zone& zone : zones(all)) {
    if (is_misplaced(zone) && !zone.in_through) {
      corners[zone.grid].push_back(zone);
    }
  }
  std::vector<PointMass> blocks;
  for (const auto& [grid, two] : corners) {
    if (two.size() != 2) continue;
    double mass = 0.0;
    for (const Zone& zone : two) {
      for (const auto& [m, share] : bars_in(zone, all)) {
        mass += std::min(share, shares.at(m->bar->id)) * m->length *
                line_density(deck, *m->bar);
      }
    }
    if (mass > 0.0) blocks.push_back(corner_block(two[0], two[1], mass));
  }
  return blocks;
}

// A material with its moduli multiplied, kept by what it was made of.
class Stiffer {
 public:
  explicit Stiffer(Deck& deck) : deck_(&deck) {}

  int material(int id, double factor) {
    if (id == 0) return 0;
    const auto [it, fresh] = made_.try_emplace({id, factor}, 0);
    if (!fresh) return it->second;
    Material m = deck_->materials.at(id);
    for (double* modulus : {&m.E, &m.E2, &m.G, &m.G1z, &m.G2z}) {
      *modulus *= factor;
    }
    m.plane *= factor;
    m.id = it->second = deck_->materials.rbegin()->first + 1;
    deck_->materials[m.id] = m;
    return m.id;
  }

 private:
  Deck* deck_;
  std::map<std::pair<int, double>, int> made_;
};

// Shares that differ by less make no difference.
double factor_of(double share) {
  constexpr double step = 1e-3;
  return 1.0 / (1.0 - step * std::round(share / step));
}

template <class Property>
Property& copied(std::map<int, Property>& properties, int id) {
  Property copy = properties.at(id);
  copy.id = properties.rbegin()->first + 1;
  return properties[copy.id] = copy;
}

}  // namespace

std::map<int, double> inside_corners(const Deck& deck) {
  std::map<int, double> shares;
  add_bars(deck, shares);
  add_shells(deck, shares);
  return shares;
}

std::map<int, double> misplaced_mass(const Deck& deck) {
  const std::vector<Member> all = members(deck);
  std::map<int, double> shares;
  for (const Zone& zone : zones(all)) {
    if (!is_misplaced(zone)) continue;
    for (const auto& [m, share] : bars_in(zone, all)) {
      add_share(shares, m->bar->id, share);
    }
  }
  return shares;
}

Deck with_placed_mass(Deck deck) {
  const std::map<int, double> shares = misplaced_mass(deck);
  std::vector<PointMass> blocks = corner_blocks(deck, shares);
  int id = 0;
  for (const PointMass& mass : deck.masses) id = std::max(id, mass.id);
  for (PointMass& block : blocks) {
    block.id = ++id;
    deck.masses.push_back(std::move(block));
  }
  std::map<std::pair<int, double>, int> bars;
  for (Bar& bar : deck.bars) {
    const auto found = shares.find(bar.id);
    if (found == shares.end()) continue;
    const double left = 1.0 - found->second;
    const auto [it, fresh] = bars.try_emplace({bar.property, left}, 0);
    if (fresh) {
      BarProperty& p = copied(deck.bar_properties, bar.property);
      Material& m = copied(deck.materials, p.material);
      m.rho *= left;
      p.material = m.id;
      it->second = p.id;
    }
    bar.property = it->second;
  }
  return deck;
}

Deck with_stiff_corners(Deck deck, const std::map<int, double>& inside) {
  Stiffer stiffer(deck);
  std::map<std::pair<int, double>, int> bars;
  for (Bar& bar : deck.bars) {
    const auto found = inside.find(bar.id);
    if (found == inside.end()) continue;
    const double factor = factor_of(found->second);
    const auto [it, fresh] = bars.try_emplace({bar.property, factor}, 0);
    if (fresh) {
      BarProperty& p = copied(deck.bar_properties, bar.property);
      p.material = stiffer.material(p.material, factor);
      p.J /= factor;
      it->second = p.id;
    }
    bar.property = it->second;
  }
  std::map<std::pair<int, double>, int> shells;
  for (Shell& shell : deck.shells) {
    const auto found = inside.find(shell.id);
    if (found == inside.end()) continue;
    const double factor = factor_of(found->second);
    const auto [it, fresh] = shells.try_emplace({shell.property, factor}, 0);
    if (fresh) {
      ShellProperty& p = copied(deck.shell_properties, shell.property);
      p.bending = stiffer.material(p.bending, factor);
      it->second = p.id;
    }
    shell.property = it->second;
  }
  return deck;
}

}  // namespace tapfit::structure
