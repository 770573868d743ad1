#include "updating/reduction/reduced_base.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "updating/properties/uncertain_parts.hpp"
#include "updating/reduction/base_error.hpp"
#include "updating/reduction/change_range.hpp"
#include "updating/reduction/changed_motions.hpp"
#include "updating/reduction/corrections.hpp"
#include "updating/reduction/deck_forms.hpp"
#include "updating/reduction/extended_base.hpp"
#include "updating/reduction/kept_base.hpp"
#include "updating/reduction/lean_span.hpp"
#include "updating/reduction/massless_dofs.hpp"
#include "updating/reduction/released_system.hpp"
#include "updating/reduction/seen_through.hpp"
#include "updating/reduction/static_answers.hpp"
#include "updating/reduction/subspace.hpp"
#include "updating/structure/assembly/assemble.hpp"
#include "updating/structure/assembly/deck_modes.hpp"
#include "updating/structure/checks/material_checks.hpp"
#include "updating/structure/elements/dashpots.hpp"
#include "updating/structure/mesh/refine_mesh.hpp"
#include "updating/structure/solve/eigenmodes.hpp"
#include "updating/structure/solve/factor.hpp"
#include "updating/structure/solve/free_motions.hpp"
#include "updating/structure/solve/symmetric_product.hpp"
#include "updating/structure/solve/system.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <optional>
#include <set>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using structure::SparseMatrix;

constexpr double two_pi = 2.0 * std::numbers::pi;

// What FRFs may be off the whole model's, and orders of responses tried for it.
constexpr double exact_enough = 1e-6;
constexpr std::size_t most_orders = 4;

// Stiffness that elements keep, from all of it to next to none.
constexpr ChangeRange loss_range = {1.0, 1.0, 0.04, 0.4, 1.0};

}  // namespace

struct BaseBuilder::Impl {
  structure::RefinedDeck mesh;  // the deck, split
  Index original_grids = 0;
  BaseOptions options;
  std::vector<acquisition::UncertainProperty> uncertain;
  structure::System system;
  structure::FreeMotions motions;  // u = T q
  double mass = 0.0;
  double shift = 0.0;  // K + shift M gives static answers [rad^2/s^2]
  MatrixXd modes;      // u of each, n x count, supports rigid
  VectorXd modes_hz;
  VectorXd pulled;       // how hard they pull at what is held
  ReleasedSystem plain;  // the model with nothing released
  // Vectors of the model with nothing added, and it seen through them.
  struct Span {
    MatrixXd V;
    ReducedBase base;         // K diagonal
    std::vector<int> points;  // whose answers it holds, ascending
  };
  Span wide;           // modes and static responses at options.points
  Span lean;           // what fits need of it
  double error = 0.0;  // of FRFs through the whole
  std::vector<std::string> warnings;
  std::optional<StaticAnswers> answers;
  std::vector<CorrectionPart> corrected;  // parts beyond the plain ones

  [[nodiscard]] SolvedBase solve(const structure::Deck& deck,
                                 const Progress& progress) const;
  /// Largest force on each degree of freedom, of modes of one strain energy as
  /// far as they move what is measured or hit.
  [[nodiscard]] VectorXd pull() const;
  /// Of the modes, how many are a rigid body's; they come first.
  [[nodiscard]] Index rigid_count() const;
  [[nodiscard]] std::vector<FormModes> form_modes() const;

  void make_lean();
  [[nodiscard]] MatrixXd needed(const Span& span,
                                const ReleasedSystem& released,
                                const std::vector<StiffnessChange>& changes,
                                const std::vector<int>& fresh) const;
  /// What the parameter of a change may be.
  [[nodiscard]] ChangeRange range_of(const ReleasedSystem& released,
                                     const ScaledStiffness& own,
                                     ChangeKind kind) const;
};

