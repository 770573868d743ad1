// Looks for the next effect of the error ladder: all hypotheses on top of what
// is in the model, their evidence, and second thoughts about earlier rungs.
#pragma once

#include "updating/diagnosis/diagnose_options.hpp"
#include "updating/diagnosis/hypotheses.hpp"
#include "updating/diagnosis/patch_extent.hpp"
#include "updating/effects/effect_ref.hpp"

#include <optional>
#include <string>
#include <vector>

namespace tapfit::updating {

/// What was found on one rung.
struct Round {
  std::vector<Hypothesis> hypotheses;  ///< strongest evidence first
  std::vector<double> probability;     ///< of none, then of each hypothesis
  double none_evidence = 0.0;
  double data = 1.0;  ///< independent data that the evidence counts
};

/// An effect that is in the model, as the round that chose it saw it.
struct Chosen {
  std::string name;  ///< its kind, or the group of kinds not told apart
  double probability = 0.0;
  std::vector<EffectRef> alike = {};  ///< what was not told apart from it
  /// Of a patch that is not the only one.
  std::optional<PatchExtent> extent = {};
  std::vector<double> place_sd = {};  ///< see Hypothesis
};

/// Explanations closer than this in log evidence are not told apart: 20 : 1,
/// where "positive" evidence ends on Kass and Raftery's scale.
extern const double look_alike;
/// "Very strong" evidence on that scale, 150 : 1.
extern const double very_strong;
/// A fit within this factor of the floor leaves nothing to explain.
extern const double at_floor;
/// Beyond this times the floor there is surely more than one rung can explain,
/// and what an effect below the mesh's floor must be better by to be believed.
extern const double clear_of_floor;

/// Its kind and those that are not told apart from it, joined with "|"; at most
/// three.
[[nodiscard]] std::string group_name(const Round& round, std::size_t of);

/// The other hypotheses that are not told apart from one: their evidence is, or
/// they say the same of all that was measured with no more parameters.
[[nodiscard]] std::vector<EffectRef> look_alikes(const Round& round,
                                                 std::size_t of);

class RungSearch {
 public:
  RungSearch(const Fitter& fitter, const DiagnoseOptions& options);

  enum class Depth {
    Quick,      ///< only what the screening finds promising, at its best place
    Nearby,     ///< the same, and better places around
    Thorough,   ///< several places of every kind, and better ones around
    LastResort  ///< many joints besides: a soft one is far from first order
  };

  /// Everything that could be added to the model as it is.
  /// @param known one of them that is fitted already, see HypothesisOptions
  [[nodiscard]] Round look(const Fit& current,
                           Depth depth,
                           const Progress& progress,
                           const Fit* known = nullptr) const;

  /// A hypothesis of the round as it is added to the model.
  ///
  /// @param of its place there
  [[nodiscard]] Chosen as_chosen(const Round& round, std::size_t of) const;

  /// A first rung that leaves much may be a stand-in for two effects. Each
  /// other kind's best is given the chance of a second rung; the pair that
  /// leaves least names the first rung.
  struct Pair {
    std::size_t first = 0;  ///< in the round
    double gain = 0.0;      ///< log evidence of both over none
  };
  [[nodiscard]] Pair best_pair(const Fit& current,
                               const Round& round,
                               const Progress& progress) const;

  /// With several effects in, each but the last is looked for again while the
  /// others stay: it was found before the others were known.
  [[nodiscard]] Fit relocate(Fit fit,
                             std::size_t already,
                             std::vector<Chosen>& chosen,
                             const Progress& progress) const;

  /// Takes effects off that the others have made superfluous.
  [[nodiscard]] Fit prune(Fit fit,
                          std::size_t already,
                          double data,
                          std::vector<Chosen>& chosen,
                          const Progress& progress) const;

 private:
  void judge(Round& round) const;
  void settle_places(const Fit& current,
                     Round& round,
                     const Progress& progress) const;
  void judge_anew(const Round& round,
                  const PlacedEffect& effect,
                  Chosen& it) const;
  [[nodiscard]] Fit with_last(const Fit& fit,
                              std::size_t k,
                              const Progress& progress) const;
  [[nodiscard]] Fit refit(const std::vector<PlacedEffect>& effects,
                          const Progress& progress) const;

  const Fitter* fitter_;
  DiagnoseOptions options_;
  double explained_;  // an error at which nothing is left to explain
};

}  // namespace tapfit::updating
