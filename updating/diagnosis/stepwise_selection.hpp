// The effects that the error ladder is made of, chosen one after another.
#pragma once

#include "updating/comparison/form_share.hpp"
#include "updating/diagnosis/diagnosis.hpp"
#include "updating/diagnosis/error_ladder.hpp"
#include "updating/diagnosis/forward_selection.hpp"
#include "updating/diagnosis/worth.hpp"

#include <cmath>
#include <optional>
#include <vector>

namespace tapfit::updating {

/// What is in the model so far, and why: one effect after another, as long as
/// each earns its place.
class StepwiseSelection {
 public:
  StepwiseSelection(const Fitter& fitter,
                    const std::vector<EffectInstance>& present,
                    const DiagnoseOptions& options,
                    const Progress& progress)
      : fitter_(&fitter),
        options_(options),
        search_(fitter, options),
        already_(present.size()),
        current_(fitter.fit(present, fitter.model_for(present), progress)),
        base_error_(current_.result.error),
        held_out_(fitter.held_out_error(current_, held_out_folds, progress)) {}

  /// Adds the best effect that earns its place; false where none does.
  bool step(bool first, const Progress& progress);
  /// Takes back a first effect that was added for what it is worth beside
  /// another, where no other followed.
  void settle();

  [[nodiscard]] const Fit& current() const { return current_; }
  [[nodiscard]] double held_out_error() const { return held_out_; }
  /// @param likeliest what is in the model, with the parameters to be told
  [[nodiscard]] std::vector<Rung> ladder(const Fit& likeliest,
                                         const Progress& progress) const {
    return ladder_of(likeliest, chosen_, already_, *fitter_, progress);
  }
  [[nodiscard]] const std::vector<SelectedEffect>& chosen() const {
    return chosen_;
  }
  /// The strongest that did not earn their place on top.
  [[nodiscard]] const std::vector<MadeFit>& passed_over() const {
    return passed_over_;
  }
  /// Everything tried on the first step.
  [[nodiscard]] std::vector<Candidate> candidates() const {
    return candidates_;
  }

 private:
  bool try_to_add(bool first,
                  ForwardSelection::Depth depth,
                  const Progress& progress);
  // Where a selection stands.
  struct Stand {
    Fit fit;
    double held_out = 0.0;
  };

  // Which of the round to add, what it must be worth, and what comes after it
  // where that was looked at.
  struct Choice {
    std::size_t best = 0;
    Worth worth;
    std::optional<CandidateRanking> next;
  };
  [[nodiscard]] Choice choose(const CandidateRanking& round,
                              bool first,
                              const Progress& progress) const;
  [[nodiscard]] FormShare form_of(const Fit& fit) const {
    return form_share(fit, fitter_->target(), options_.floor_noise);
  }
  [[nodiscard]] Floor floor() const {
    return floor_of(current_, fitter_->target(), options_);
  }
  // More than noise, mesh and form explain.
  [[nodiscard]] bool leaves_much(const Fit& fit) const {
    return form_of(fit).left > clear_of_floor * options_.floor;
  }
  // Where the verdict would have to say so.
  [[nodiscard]] bool is_left_unexplained() const {
    const double floor = std::hypot(options_.floor, form_of(current_).error);
    return leaves_much(current_) &&
           is_unexplained(
               current_.result.error, floor, base_error_, !chosen_.empty());
  }

  const Fitter* fitter_;
  DiagnoseOptions options_;
  ForwardSelection search_;
  std::size_t already_;
  Fit current_;
  double base_error_;
  double held_out_;
  std::optional<Stand> before_pair_;
  std::optional<CandidateRanking>
      next_;  // a quick look from where the selection stands
  std::vector<SelectedEffect> chosen_;
  std::vector<Candidate> candidates_;
  std::vector<MadeFit> passed_over_;
};

}  // namespace tapfit::updating
