// The room updating/frf_model. FRFs of the model with effects, without solving
// the whole model again.
// In:  ReducedBase and ModelState.
// Out: FRFs at the measured pairs with their derivatives; modes.
// May include: its row in CONTRIBUTING.md.
//
// FRFs of the base model with effects added, and their derivatives, without
// ever solving the full model again (Sherman-Morrison-Woodbury).
//
//   H* = H - H B D (I + B' H B D)^-1 B' H          (eq. 15 of the paper)
//   d H*_oi / d theta = -X_o' (d Z / d theta) X_i   (eq. 4),  X_q = H* e_q
//
// H is diagonal in the base's modes; B holds the rows of the degrees of freedom
// acted on, the deck's own dashpots (D = s c) among them. Properties that scale
// whole matrices, supports, and springs and masses that are alike in every run
// change the base's modes instead, which are then taken anew (a small dense
// problem; modal_modifications.hpp says why).
#pragma once

#include "signal/frf_set/frf_set.hpp"
#include "updating/frf_model/modal_data.hpp"
#include "updating/frf_model/modal_modifications.hpp"
#include "updating/frf_model/model_modes.hpp"
#include "updating/frf_model/model_response.hpp"
#include "updating/frf_model/model_state.hpp"
#include "updating/frf_model/test_as_done.hpp"
#include "updating/reduction/reduced_base.hpp"

