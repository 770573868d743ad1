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
        stand_{fitter.fit(present, fitter.model_for(present), progress)},
        base_error_(current().result.error) {
    stand_.held_out =
        fitter.held_out_error(current(), held_out_folds, progress);
  }

  /// Adds the best effect that earns its place; false where none does.
  bool step(bool first, const Progress& progress);
  /// Where a first effect was added for what it is worth beside another, and no
  /// other followed: what led by itself takes its place, or nothing does.
  ///
  /// @return whether there is one now that others may follow
  bool settle();

  [[nodiscard]] const Fit& current() const { return stand_.fit; }
  /// Of the effects so far, on runs left out; 0 where there are none.
  [[nodiscard]] double held_out_error() const {
    return has_other_runs(fitter_->target()) ? stand_.held_out : 0.0;
  }
  /// @param likeliest what is in the model, with the parameters to be told
  [[nodiscard]] std::vector<Rung> ladder(const Fit& likeliest,
                                         const Progress& progress) const {
    return ladder_of(likeliest, chosen(), already_, *fitter_, progress);
  }
  [[nodiscard]] const std::vector<SelectedEffect>& chosen() const {
    return stand_.chosen;
  }
  /// The strongest that did not earn their place on top.
  [[nodiscard]] const std::vector<MadeFit>& passed_over() const {
    return stand_.passed_over;
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
    Fit fit = {};
    double held_out = 0.0;  // error of the fit on left-out runs
    std::vector<SelectedEffect> chosen = {};
    std::vector<MadeFit> passed_over = {};
  };

  // Which of the round to add, what it must be worth, and what comes after it
  // where that was looked at.
  struct Choice {
    std::size_t best = 0;
    Worth itself;
    Worth together;  // with what comes after it
    std::optional<CandidateRanking> next;
  };
  // @param leader what the first of the round is worth by itself
  [[nodiscard]] Choice choose(const CandidateRanking& round,
                              const Worth& leader,
                              bool first,
                              const Progress& progress) const;
  [[nodiscard]] Worth by_itself(const Hypothesis& it,
                                const Progress& progress) const;
  // One more of the round, worth its place only once what was chosen before
  // has moved: alone it sat where it made up for both.
  // @return nothing where there is none
  [[nodiscard]] std::optional<Stand> with_others_moved(
      const CandidateRanking& round, const Progress& progress) const;
  // @return false where it comes to what there is
  bool add(Stand more, double data, const Progress& progress);
  [[nodiscard]] FormShare form_of(const Fit& fit) const {
    return form_share(fit, fitter_->target(), options_.floor_noise);
  }
  [[nodiscard]] Floor floor() const {
    return floor_of(current(), fitter_->target(), options_);
  }
  // More than noise, mesh and form explain.
  [[nodiscard]] bool leaves_much(const Fit& fit) const {
    return form_of(fit).left > clear_of_floor * options_.floor;
  }
  // Where the verdict would have to say so.
  [[nodiscard]] bool is_left_unexplained() const {
    return leaves_much(current()) &&
           is_unexplained(current().result.error,
                          told_floor(current(), fitter_->target(), options_),
                          base_error_,
                          !chosen().empty());
  }

  const Fitter* fitter_;
  DiagnoseOptions options_;
  ForwardSelection search_;
  std::size_t already_;
  Stand stand_;
  double base_error_;
  std::optional<Stand> without_second_;  // where none follows
  std::optional<CandidateRanking>
      next_;  // a quick look from where the selection stands
  std::vector<Candidate> candidates_;
};

}  // namespace tapfit::updating
