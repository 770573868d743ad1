#include "updating/places/parted_grids.hpp"

#include "updating/places/crack_line.hpp"
#include "updating/places/joint_line.hpp"
#include "updating/structure/deck/constraint_axes.hpp"

#include <Eigen/Geometry>

namespace tapfit::updating {
namespace {

using Eigen::Vector3d;
using structure::Deck;

Parting turns(int node, const Vector3d& axis, double held) {
  Parting::Motion motion;
  motion << Vector3d::Zero(), axis;
  return {{{node, motion}}, held};
}

Cut crack_of(const Deck& deck, const Location& where) {
  CrackLine crack = crack_line(deck, where.nodes);
  Cut cut{{}, std::move(crack.side)};
  for (const PartedGrid& grid : crack.grids) {
    for (const Vector3d& axis : grid.axes) {
      Parting::Motion motion;
      motion << axis, Vector3d::Zero();
      cut.partings.push_back({{{grid.node, motion}}, grid.area});
    }
    cut.partings.push_back(turns(grid.node, grid.axes[0], grid.turn));
    cut.partings.push_back(turns(grid.node, grid.axes[1], grid.turn));
  }
  return cut;
}

// Of a point at r from a hub that moves by one along a component, as far as it
// follows.
Parting::Motion follows(const Vector3d& r,
                        int component,
                        const std::string& components) {
  const Vector3d axis = Vector3d::Unit((component - 1) % 3);
  Parting::Motion motion;
  if (component > 3) {
    motion << axis.cross(r), axis;
  } else {
    motion << axis, Vector3d::Zero();
  }
  for (int c = 0; c < 6; ++c) {
    const auto digit = static_cast<char>('1' + c);
    if (components.find(digit) == std::string::npos) motion(c) = 0.0;
  }
  return motion;
}

}  // namespace

Cut cut_at(const structure::RefinedDeck& mesh,
           const Location& where,
           int component) {
  if (where.variant == crack) return crack_of(mesh.deck, where);
  JointLine joint = where.nodes.size() > 1
                        ? shell_joint(mesh.deck, where.nodes)
                        : bar_joint(mesh.deck,
                                    where.nodes.front(),
                                    mesh.pieces_of(where.elements),
                                    component);
  Cut cut{{}, std::move(joint.side)};
  for (const JointGrid& grid : joint.grids) {
    cut.partings.push_back(turns(grid.node, grid.axis, grid.length));
  }
  return cut;
}

Cut hub_let_go(const Deck& deck, const std::vector<SupportPart>& parts) {
  Cut cut;
  for (std::size_t part = 0; part < parts.size(); ++part) {
    for (const SupportDof& dof : parts[part].line.dofs) {
      const Vector3d hub = deck.grid(dof.node).position;
      Parting moves{{}, dof.length, part};
      moves.moves.emplace_back(
          dof.node, follows(Vector3d::Zero(), dof.component, "123456"));
      for (const structure::RigidElement& e : deck.rigids) {
        if (e.independent != dof.node) continue;
        for (const structure::Dependent& d : e.dependents) {
          const structure::Grid& grid = deck.grid(d.grid);
          const auto along = structure::along_basic(d.components, grid.axes);
          moves.moves.emplace_back(d.grid,
                                   follows(grid.position - hub,
                                           dof.component,
                                           along.value_or(d.components)));
        }
      }
      cut.partings.push_back(std::move(moves));
    }
  }
  return cut;
}

}  // namespace tapfit::updating