#include <Eigen/Core>

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace tapfit::updating {

/// Whether the base holds this effect as a change of its stiffness.
[[nodiscard]] bool is_of(const StiffnessTerm& term,
                         const EffectInstance& effect);

struct ModalState;
struct RunResponse;
struct FormEntry;

/// See FrfModel::form_patterns().
struct FormPatterns {
  /// d H / d e_ij times its deviation over tau, lines x pairs each.
  std::vector<Eigen::MatrixXcd> dH;
  /// What the mesh leaves of each, in the same measure as tau.
  Eigen::VectorXd mesh_sd;
};

/// The model at the measured pairs of an FRF set; or, where modes were measured
/// instead, its frequencies and shapes beside theirs: a "line" is then a mode,
/// and the "FRFs" are its frequency and its shape's points (modal_data.hpp).
class FrfModel {
 public:
  /// @param measured pairs (their H is not used)
  /// @param modes measured in place of the pairs; else null
  /// @throws InputError for a measured grid that the deck does not have
  FrfModel(ReducedBase base,
           const effects::TestContext& context,
           const signal::FrfSet& measured,
           std::shared_ptr<const ModalData> modes = nullptr);

  /// @param s lines [rad/s]
  /// @param derivatives also fill ModelResponse::dH
  [[nodiscard]] ModelResponse respond(const ModelState& state,
                                      const Eigen::VectorXcd& s,
                                      bool derivatives) const;

  /// FRFs where the base's modes are others than the state makes them.
  /// @param modes in place of base_modes()
  [[nodiscard]] Eigen::MatrixXcd respond_through(
      const BaseModes& modes,
      const ModelState& state,
      const Eigen::VectorXcd& s) const;

  /// The same at several sizes of the last effect, without derivatives: what
  /// the others make of the modes is worked out once.
  /// @param sizes the last effect's parameters, each
  [[nodiscard]] std::vector<Eigen::MatrixXcd> respond_at_sizes(
      const ModelState& state,
      const std::vector<std::vector<double>>& sizes,
      const Eigen::VectorXcd& s) const;

  /// Modes of the base with its factors and supports, without the rest.
  /// Damping ratios are theirs, by order, once springs and masses are on.
  [[nodiscard]] BaseModes base_modes(const ModelState& state) const;
  /// Undamped modes with every effect. What roves with a sensor is spread over
  /// the measured runs, which gives the mean of their frequencies to first
  /// order: measured modes of several set-ups are means as well.
  [[nodiscard]] BaseModes full_modes(const ModelState& state) const;

  /// The base's own modes, as the deck has them, at what was measured.
  /// @return omega [rad/s] and shapes, points x modes
  [[nodiscard]] std::pair<Eigen::VectorXd, Eigen::MatrixXd> modes_at_points()
      const;

  /// What a deck that is wrong in form does to the FRFs, to first order: its
  /// modal stiffness off by omega_i omega_j e_ij, with e_ij symmetric and
  /// random, of variance tau^2 on the diagonal and tau^2 / 2 beside it (the
  /// nonparametric model of C. Soize, Probabilistic Engineering Mechanics 15,
  /// 2000, p. 277). Three more patterns are what modes have in common, evenly,
  /// in proportion to their frequency, and above the band alone: what a section
  /// without shear, an edge held too well or a mass in the wrong plane does.
  /// Modes are mixed with the next five that show; rigid ones, and those below
  /// the lines that answer by their mass, stay as they are.
  ///
  /// Beside tau the mesh leaves mesh_left_over of what it changed of e_ij.
  [[nodiscard]] FormPatterns form_patterns(const ModelState& state,
                                           const Eigen::VectorXcd& s) const;

  /// Receptance columns H* e of the runs on which the effects act alike, in
  /// the base's coordinates (rows of V give any degree of freedom).
  struct Walk {
    std::vector<WalkedPair> pairs;
    std::vector<Eigen::MatrixXcd> Xo;  ///< per line: r x response points
    std::vector<Eigen::MatrixXcd> Xi;  ///< per line: r x reference points
    Eigen::MatrixXcd own;              ///< lines x candidates: b H* b'
    /// What channels at fault multiply the FRFs of `pairs` by, lines x pairs.
    Eigen::MatrixXcd recorded;
  };
  /// @param candidates r x c, rows b of V as columns
  [[nodiscard]] std::vector<Walk> walk_columns(
      const ModelState& state,
      const Eigen::VectorXcd& s,
      const Eigen::MatrixXd& candidates) const;

  /// What each FRF of the set was measured between, without the mistakes that
  /// are among the state's effects.
  [[nodiscard]] std::vector<PairEnds> ends(const ModelState& state) const;

  [[nodiscard]] const ReducedBase& base() const { return base_; }
  [[nodiscard]] const effects::TestContext& context() const { return context_; }
  /// Row of V for a degree of freedom of the deck.
  [[nodiscard]] Eigen::RowVectorXd row(int node, int component) const;
  [[nodiscard]] Eigen::RowVectorXd row(const effects::InterfaceDof& dof) const;

  /// The same model on the deck's own mesh, where this one's is split; else
  /// null.
  [[nodiscard]] const FrfModel* coarser() const { return coarser_.get(); }
  void set_coarser(std::shared_ptr<const FrfModel> coarser) {
    coarser_ = std::move(coarser);
  }

  /// Keeps the order of the damping ratios when modes change places: modes at
  /// later states are matched to those at this one.
  void set_reference(const ModelState& state);

  /// Gives a factor that K and M are linear in, and that no other multiplies,
  /// other matrices, r x r.
  void set_part(std::size_t factor, Eigen::MatrixXd K, Eigen::MatrixXd M);

 private:
  /// @param bare base_modes() of the state
  [[nodiscard]] ModalState modal_state(const ModelState& state,
                                       BaseModes bare) const;
  [[nodiscard]] ModelResponse respond(ModalState& shared,
                                      const Eigen::VectorXcd& s,
                                      bool derivatives) const;
  [[nodiscard]] std::vector<Eigen::MatrixXcd> recorded_at_sizes(
      const ModelState& state,
      const std::vector<std::vector<double>>& sizes,
      const Eigen::VectorXcd& s) const;
  [[nodiscard]] std::vector<PairedMode> paired(
      const BaseModes& modes, const Eigen::MatrixXd& at_points) const;
  [[nodiscard]] ModelResponse respond_modes(ModalState& shared,
                                            bool derivatives) const;
  [[nodiscard]] std::vector<Walk> walk_modes(
      const ModelState& state,
      const Eigen::VectorXcd& s,
      const Eigen::MatrixXd& candidates) const;
  [[nodiscard]] FormPatterns form_patterns_of_modes(
      const ModelState& state) const;
  // Of which part a factor is that K and M are linear in.
  [[nodiscard]] std::size_t part_of(std::size_t factor) const;
  // A pattern's deviation from what the mesh leaves, beside its tau.
  [[nodiscard]] double left_by_mesh(const ModelState& state,
                                    const BaseModes& modes,
                                    const FormEntry& entry) const;
  // By which parameters the modes turn, and how.
  void find_turning(ModalState& shared, double largest) const;
  [[nodiscard]] RunResponse run_lines(const ModalState& shared,
                                      std::size_t run) const;
  [[nodiscard]] std::vector<RunResponse> walks(const ModalState& shared) const;
  [[nodiscard]] std::vector<PairEnds> ends(const TestAsDone& done) const;
  [[nodiscard]] Eigen::VectorXd point(const Dof& dof) const;
  [[nodiscard]] std::vector<int> damping_owners(const ModelState& state,
                                                const BaseModes& bare) const;
  void set_damping(ModalState& shared) const;

  ReducedBase base_;
  effects::TestContext context_;
  std::shared_ptr<const ModalData> modes_;
  std::vector<MeasuredPair> pairs_;
  Eigen::MatrixXd points_;  // r x points: signed rows of V, each once
  std::map<Dof, Eigen::Index> columns_;  // of the points
  Eigen::MatrixXd dashpots_;  // r x rank, C = dashpots_ dashpots_' of the deck
  std::vector<std::size_t> runs_;
  Eigen::MatrixXd reference_phi_;
  std::shared_ptr<const FrfModel> coarser_;
};

}  // namespace tapfit::updating
