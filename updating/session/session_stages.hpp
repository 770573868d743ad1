// The stages of one test as far as they are worked out: each is made when it is
// first asked for and dropped when one to its left changes. A Session acts on
// them.
#pragma once

#include "updating/comparison/comparison.hpp"
#include "updating/diagnosis/diagnosis.hpp"
#include "updating/fit/corrected_model.hpp"
#include "updating/fit/fit_context.hpp"
#include "updating/fit/plain_fit.hpp"
#include "updating/fit/rung.hpp"
#include "updating/measurement/measurement.hpp"
#include "updating/session/diagnosis_cache.hpp"
#include "updating/session/effect_stack.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace tapfit::updating {

/// The model with more effects, to see what they do.
struct TriedStack {
  std::vector<EffectRef> added;
  EffectStack stack;
};

struct SessionStages {
  SessionStages(const std::filesystem::path& folder,
                acquisition::Unreadable unreadable)
      : test(folder, unreadable) {}
  explicit SessionStages(const Measurement& of) : test(of) {}

  Measurement test;
  std::optional<structure::Deck> deck;
  std::optional<SolvedModel> model;
  std::optional<FitContext> ground;  ///< and with it the stack
  /// Of the deck with numbers put right, as effects ask for it.
  std::vector<std::unique_ptr<CorrectedModel>> corrected;
  std::optional<EffectStack> stack;
  std::vector<ModeChoices> past_choices;
  std::vector<ModeChoices> future_choices;
  EffectHistory waiting;  ///< to be in the stack, once there is one
  UpdateChoice choice;
  std::optional<PlainTask> plain;  ///< where the choice is a plain one
  std::optional<Comparison> base_comparison;
  std::optional<Comparison> comparison;
  std::optional<Diagnosis> diagnosis;
  /// Of the deck's form, the least that a diagnosis of this test leaves it.
  std::optional<double> form_error;
  /// Of the deck, as a diagnosis of this test put it right; empty: it is right.
  std::vector<EffectInstance> put_right;
  std::vector<Rung> ladder;
  std::optional<Fit> likeliest;
  std::optional<TriedStack> tried;

  /// The deck, read once. @throws InputError
  const structure::Deck& read_model(const Progress& progress);
  /// Model, damped lines and the base fit; all that does not depend on effects.
  void prepare_fit(const Progress& progress);

  /// What a diagnosis that was asked for says of the floor: how much the deck's
  /// form explains at most, and whether it is the floor of another deck.
  void take_floor(const Diagnosis& of, const Progress& progress);
  /// Of the current model, by what diagnoses said of it.
  void limit_floor(Comparison& current, const Progress& progress);
  /// Drops what follows from the FRFs; the effects wait to be put in again.
  void drop_from_frfs();
  /// Drops what follows from the effects.
  void drop_current();
  void change_modes(const ModeChoices& choices, const Progress& progress);
  /// Takes up the last choices of `from`; `to` keeps those of now.
  /// @return false where there is none
  bool move_choices(std::vector<ModeChoices>& from,
                    std::vector<ModeChoices>& to,
                    const Progress& progress);

  // Of what prepare_fit() has made.
  /// Of the deck as the effects want it.
  [[nodiscard]] const FitContext& ground_of(
      const std::vector<EffectInstance>& effects,
      const Progress& progress = {});
  [[nodiscard]] const FitContext& ground_now() {
    return ground_of(current().effects);
  }
  [[nodiscard]] effects::TestContext context() const;
  [[nodiscard]] MeasuredTest measured();
  [[nodiscard]] StackFit stack_fit();
  [[nodiscard]] const Fit& current() const { return stack->fits().back(); }
  /// The same with the parameters that are likeliest, as a diagnosis tells them
  /// (likeliest_fit.hpp); as it is where lines or prior were chosen by hand.
  [[nodiscard]] const Fit& current_likeliest();
  [[nodiscard]] Comparison compare_now(const Fit& fit);
  /// With the first so many effects.
  [[nodiscard]] DiagnosisCache diagnosis_cache(std::size_t effects);

 private:
  void stack_waiting(const Progress& progress);
  [[nodiscard]] Fit fit_now(const std::vector<EffectInstance>& effects,
                            const Fit& before,
                            const Progress& progress);
};

}  // namespace tapfit::updating
