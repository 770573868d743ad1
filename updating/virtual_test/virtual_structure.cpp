#include "updating/virtual_test/virtual_structure.hpp"

#include "acquisition/foundation/constants.hpp"
#include "acquisition/foundation/input_error.hpp"
#include "updating/reduction/released_system.hpp"
#include "updating/structure/assembly/assemble.hpp"
#include "updating/structure/solve/eigenmodes.hpp"
#include "updating/virtual_test/virtual_support.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

namespace tapfit::updating {
namespace {

using structure::SparseMatrix;
using Triplets = std::vector<Eigen::Triplet<double>>;

// As bungees give it; of a structure that bends slowly a share of where it does
// so first: above a tenth it would stiffen what is measured.
constexpr double usual_suspension_hz = 1.3;
constexpr double suspension_share = 0.05;

void add_diagonal(SparseMatrix& A, const Triplets& parts) {
  SparseMatrix change(A.rows(), A.cols());
  change.setFromTriplets(parts.begin(), parts.end());
  A += change;
}

void scale_modulus(structure::Deck& deck, double factor) {
  if (deck.materials.empty()) return;
  structure::Material& material = deck.materials.begin()->second;
  material.E *= factor;
  material.E2 *= factor;
  material.G *= factor;
  material.G1z *= factor;
  material.G2z *= factor;
}

bool hangs_free(const structure::Deck& deck) {
  if (!deck.constraints.empty()) return false;
  return std::all_of(
      deck.scalars.begin(), deck.scalars.end(), [](const auto& spring) {
        const bool grounded = spring.grids[0] == 0 || spring.grids[1] == 0;
        return !grounded || spring.stiffness <= 0.0;
      });
}

void lose_stiffness(const VirtualModel& model,
                    const structure::Deck& fine,
                    const VirtualEffect& effect,
                    SparseMatrix& K) {
  std::set<int> weak;
  for (const int id : effect.numbers()) {
    const auto parent = model.children.find(id);
    if (parent == model.children.end()) {
      throw InputError(fmt::format("the model has no element {}", id),
                       "stiffness-loss",
                       "Name elements of the model deck.");
    }
    weak.insert(parent->second.begin(), parent->second.end());
  }
  K -= (1.0 - effect.values[0]) *
       structure::assemble_stiffness(fine,
                                     [&](int id) { return weak.contains(id); });
}

// One more degree of freedom, after all others.
void add_free(int dof, structure::FreeMotions& motions) {
  motions.free.push_back(dof);
  motions.dofs = dof + 1;
  if (motions.T.size() == 0) return;
  motions.T.conservativeResize(motions.dofs, motions.size());
  motions.T.insert(dof, motions.size() - 1) = 1.0;
}

// A mass on a spring and dashpot, in a degree of freedom of its own.
void add_absorber(const VirtualEffect& effect,
                  int dof,
                  VirtualStructure& structure) {
  const int own = static_cast<int>(structure.K.rows());
  structure.K.conservativeResize(own + 1, own + 1);
  structure.M.conservativeResize(own + 1, own + 1);
  const double m = effect.values[0];
  const double w = two_pi * effect.values[1];
  const double zeta = effect.values.size() > 2 ? effect.values[2] : 0.01;
  const double k = m * w * w;
  add_diagonal(structure.K,
               {{dof, dof, k}, {own, own, k}, {dof, own, -k}, {own, dof, -k}});
  add_diagonal(structure.M, {{own, own, m}});
  structure.dashpots.push_back({2.0 * zeta * w * m, {{dof, 1.0}, {own, -1.0}}});
  add_free(own, structure.motions);
}

// The elements on one side of a line turn against the rest on springs.
void cut_joint(const VirtualModel& model,
               const structure::Deck& fine,
               const VirtualEffect& effect,
               int component,
               structure::System& system,
               VirtualStructure& structure) {
  StiffnessChange change;
  change.kind = ChangeKind::Joint;
  change.component = component;
  change.of.where.nodes = effect.numbers();
  system.K = structure.K;
  system.M = structure.M;
  const ReleasedSystem cut = release({fine, model.children, {}},
                                     system,
                                     nothing_released(system, {}),
                                     ElementParts(fine, {}),
                                     {change});
  if (cut.dofs() == static_cast<Eigen::Index>(system.dofs())) {
    throw InputError(
        fmt::format("nothing turns at grids {}", fmt::join(effect.places, ":")),
        "joint",
        "Name two or more grids of a straight line of mesh edges across "
        "shells, or one grid where bars across the tested direction meet.");
  }
  structure.K = cut.K.whole() + effect.values[0] * cut.scaled.front().S;
  structure.M = cut.M.whole();
  for (const int dof : cut.active) {
    if (dof >= static_cast<int>(system.dofs())) {
      add_free(dof, structure.motions);
    }
  }
}

// A spring between two grids: no effect of the catalogue.
void add_strut(const VirtualEffect& effect,
               int component,
               VirtualStructure& structure) {
  const std::vector<int> ends = effect.numbers();
  const int a = structure.dof_index({ends[0], component, 1});
  const int b = structure.dof_index({ends[1], component, 1});
  const double k = effect.values[0];
  add_diagonal(structure.K, {{a, a, k}, {b, b, k}, {a, b, -k}, {b, a, -k}});
}

// What the clamp's rotations or translations are held by, per metre at its
// first end and at its last.
struct ClampSpring {
  std::vector<int> components;  // 1..6
  double first = 0.0;
  double last = 0.0;
};

std::vector<ClampSpring> clamp_springs(const VirtualEffect& effect,
                                       const std::vector<int>& turns) {
  const std::vector<int> moves = {1, 2, 3};
  const double one = effect.values.front();
  const double other = effect.values.back();
  if (effect.form == "both") return {{turns, one, one}, {moves, other, other}};
  return {{effect.form == "translation" ? moves : turns, one, other}};
}

// The clamp of the engineer's model, on springs along its edge.
void soften_support(const VirtualModel& model,
                    const VirtualEffect& effect,
                    structure::System& system,
                    VirtualStructure& structure) {
  const SupportEdge edge = support_edge(model.fine);
  const std::vector<ClampSpring> springs = clamp_springs(effect, edge.turns);
  for (const auto& [grid, length] : edge.length_of) {
    for (const ClampSpring& spring : springs) {
      const double k = std::lerp(spring.first, spring.last, edge.at.at(grid));
      for (const int component : spring.components) {
        const int at = structure.dof_index({grid, component, 1});
        system.fixed[static_cast<std::size_t>(at)] = false;
        add_diagonal(structure.K, {{at, at, k * length}});
      }
    }
    structure.support_length += length;
    if (model.model.has_grid(grid)) structure.support_nodes.push_back(grid);
  }
}

bool acts_at_node(const VirtualEffect& effect) {
  return effect.name == "added-mass" || effect.name == "ground-spring" ||
         effect.name == "dashpot" || effect.name == "absorber" ||
         effect.name == "nonlinearity";
}

void add_at_node(const VirtualEffect& effect,
                 int component,
                 VirtualStructure& structure) {
  const Dof dof{effect.numbers().front(), component, 1};
  const int at = structure.dof_index(dof);
  const double value = effect.values[0];
  if (effect.name == "added-mass") {
    const int first = at - (component - 1);
    add_diagonal(structure.M,
                 {{first, first, value},
                  {first + 1, first + 1, value},
                  {first + 2, first + 2, value}});
  } else if (effect.name == "ground-spring") {
    add_diagonal(structure.K, {{at, at, value}});
  } else if (effect.name == "dashpot") {
    structure.dashpots.push_back({value, {{at, 1.0}}});
  } else if (effect.name == "nonlinearity") {
    structure.hardening = HardeningSpring{at, value};
  } else if (effect.name == "absorber") {
    add_absorber(effect, at, structure);
  }
}

double suspension_hz(const structure::Deck& deck) {
  const structure::System system = structure::assemble(deck);
  const structure::FreeMotions motions = structure::free_motions(system);
  const Eigen::VectorXd hz =
      structure::eigenmodes(
          motions.reduce(system.K), motions.reduce(system.M), 12)
          .frequency_hz;
  const double bending = 1e-3 * hz.maxCoeff();
  const auto first =
      std::ranges::find_if(hz, [bending](double f) { return f > bending; });
  return std::min(usual_suspension_hz, suspension_share * *first);
}

// Rigid and light bungees: every rigid motion gets the suspension's frequency.
void hang(const structure::Deck& deck, VirtualStructure& structure) {
  structure.suspension_hz = suspension_hz(deck);
  const double w = two_pi * structure.suspension_hz;
  structure.K += w * w * structure.M;
}

}  // namespace

int VirtualStructure::dof_index(const Dof& dof) const {
  const auto grid = grid_index.find(dof.node);
  if (grid == grid_index.end()) {
    throw InputError(fmt::format("the model has no grid {}", dof.node),
                     "virtual structure",
                     "Name a grid of the model deck.");
  }
  return 6 * grid->second + dof.component - 1;
}

VirtualStructure build_virtual_structure(
    const VirtualModel& model,
    const std::vector<VirtualEffect>& effects,
    double modulus_factor,
    int component) {
  structure::Deck fine = model.fine;
  scale_modulus(fine, modulus_factor);
  structure::System system = structure::assemble(fine);

  VirtualStructure result;
  result.effects = effects;
  result.K = system.K;
  result.M = system.M;
  result.total_mass = structure::total_mass(fine, system);
  for (std::size_t k = 0; k < fine.grids.size(); ++k) {
    result.grid_index[fine.grids[k].id] = static_cast<int>(k);
  }
  if (hangs_free(model.model)) hang(model.model, result);
  for (const VirtualEffect& effect : effects) {
    if (effect.name == "soft-support") {
      soften_support(model, effect, system, result);
    } else if (effect.name == "stiffness-loss") {
      lose_stiffness(model, fine, effect, result.K);
    }
  }
  result.motions = structure::free_motions(system);
  result.dashpots = structure::dashpots(fine);
  for (const VirtualEffect& effect : effects) {
    if (acts_at_node(effect)) add_at_node(effect, component, result);
    if (effect.name == "strut") add_strut(effect, component, result);
    if (effect.name == "joint") {
      cut_joint(model, fine, effect, component, system, result);
    }
  }
  return result;
}

}  // namespace tapfit::updating
