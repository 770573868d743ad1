// Looks for the next effect of the error ladder: all hypotheses on top of what
// is in the model, their evidence, and second thoughts about earlier rungs.
#pragma once

#include "updating/diagnosis/candidate_ranking.hpp"
#include "updating/diagnosis/diagnose_options.hpp"
#include "updating/diagnosis/patch_extent.hpp"
#include "updating/diagnosis/rivals.hpp"
#include "updating/effects/effect_ref.hpp"

#include <optional>
#include <string>
#include <vector>

namespace tapfit::updating {

/// An effect that is in the model, as the round that chose it saw it.
struct SelectedEffect {
  std::string name;  ///< its kind, or the group of kinds not told apart
  double probability = 0.0;
  std::vector<EffectRef> alike = {};  ///< what was not told apart from it
  /// Of a patch that is not the only one.
  std::optional<PatchExtent> extent = {};
  std::vector<double> place_sd = {};  ///< see EffectRef
  std::vector<MadeFit> tried = {};    ///< itself first, see Rivals
};

class ForwardSelection {
 public:
  ForwardSelection(const Fitter& fitter, const DiagnoseOptions& options);

  enum class Depth {
    Quick,      ///< only what the screening finds promising, at its best place
    Nearby,     ///< the same, and better places around
    Thorough,   ///< several places of every kind, and better ones around
    LastResort  ///< many joints besides: a soft one is far from first order
  };

  /// Everything that could be added to the model as it is.
  /// @param known one of them that is fitted already
  /// @param rival of other effects, see HypothesisOptions
  [[nodiscard]] CandidateRanking look(const Fit& current,
                                      Depth depth,
                                      const Progress& progress,
                                      const Fit* known = nullptr,
                                      const Fit* rival = nullptr) const;

  /// A quick look with other forms of what is few and comes near, unless
  /// something explains all.
  [[nodiscard]] CandidateRanking with_forms(CandidateRanking round,
                                            const Fit& current,
                                            const Progress& progress) const;

  /// A hypothesis of the round as it is added to the model.
  ///
  /// @param of its place there
  [[nodiscard]] SelectedEffect as_selected(const CandidateRanking& round,
                                           std::size_t of) const;

  /// A first rung that leaves much may be a stand-in for two effects. Each
  /// other kind's best that says more than none is given the chance of a second
  /// rung; the pair that leaves least names the first rung.
  struct Pair {
    std::size_t first = 0;  ///< in the round
    double gain = 0.0;      ///< log evidence of both over none
    /// A quick look at what the first leaves, where there was one.
    std::optional<CandidateRanking> next = {};
  };
  [[nodiscard]] Pair best_pair(const Fit& current,
                               const CandidateRanking& round,
                               const Progress& progress) const;

  /// With several effects in, each but the last is looked for again while the
  /// others stay: it was found before the others were known.
  [[nodiscard]] Fit relocate(Fit fit,
                             std::size_t already,
                             std::vector<SelectedEffect>& chosen,
                             const Progress& progress) const;

  /// A support that turns and shifts, found one after the other, is one effect
  /// with both, as are masses of some sensors and of others; kept where it
  /// explains as much, or is as likely by its fewer parameters.
  [[nodiscard]] Fit unite(Fit fit,
                          std::size_t already,
                          std::vector<SelectedEffect>& chosen,
                          const Progress& progress) const;

  /// Takes effects off that the others have made superfluous, and of two that
  /// give way at one place the one without which the error is at the floor.
  [[nodiscard]] Fit prune(Fit fit,
                          std::size_t already,
                          double data,
                          std::vector<SelectedEffect>& chosen,
                          const Progress& progress) const;

 private:
  void put_in_order(CandidateRanking& round, const Fit& current) const;
  static void weigh(CandidateRanking& round);
  void settle_places(const Fit& current,
                     CandidateRanking& round,
                     const Progress& progress) const;
  void judge_anew(const CandidateRanking& round,
                  const EffectInstance& effect,
                  SelectedEffect& it) const;
  [[nodiscard]] Fit with_last(const Fit& fit,
                              std::size_t k,
                              const Progress& progress) const;
  [[nodiscard]] bool is_part_of_another(const Fit& fit,
                                        std::size_t k,
                                        const Fit& rest,
                                        const Progress& progress) const;
  [[nodiscard]] bool is_likelier(const Fit& united, const Fit& apart) const;
  [[nodiscard]] Fit without_one(const Fit& fit,
                                std::size_t k,
                                const Progress& progress) const;
  [[nodiscard]] Fit refit(const std::vector<EffectInstance>& effects,
                          const Progress& progress) const;

  const Fitter* fitter_;
  DiagnoseOptions options_;
};

}  // namespace tapfit::updating
