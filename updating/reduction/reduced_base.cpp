#include "updating/reduction/reduced_base.hpp"

#include "updating/corrections/corrections.hpp"
#include "updating/places/held_support.hpp"
#include "updating/properties/uncertain_parts.hpp"
#include "updating/reduction/assembled_base.hpp"
#include "updating/reduction/base_cache.hpp"
#include "updating/reduction/basis_enrichment.hpp"
#include "updating/reduction/change_range.hpp"
#include "updating/reduction/deck_through_base.hpp"
#include "updating/reduction/extended_base.hpp"
#include "updating/reduction/lean_span.hpp"
#include "updating/reduction/made_bases.hpp"
#include "updating/reduction/massless_dofs.hpp"
#include "updating/reduction/missing_vectors.hpp"
#include "updating/reduction/released_system.hpp"
#include "updating/reduction/solve_base.hpp"
#include "updating/reduction/subspace.hpp"
#include "updating/structure/assembly/deck_modes.hpp"
#include "updating/structure/mesh/refine_mesh.hpp"
#include "updating/structure/solve/symmetric_product.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using structure::SparseMatrix;

// Largest force on each degree of freedom, of modes of one strain energy as far
// as they move what is measured or hit.
VectorXd pull(const AssembledBase& model,
              const MatrixXd& modes,
              const VectorXd& modes_hz) {
  const structure::System& system = model.system;
  MatrixXd reaction = structure::symmetric_product(system.K, modes);
  // Of what follows a rigid element too.
  if (system.T.size() > 0) reaction = (system.T.transpose() * reaction).eval();
  const MatrixXd seen = modes(model.options.points, Eigen::all);
  VectorXd largest = VectorXd::Zero(reaction.rows());
  for (Index r = 0; r < modes.cols(); ++r) {
    if (modes_hz(r) < 1e-3) continue;
    const double share =
        seen.size() > 0 ? seen.col(r).norm() / modes_hz(r) : 1.0 / modes_hz(r);
    largest = largest.cwiseMax(share * reaction.col(r).cwiseAbs());
  }
  return largest;
}

// What is released brings a vector for each of its degrees of freedom, what
// elements lose or carry but the few patterns that the band strains.
bool release_dofs(const std::vector<StiffnessChange>& changes) {
  return std::ranges::any_of(changes, [](const StiffnessChange& change) {
    return change.kind == ChangeKind::Support ||
           change.kind == ChangeKind::Joint;
  });
}

// Both ascending.
std::vector<int> with(const std::vector<int>& points,
                      const std::vector<int>& others) {
  std::vector<int> all;
  std::ranges::set_union(points, others, std::back_inserter(all));
  return all;
}

}  // namespace

struct BaseBuilder::Impl {
  Impl(const structure::Deck& deck,
       const std::vector<acquisition::UncertainProperty>& uncertain,
       const BaseOptions& options,
       const Progress& progress)
      : model(deck, uncertain, options, progress) {}

  AssembledBase model;
  MatrixXd modes;  // u of each, n x count, supports rigid
  VectorXd modes_hz;
  VectorXd pulled;  // how hard they pull at what is held
  // Vectors of the model with nothing added, and it seen through them.
  struct Span {
    MatrixXd V;
    ReducedBase base;         // K diagonal
    std::vector<int> points;  // whose answers it holds, ascending
  };
  Span wide;  // modes and static responses at options.points
  Span lean;  // what fits need of it
  LeanOptions lean_options;
  double error = 0.0;  // of FRFs through the whole
  std::vector<std::string> warnings;
  std::vector<CorrectionPart> corrected;  // parts beyond the plain ones

  void take(SolvedBase solved);
  void make_lean();
  /// Of the modes, how many are a rigid body's; they come first.
  [[nodiscard]] Index rigid_count() const;
  [[nodiscard]] PlainModes plain_modes() const {
    return {modes, modes_hz, model.options.high_hz};
  }
  /// What a fixed basis lacks, as columns over the released dofs.
  [[nodiscard]] MatrixXd needed(const Span& span,
                                const ReleasedSystem& released,
                                const std::vector<StiffnessChange>& changes,
                                const std::vector<int>& fresh) const;
  /// The system with the changes; empty where it is the plain one.
  [[nodiscard]] std::optional<ReleasedSystem> changed(
      const std::vector<StiffnessChange>& changes,
      const std::vector<int>& fresh) const;
  [[nodiscard]] ReducedBase extended(
      const Span& span,
      const std::vector<StiffnessChange>& changes,
      const std::vector<int>& fresh) const;
  /// Its columns beyond those of the span, at the deck's own grids.
  [[nodiscard]] MatrixXd own_columns(
      const Span& span,
      const std::vector<StiffnessChange>& changes,
      const std::vector<int>& fresh) const;
  /// What of it fits need, with the points acted on.
  void make_lean(ReducedBase& base, const std::vector<int>& points) const;
};