BaseBuilder::BaseBuilder(
    const structure::Deck& deck,
    const std::vector<acquisition::UncertainProperty>& uncertain,
    const BaseOptions& options,
    const Progress& progress)
    : impl_(std::make_unique<Impl>()) {
  Impl& m = *impl_;
  m.options = options;
  m.uncertain = uncertain;
  std::set<int> points = structure::damped_dofs(deck);
  points.insert(options.points.begin(), options.points.end());
  m.options.points.assign(points.begin(), points.end());
  if (options.driven.empty()) {
    m.options.driven = m.options.points;
  } else {
    std::set<int> driven = structure::damped_dofs(deck);
    driven.insert(options.driven.begin(), options.driven.end());
    m.options.driven.assign(driven.begin(), driven.end());
  }
  m.original_grids = static_cast<Index>(deck.grids.size());
  m.mesh = options.split ? structure::refine_mesh(deck)
                         : structure::RefinedDeck{deck, {}, {}};
  progress("model: assembling", 0.0);
  m.system = structure::assemble(m.mesh.deck);
  if (const SparseMatrix lent =
          lent_mass(m.system, m.options.points, options.high_hz);
      lent.size() > 0) {
    m.system.M += lent;
  }
  m.motions = structure::free_motions(m.system);
  if (m.motions.free.empty()) {
    throw InputError("the model has no free degree of freedom",
                     deck.path.string(),
                     "check the elements and the SPC cards");
  }
  m.mass = structure::total_mass(m.mesh.deck, m.system);
  if (!(m.mass > 0.0)) {
    throw structure::no_density(deck, "the model has no mass");
  }
  m.shift = std::pow(two_pi * options.high_hz * 0.25, 2);
  m.answers.emplace(m.system, m.motions, m.shift);
  m.plain = nothing_released(m.system, uncertain_parts(m.mesh.deck, uncertain));
  SolvedBase solved = kept_or_solved(options.cache,
                                     {m.system,
                                      *m.plain.parts,
                                      m.options.points,
                                      m.motions.size(),
                                      options.high_hz,
                                      options.reach},
                                     [&] { return m.solve(deck, progress); });
  m.modes = m.motions.expand(solved.modes);
  m.modes_hz = std::move(solved.modes_hz);
  m.pulled = m.pull();
  m.error = solved.error;
  ReducedBase& fixed = m.wide.base;
  m.wide.points = m.options.points;
  m.wide.V = std::move(solved.V);
  fixed.rows = PointRows(m.wide.V.topRows(6 * m.original_grids));
  fixed.K = std::move(solved.K);
  fixed.K_part = std::move(solved.K_part);
  fixed.M_part = std::move(solved.M_part);
  for (const UncertainPart& part : *m.plain.parts) {
    fixed.part_power.push_back(part.power);
  }
  m.make_lean();
  if (!options.split) {
    m.warnings = structure::mechanism_warnings(deck, m.system, solved.modes);
  }
}

BaseBuilder::~BaseBuilder() = default;
BaseBuilder::BaseBuilder(BaseBuilder&&) noexcept = default;
BaseBuilder& BaseBuilder::operator=(BaseBuilder&&) noexcept = default;

std::vector<Correction> BaseBuilder::hold_corrections(
    const BaseBuilder& coarser) {
  Impl& m = *impl_;
  const Impl& c = *coarser.impl_;
  const Index known = 6 * m.original_grids;
  ReducedBase& fixed = m.wide.base;
  // As the base holds them: signs, and turns among equal modes, may differ from
  // those of `modes`.
  const MatrixXd modes = m.wide.V.topLeftCorner(known, m.modes.cols());
  m.corrected = corrections(m.mesh.deck,
                            m.wide.V,
                            {{modes, m.modes_hz},
                             {c.modes.topRows(known), c.modes_hz},
                             m.form_modes()});
  const std::size_t first = m.uncertain.size();
  const std::size_t all = first + m.corrected.size();
  for (std::vector<int>& power : fixed.part_power) power.resize(all, 0);
  for (std::size_t k = 0; k < m.corrected.size(); ++k) {
    fixed.part_power.emplace_back(all, 0);
    fixed.part_power.back()[first + k] = 1;
    fixed.K_part.push_back(m.corrected[k].K);
    fixed.M_part.push_back(m.corrected[k].M);
    fixed.corrections.push_back(m.corrected[k].correction);
  }
  m.make_lean();
  return fixed.corrections;
}

std::vector<FormModes> BaseBuilder::Impl::form_modes() const {
  std::vector<FormModes> forms;
  for (DeckForm& form : deck_forms(mesh.deck)) {
    const structure::System other = structure::assemble(form.deck);
    const structure::Eigenmodes found =
        structure::eigenmodes_up_to(motions.reduce(other.K),
                                    motions.reduce(system.M),
                                    options.reach * options.high_hz);
    forms.push_back({std::move(form.correction),
                     {motions.expand(found.phi).topRows(6 * original_grids),
                      found.frequency_hz}});
  }
  return forms;
}

