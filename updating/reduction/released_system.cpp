#include "updating/reduction/released_system.hpp"

#include "updating/effects/preload.hpp"
#include "updating/places/held_support.hpp"
#include "updating/places/parted_grids.hpp"
#include "updating/places/support_groups.hpp"
#include "updating/places/support_line.hpp"
#include "updating/reduction/massless_dofs.hpp"

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using structure::BorderedMatrix;
using structure::Deck;
using structure::RefinedDeck;
using structure::SparseMatrix;
using Triplets = std::vector<Eigen::Triplet<double>>;

int dof_index(const Deck& deck, int node, int component) {
  return 6 * static_cast<int>(deck.grid_index(node)) + component - 1;
}

// Of the largest pull on a support: a spring there would do nothing. What turns
// may drag along what is not pulled at before it does.
constexpr double little = 1e-6;

double largest_pull(const Deck& deck,
                    const SupportLine& line,
                    const Eigen::VectorXd& pulled) {
  double largest = 0.0;
  if (pulled.size() == 0) return largest;
  for (const SupportDof& dof : line.dofs) {
    if (dof.component > 3) continue;
    largest =
        std::max(largest, pulled(dof_index(deck, dof.node, dof.component)));
  }
  return largest;
}

// Springs of unit stiffness per metre on the released degrees of freedom: on
// the support's own grids and those between them. One list per parameter.
std::vector<Triplets> support_springs(const Deck& deck,
                                      const StiffnessChange& change,
                                      const Eigen::VectorXd& pulled) {
  const Location& where = change.of.where;
  const std::set<int> wanted(where.nodes.begin(), where.nodes.end());
  std::vector<int> nodes;
  for (const std::vector<int>& group : support_groups(deck)) {
    const bool inside = std::any_of(
        group.begin(), group.end(), [&](int n) { return wanted.contains(n); });
    if (inside) nodes.insert(nodes.end(), group.begin(), group.end());
  }
  std::vector<Triplets> springs;
  for (const SupportPart& part : support_parts(deck, nodes, where.variant)) {
    springs.emplace_back();
    const double least = little * largest_pull(deck, part.line, pulled);
    const auto stays = [&](int component, int index) {
      return component <= 3 && pulled.size() > 0 && pulled(index) < least;
    };
    for (const SupportDof& dof : part.line.dofs) {
      const int index = dof_index(deck, dof.node, dof.component);
      if (stays(dof.component, index)) continue;
      if (dof.with == 0) {
        springs.back().emplace_back(index, index, dof.length);
        continue;
      }
      const int other = dof_index(deck, dof.node, dof.with);
      if (stays(dof.with, other)) continue;
      springs.back().emplace_back(index, other, dof.length);
      springs.back().emplace_back(other, index, dof.length);
    }
  }
  return springs;
}

SparseMatrix with_rows(SparseMatrix A, Index rows) {
  A.conservativeResize(rows, A.cols());
  return A;
}

// What the columns of a joint add to a matrix: [0, A_B T; sym, T' A_B T].
// @param AT A_B T
SparseMatrix joint_border(const SparseMatrix& AT, const SparseMatrix& T) {
  const Index n = T.rows();
  const Index m = T.cols();
  Triplets all;
  const auto put = [&all](const SparseMatrix& B, Index row, Index column) {
    for (Index c = 0; c < B.outerSize(); ++c) {
      for (SparseMatrix::InnerIterator it(B, c); it; ++it) {
        all.emplace_back(static_cast<int>(row + it.row()),
                         static_cast<int>(column + it.col()),
                         it.value());
      }
    }
  };
  put(AT, 0, n);
  put(SparseMatrix(AT.transpose()), n, 0);
  put(SparseMatrix(T.transpose() * AT), n, n);
  SparseMatrix border(n + m, n + m);
  border.setFromTriplets(all.begin(), all.end());
  return border;
}

// A_B T, A_B over the first of T's degrees of freedom.
SparseMatrix forces_of(const SparseMatrix& side, const SparseMatrix& T) {
  const SparseMatrix known = T.topRows(side.rows());
  return with_rows(side * known, T.rows());
}

// A matrix of some elements with the columns of a joint behind it.
SparseMatrix with_joint(SparseMatrix A,
                        const SparseMatrix& side,
                        const SparseMatrix& T) {
  const SparseMatrix border = joint_border(forces_of(side, T), T);
  A.conservativeResize(border.rows(), border.cols());
  return A + border;
}

// A part that the side has not is nothing there.
std::vector<UncertainPart> parts_with_joint(
    const std::vector<UncertainPart>& parts,
    const std::vector<UncertainPart>& side,
    const SparseMatrix& T) {
  const SparseMatrix none(T.rows(), T.rows());
  std::vector<UncertainPart> result;
  for (const UncertainPart& part : parts) {
    const auto own = std::ranges::find(side, part.power, &UncertainPart::power);
    const bool found = own != side.end();
    result.push_back({part.power,
                      with_joint(part.K, found ? own->K : none, T),
                      with_joint(part.M, found ? own->M : none, T)});
  }
  return result;
}