BaseBuilder::BaseBuilder(
    const structure::Deck& deck,
    const std::vector<acquisition::UncertainProperty>& uncertain,
    const BaseOptions& options,
    const Progress& progress)
    : impl_(std::make_shared<Impl>(deck, uncertain, options, progress)),
      made_(std::make_unique<MadeBases>()) {
  const AssembledBase& model = impl_->model;
  SolvedBase solved =
      kept_or_solved(options.cache,
                     {model.system,
                      model.forms,
                      model.parts,
                      model.options.points,
                      model.motions.size(),
                      options.high_hz,
                      options.reach},
                     [&] { return solve_base(model, deck, progress); });
  if (!options.split) {
    impl_->warnings =
        structure::mechanism_warnings(deck, model.system, solved.modes);
  }
  impl_->take(std::move(solved));
}

void BaseBuilder::Impl::take(SolvedBase solved) {
  modes = model.motions.expand(solved.modes);
  modes_hz = std::move(solved.modes_hz);
  pulled = pull(model, modes, modes_hz);
  error = solved.error;
  ReducedBase& fixed = wide.base;
  wide.points = model.options.points;
  wide.V = std::move(solved.V);
  fixed.rows = PointRows(wide.V.topRows(6 * model.original_grids));
  fixed.K = std::move(solved.K);
  fixed.K_part = std::move(solved.K_part);
  fixed.M_part = std::move(solved.M_part);
  for (const UncertainPart& part : model.parts) {
    fixed.part_power.push_back(part.power);
  }
  make_lean();
}

BaseBuilder::~BaseBuilder() = default;
BaseBuilder::BaseBuilder(BaseBuilder&&) noexcept = default;
BaseBuilder& BaseBuilder::operator=(BaseBuilder&&) noexcept = default;

BaseBuilder BaseBuilder::for_deck(const structure::Deck& deck) const {
  BaseOptions options = impl_->model.options;
  options.split = false;
  options.cache.reset();
  return {deck, impl_->model.uncertain, options, Progress{}};
}

ReducedBase BaseBuilder::through_base(const structure::Deck& deck) const {
  const Impl& m = *impl_;
  const BaseOptions& options = m.model.options;
  return deck_through_base(
      options.split ? structure::refine_mesh(deck).deck : deck,
      m.model.uncertain,
      {m.wide.V, m.wide.base.rows, options.points, options.high_hz});
}