void BaseBuilder::Impl::make_lean() {
  LeanOptions lean_options;
  lean_options.high_hz = options.high_hz;
  std::vector<double> sd;
  for (const auto& u : uncertain) sd.push_back(u.sd_percent / 100.0);
  std::ranges::transform(
      wide.base.corrections, std::back_inserter(sd), &Correction::sd);
  for (const double s : sd) {
    lean_options.spread.push_back(std::clamp(2.0 * s, 0.1, 1.0));
  }
  const MatrixXd driven = wide.V(options.driven, Eigen::all).transpose();
  const MatrixXd Q = lean_span(wide.base, driven, lean_options);
  lean.points = options.driven;
  lean.V = wide.V * Q;
  lean.base = wide.base;
  turn(lean.base, Q);
  const MatrixXd own =
      Eigen::SelfAdjointEigenSolver<MatrixXd>(lean.base.K).eigenvectors();
  lean.V = (lean.V * own).eval();
  turn(lean.base, own);
  lean.base.rows = PointRows(lean.V.topRows(6 * original_grids));
}

Index BaseBuilder::Impl::rigid_count() const {
  return (modes_hz.array() < 1e-3 * options.high_hz).count();
}

bool BaseBuilder::is_free() const { return impl_->rigid_count() > 0; }

MatrixXd BaseBuilder::rigid_modes() const {
  return impl_->modes.topLeftCorner(6 * impl_->original_grids,
                                    impl_->rigid_count());
}

double BaseBuilder::elastic_hz() const {
  const Index first = impl_->rigid_count();
  return first < impl_->modes_hz.size()
             ? impl_->modes_hz(first)
             : std::numeric_limits<double>::infinity();
}

double BaseBuilder::mass_kg() const { return impl_->mass; }
double BaseBuilder::error() const { return impl_->error; }
Index BaseBuilder::dofs() const { return impl_->motions.size(); }
const std::vector<std::string>& BaseBuilder::warnings() const {
  return impl_->warnings;
}

SolvedBase BaseBuilder::Impl::solve(const structure::Deck& deck,
                                    const Progress& progress) const {
  progress("model: eigenmodes", 0.2);
  SolvedBase solved;
  try {
    structure::Eigenmodes found =
        structure::eigenmodes_up_to(motions.reduce(system.K),
                                    motions.reduce(system.M),
                                    options.reach * options.high_hz);
    solved.modes = std::move(found.phi);
    solved.modes_hz = std::move(found.frequency_hz);
  } catch (const structure::SingularMatrix&) {
    structure::name_mechanism(deck);
    throw;
  }
  progress("model: residual flexibility", 0.8);
  const MatrixXd u = motions.expand(solved.modes);
  MatrixXd& V = solved.V;
  // Two with modes to four times the band leave a smaller basis than three with
  // modes to three times it.
  for (std::size_t orders = 2; orders <= most_orders; ++orders) {
    V = join(
        {u, beyond(system.M, u, answers->to_points(options.points, orders))});
    if (V.cols() == 0) {
      throw InputError("no mode is in reach of the band, no point moves",
                       deck.path.string(),
                       "check units, supports and the points' directions");
    }
    const MatrixXd projected =
        V.transpose() * structure::symmetric_product(system.K, V);
    V = (V * Eigen::SelfAdjointEigenSolver<MatrixXd>(projected).eigenvectors())
            .eval();
    solved.K = V.transpose() * structure::symmetric_product(system.K, V);
    solved.error = base_error(system,
                              *answers,
                              V,
                              solved.K.diagonal(),
                              options.points,
                              options.high_hz);
    if (solved.error <= exact_enough) break;
  }
  for (const UncertainPart& part : *plain.parts) {
    solved.K_part.push_back(seen_through(V, part.K));
    solved.M_part.push_back(seen_through(V, part.M));
  }
  return solved;
}

VectorXd BaseBuilder::Impl::pull() const {
  MatrixXd reaction = structure::symmetric_product(system.K, modes);
  // Of what follows a rigid element too.
  if (system.T.size() > 0) reaction = (system.T.transpose() * reaction).eval();
  const MatrixXd seen = modes(options.points, Eigen::all);
  VectorXd largest = VectorXd::Zero(reaction.rows());
  for (Index r = 0; r < modes.cols(); ++r) {
    if (modes_hz(r) < 1e-3) continue;
    const double share =
        seen.size() > 0 ? seen.col(r).norm() / modes_hz(r) : 1.0 / modes_hz(r);
    largest = largest.cwiseMax(share * reaction.col(r).cwiseAbs());
  }
  return largest;
}