// What turns against the rest at a joint, and how.
struct OpenJoint {
  std::set<int> side;  // none: all
  SparseMatrix T;
};

// Gives the system's matrices the columns of a joint.
void border_with(const OpenJoint& joint,
                 const Deck& deck,
                 const ElementParts& elements,
                 ReleasedSystem& released) {
  const SparseMatrix& T = joint.T;
  const bool all = joint.side.empty();
  const auto add = [&](BorderedMatrix& A, const SparseMatrix* side) {
    A.add(joint_border(all ? A.times(T) : forces_of(*side, T), T));
  };
  ElementParts::Sum own;
  if (!all) own = elements.of(joint.side);
  add(released.K, &own.K);
  add(released.M, &own.M);
  const SparseMatrix none(T.rows(), T.rows());
  for (ReleasedPart& part : released.parts) {
    const auto at =
        std::ranges::find(own.parts, part.plain->power, &UncertainPart::power);
    const bool found = at != own.parts.end();
    add(part.K, found ? &at->K : &none);
    add(part.M, found ? &at->M : &none);
  }
  for (ReleasedForm& form : released.forms) {
    SparseMatrix of_side;
    if (!all) of_side = mass_of(*form.plain, deck, joint.side);
    add(form.M, &of_side);
  }
}

// Lets what parts move by itself; the springs that hold it, one list for each
// stiffness.
std::vector<Triplets> cut_open(const Cut& cut,
                               const Deck& deck,
                               const ElementParts& elements,
                               ReleasedSystem& released,
                               std::vector<OpenJoint>& joints) {
  const Index n = released.dofs();
  Triplets directions;
  std::vector<Triplets> springs;
  for (std::size_t k = 0; k < cut.partings.size(); ++k) {
    const Parting& parting = cut.partings[k];
    const auto column = static_cast<int>(k);
    for (const auto& [node, motion] : parting.moves) {
      for (int c = 0; c < 6; ++c) {
        if (motion(c) == 0.0) continue;
        directions.emplace_back(
            dof_index(deck, node, 1 + c), column, motion(c));
      }
    }
    const int q = static_cast<int>(n) + column;
    springs.resize(std::max(springs.size(), parting.part + 1));
    springs[parting.part].emplace_back(q, q, parting.held);
    released.active.push_back(q);
  }
  SparseMatrix T(n, static_cast<Index>(cut.partings.size()));
  T.setFromTriplets(directions.begin(), directions.end());
  joints.push_back({{cut.side.begin(), cut.side.end()}, std::move(T)});
  border_with(joints.back(), deck, elements, released);
  return springs;
}

// What springs hold may move.
void let_go(const std::vector<Triplets>& springs,
            const structure::System& system,
            ReleasedSystem& released) {
  for (const Triplets& part : springs) {
    for (const auto& spring : part) {
      const bool inactive =
          system.inactive[static_cast<std::size_t>(spring.row())];
      if (!inactive) released.active.push_back(spring.row());
    }
  }
}

// The stiffness of elements, as it is and as properties change it; and what
// goes with their thickness where they are thinned. Those on the side of a
// joint turn with it.
ScaledStiffness stiffness_of(const ElementParts& elements,
                             const std::vector<int>& ids,
                             bool thinned,
                             const std::vector<OpenJoint>& joints) {
  const std::set<int> own(ids.begin(), ids.end());
  const auto lost_by = [&](const std::set<int>& of) {
    return thinned ? elements.by_thickness(of)
                   : ElementParts::ByThickness{elements.of(of), {}};
  };
  ElementParts::ByThickness lost = lost_by(own);
  for (const OpenJoint& joint : joints) {
    std::set<int> both = own;
    if (!joint.side.empty()) {
      std::erase_if(both, [&](int id) { return !joint.side.contains(id); });
    }
    const ElementParts::ByThickness turned = lost_by(both);
    const auto turn = [&joint](ElementParts::Sum& sum,
                               const ElementParts::Sum& side) {
      if (sum.K.size() == 0) return;
      sum.K = with_joint(sum.K, side.K, joint.T);
      sum.M = with_joint(sum.M, side.M, joint.T);
      sum.parts = parts_with_joint(sum.parts, side.parts, joint.T);
    };
    turn(lost.cube, turned.cube);
    turn(lost.thickness, turned.thickness);
  }
  ScaledStiffness scaled;
  scaled.S = std::move(lost.cube.K);
  scaled.parts = std::move(lost.cube.parts);
  scaled.thickness = std::move(lost.thickness);
  return scaled;
}