std::vector<Correction> BaseBuilder::hold_corrections(
    const BaseBuilder& coarser, const Progress& progress) {
  Impl& m = *impl_;
  const Impl& c = *coarser.impl_;
  const Index known = 6 * m.model.original_grids;
  ReducedBase& fixed = m.wide.base;
  // As the base holds them: signs, and turns among equal modes, may differ from
  // those of `modes`.
  const MatrixXd modes = m.wide.V.topLeftCorner(known, m.modes.cols());
  m.corrected = corrections(m.model.mesh.deck,
                            m.wide.V,
                            {{modes, m.modes_hz},
                             {c.modes.topRows(known), c.modes_hz},
                             form_modes(m.model, progress.stop)},
                            m.model.forms);
  const std::size_t first = m.model.uncertain.size();
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

void BaseBuilder::Impl::make_lean() {
  lean_options = {model.options.high_hz};
  std::vector<double> sd;
  for (const auto& u : model.uncertain) sd.push_back(u.sd_percent / 100.0);
  std::ranges::transform(
      wide.base.corrections, std::back_inserter(sd), &Correction::sd);
  for (const double s : sd) {
    lean_options.spread.push_back(std::clamp(2.0 * s, 0.1, 1.0));
  }
  const MatrixXd driven = wide.V(model.options.driven, Eigen::all).transpose();
  const MatrixXd Q = lean_span(wide.base, driven, lean_options);
  lean.points = model.options.driven;
  lean.V = wide.V * Q;
  lean.base = wide.base;
  lean.base.turn(Q);
  const MatrixXd own =
      Eigen::SelfAdjointEigenSolver<MatrixXd>(lean.base.K).eigenvectors();
  lean.V = (lean.V * own).eval();
  lean.base.turn(own);
  lean.base.rows = PointRows(lean.V.topRows(6 * model.original_grids));
}

Index BaseBuilder::Impl::rigid_count() const {
  return (modes_hz.array() < 1e-3 * model.options.high_hz).count();
}

bool BaseBuilder::is_free() const { return impl_->rigid_count() > 0; }

MatrixXd BaseBuilder::rigid_modes() const {
  return impl_->modes.topLeftCorner(6 * impl_->model.original_grids,
                                    impl_->rigid_count());
}

double BaseBuilder::elastic_hz() const {
  const Index first = impl_->rigid_count();
  return first < impl_->modes_hz.size()
             ? impl_->modes_hz(first)
             : std::numeric_limits<double>::infinity();
}

double BaseBuilder::mass_kg() const { return impl_->model.mass; }
const std::vector<PartMass>& BaseBuilder::part_masses() const {
  return impl_->model.part_mass;
}
double BaseBuilder::error() const { return impl_->error; }
Index BaseBuilder::dofs() const { return impl_->model.motions.size(); }
const std::vector<std::string>& BaseBuilder::warnings() const {
  return impl_->warnings;
}

MatrixXd BaseBuilder::Impl::needed(const Span& span,
                                   const ReleasedSystem& released,
                                   const std::vector<StiffnessChange>& changes,
                                   const std::vector<int>& fresh) const {
  const VectorXd stiffness = span.base.K.diagonal();
  const HeldBase held = {model.system,
                         model.motions,
                         *model.answers,
                         span.V,
                         stiffness,
                         model.shift,
                         model.options.high_hz};
  std::vector<int> seen;
  if (&span == &lean) seen = with(span.points, fresh);
  return missing_vectors(held, plain_modes(), released, changes, fresh, seen);
}

std::optional<ReleasedSystem> BaseBuilder::Impl::changed(
    const std::vector<StiffnessChange>& changes,
    const std::vector<int>& fresh) const {
  std::optional<ReleasedSystem> own;
  if (!changes.empty()) {
    own = release(
        model.mesh, model.system, model.plain, model.elements, changes, pulled);
    add_regularising_mass(model.motions.free, model.options.high_hz, *own);
  }
  SparseMatrix lent =
      regularising_mass(model.system, fresh, model.options.high_hz);
  if (lent.size() > 0) {
    if (!own) own = model.plain;
    lent.conservativeResize(own->dofs(), own->dofs());
    own->M.add(lent);
  }
  return own;
}

MatrixXd BaseBuilder::Impl::own_columns(
    const Span& span,
    const std::vector<StiffnessChange>& changes,
    const std::vector<int>& fresh) const {
  const std::optional<ReleasedSystem> own = changed(changes, fresh);
  const ReleasedSystem& released = own ? *own : model.plain;
  const MatrixXd R = m_orthogonal_complement(
      released.M, span.V, needed(span, released, changes, fresh));
  return R.topRows(6 * model.original_grids);
}

ReducedBase BaseBuilder::Impl::extended(
    const Span& span,
    const std::vector<StiffnessChange>& changes,
    const std::vector<int>& fresh) const {
  const std::optional<ReleasedSystem> own = changed(changes, fresh);
  const ReleasedSystem& released = own ? *own : model.plain;
  ReducedBase base = extended_base(span.V,
                                   span.base,
                                   needed(span, released, changes, fresh),
                                   released,
                                   corrected);
  for (std::size_t k = 0; k < base.terms.size(); ++k) {
    const ScaledStiffness& scaled = released.scaled[k];
    const StiffnessChange& change = changes[scaled.change];
    base.terms[k].of = change.of;
    ChangeRange& range = base.terms[k];
    range =
        range_of(released, scaled, change.kind, plain_modes(), model.system);
    // Open: a plate's flaps shear past each other on next to nothing.
    if (change.of.where.variant == crack) range.lower *= 1e-6;
  }
  return base;
}

void BaseBuilder::Impl::make_lean(ReducedBase& base,
                                  const std::vector<int>& points) const {
  const std::vector<int> asked = with(points, model.options.driven);
  MatrixXd rows(base.size(), std::ssize(asked));
  for (std::size_t k = 0; k < asked.size(); ++k) {
    rows.col(static_cast<Index>(k)) = base.rows.row(asked[k]).transpose();
  }
  base.turn(released_span(base, rows, lean_options));
}

ReducedBase BaseBuilder::build(const std::vector<int>& points,
                               const std::vector<StiffnessChange>& changes,
                               BaseUse use) const {
  const Impl& m = *impl_;
  // Held elsewhere, a structure has modes that a lean span is not made for.
  const bool elsewhere = std::ranges::any_of(
      changes,
      [](const StiffnessChange& change) { return is_held(change.of.where); });
  const bool lean = use == BaseUse::Fit && !elsewhere;
  const Impl::Span& span = lean ? m.lean : m.wide;
  std::vector<int> fresh;
  std::ranges::set_difference(points, span.points, std::back_inserter(fresh));
  if (changes.empty() && fresh.empty()) return span.base;
  BaseRequest request{points, changes, use};
  if (const auto known = made_->find(request)) return *known;
  ReducedBase base = m.extended(span, changes, fresh);
  if (lean && release_dofs(changes)) m.make_lean(base, points);
  if (use == BaseUse::Fit && !m.model.options.on_two_meshes) {
    base.rows.keep_only(with(points, m.model.options.points),
                        [impl = impl_, &span, changes, fresh] {
                          return impl->own_columns(span, changes, fresh);
                        });
  }
  // Of no change it is as quickly made again.
  if (!changes.empty()) {
    made_->keep(std::move(request), std::make_shared<const ReducedBase>(base));
  }
  return base;
}

}  // namespace tapfit::updating