ChangeRange BaseBuilder::Impl::range_of(const ReleasedSystem& released,
                                        const ScaledStiffness& own,
                                        ChangeKind kind) const {
  if (kind == ChangeKind::Elements) return loss_range;
  const PlainModes plain_modes = {modes, modes_hz, options.high_hz};
  if (kind != ChangeKind::Preload) {
    return spring_range(released, own, plain_modes, system.T);
  }
  const Index n = system.dofs();
  return added_range(own.S.topLeftCorner(n, n), plain_modes);
}

// What a fixed basis lacks, as columns over the released dofs.
MatrixXd BaseBuilder::Impl::needed(const Span& span,
                                   const ReleasedSystem& released,
                                   const std::vector<StiffnessChange>& changes,
                                   const std::vector<int>& fresh) const {
  const VectorXd stiffness = span.base.K.diagonal();
  const HeldBase held = {
      system, motions, *answers, span.V, stiffness, shift, options.high_hz};
  std::vector<MatrixXd> blocks;
  if (!fresh.empty()) blocks.push_back(answers->to_points(fresh));
  if (!changes.empty()) blocks.push_back(constraint_modes(held, released));
  const Index n = system.dofs();
  const auto add_loss = [&](const SparseMatrix& S, const SparseMatrix& N) {
    SparseMatrix own_mass;
    if (N.size() > 0) own_mass = N.topLeftCorner(n, n);
    blocks.push_back(
        loss_modes(held, S.topLeftCorner(n, n), own_mass, loss_range.lower));
  };
  for (std::size_t c = 0; c < changes.size(); ++c) {
    const ChangeKind kind = changes[c].kind;
    ScaledStiffness all;
    for (const ScaledStiffness& scaled : released.scaled) {
      if (scaled.change != c) continue;
      if (kind == ChangeKind::Preload) {
        const double most = range_of(released, scaled, kind).upper;
        blocks.push_back(added_modes(held, scaled.S.topLeftCorner(n, n), most));
      }
      if (kind != ChangeKind::Elements) continue;
      if (all.S.size() == 0) {
        add_loss(scaled.S, scaled.N);
        all = scaled;
      } else {
        all.S += scaled.S;
        if (all.N.size() > 0) all.N += scaled.N;
      }
    }
    // With what is lost beside it: in between it runs smoothly.
    if (!changes[c].beside.empty()) add_loss(all.S, all.N);
  }
  return join(std::move(blocks));
}

ReducedBase BaseBuilder::build(const std::vector<int>& points,
                               const std::vector<StiffnessChange>& changes,
                               BaseUse use) const {
  const Impl& m = *impl_;
  const Impl::Span& span = use == BaseUse::Fit ? m.lean : m.wide;
  std::vector<int> fresh;
  std::ranges::set_difference(points, span.points, std::back_inserter(fresh));
  if (changes.empty() && fresh.empty()) return span.base;
  std::optional<ReleasedSystem> own;  // where it is not the plain one
  if (!changes.empty()) {
    own = release(m.mesh, m.system, m.plain, m.uncertain, changes, m.pulled);
    lend_mass(m.motions.free, m.options.high_hz, *own);
  }
  SparseMatrix lent = lent_mass(m.system, fresh, m.options.high_hz);
  if (lent.size() > 0) {
    if (!own) own = m.plain;
    lent.conservativeResize(own->dofs(), own->dofs());
    own->add_mass(lent);
  }
  const ReleasedSystem& released = own ? *own : m.plain;
  ReducedBase base = extended_base(span.V,
                                   span.base,
                                   m.needed(span, released, changes, fresh),
                                   released,
                                   m.corrected);
  for (std::size_t k = 0; k < base.terms.size(); ++k) {
    const ScaledStiffness& scaled = released.scaled[k];
    const StiffnessChange& change = changes[scaled.change];
    base.terms[k].of = change.of;
    ChangeRange& range = base.terms[k];
    range = m.range_of(released, scaled, change.kind);
    // Open: a plate's flaps shear past each other on next to nothing.
    if (change.of.where.variant == crack) range.lower *= 1e-6;
  }
  return base;
}

}  // namespace tapfit::updating