void append_elements(const RefinedDeck& mesh,
                     const ElementParts& elements,
                     const StiffnessChange& change,
                     std::size_t position,
                     const std::vector<OpenJoint>& joints,
                     ReleasedSystem& released) {
  const Location& where = change.of.where;
  std::vector<std::vector<int>> groups = {where.elements};
  groups.insert(groups.end(), change.beside.begin(), change.beside.end());
  for (std::size_t p = 0; p < groups.size(); ++p) {
    ScaledStiffness& scaled = released.scaled.emplace_back(stiffness_of(
        elements, mesh.pieces_of(groups[p]), takes_mass(where), joints));
    scaled.change = position;
    scaled.parameter = p;
  }
}

// What a member carries, and what a wire that pulls at it holds across.
void append_preload(const RefinedDeck& mesh,
                    const structure::System& system,
                    const StiffnessChange& change,
                    std::size_t position,
                    ReleasedSystem& released) {
  const Location& where = change.of.where;
  effects::Preload unit = effects::preload(
      mesh.deck, system, mesh.pieces_of(where.elements), where);
  std::size_t parameter = 0;
  for (SparseMatrix* S : {&unit.along, &unit.side}) {
    if (S->size() == 0) continue;
    S->conservativeResize(released.dofs(), released.dofs());
    released.scaled.push_back({position, parameter++, std::move(*S)});
  }
}

}  // namespace

ReleasedSystem nothing_released(const structure::System& system,
                                const std::vector<UncertainPart>& parts,
                                const std::vector<MassForm>& forms) {
  ReleasedSystem released{system.K, system.M};
  for (const UncertainPart& part : parts) {
    released.parts.push_back({&part, part.K, part.M});
  }
  for (const MassForm& form : forms) released.forms.push_back({&form, form.M});
  released.active = system.free_dofs();
  return released;
}

ReleasedSystem release(const RefinedDeck& mesh,
                       const structure::System& system,
                       const ReleasedSystem& plain,
                       const ElementParts& elements,
                       const std::vector<StiffnessChange>& changes,
                       const Eigen::VectorXd& pulled) {
  ReleasedSystem released = plain;
  std::vector<std::vector<Triplets>> springs;
  std::vector<OpenJoint> joints;
  for (const StiffnessChange& change : changes) {
    const Location& where = change.of.where;
    springs.emplace_back();
    if (is_held(where)) {
      std::ranges::copy(held_dofs(mesh, where),
                        std::back_inserter(released.held));
    } else if (change.kind == ChangeKind::Support) {
      if (are_hubs(mesh.deck, where.nodes)) {
        const Cut cut = hub_let_go(
            mesh.deck, support_parts(mesh.deck, where.nodes, where.variant));
        springs.back() = cut_open(cut, mesh.deck, elements, released, joints);
        continue;
      }
      springs.back() = support_springs(mesh.deck, change, pulled);
      let_go(springs.back(), system, released);
    }
    if (change.kind == ChangeKind::Joint) {
      const Cut cut = cut_at(mesh, where, change.component);
      springs.back() = cut_open(cut, mesh.deck, elements, released, joints);
    }
  }
  std::sort(released.held.begin(), released.held.end());
  std::sort(released.active.begin(), released.active.end());
  released.active.erase(
      std::unique(released.active.begin(), released.active.end()),
      released.active.end());
  for (std::size_t k = 0; k < changes.size(); ++k) {
    if (changes[k].kind == ChangeKind::Elements) {
      append_elements(mesh, elements, changes[k], k, joints, released);
    }
    if (changes[k].kind == ChangeKind::Preload) {
      append_preload(mesh, system, changes[k], k, released);
    }
    for (std::size_t p = 0; p < springs[k].size(); ++p) {
      SparseMatrix S(released.dofs(), released.dofs());
      S.setFromTriplets(springs[k][p].begin(), springs[k][p].end());
      released.scaled.push_back({k, p, std::move(S)});
    }
  }
  return released;
}

void add_regularising_mass(const std::vector<int>& free,
                           double high_hz,
                           ReleasedSystem& released) {
  Eigen::VectorXd acted = Eigen::VectorXd::Zero(released.dofs());
  for (const ScaledStiffness& scaled : released.scaled) {
    acted += scaled.S.diagonal();
  }
  std::vector<int> changed;
  for (const int i : released.active) {
    const bool loose = !std::ranges::binary_search(free, i);
    const bool held = std::ranges::binary_search(released.held, i);
    if (loose || held || acted(i) != 0.0) changed.push_back(i);
  }
  const SparseMatrix lent =
      regularising_mass(released.K, released.M, changed, high_hz);
  if (lent.size() > 0) released.M.add(lent);
}

}  // namespace tapfit::updating
