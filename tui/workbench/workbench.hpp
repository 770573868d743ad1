// What the screens ask of the work behind them. Two implementations: the
// session over a test bundle, and a made-up one that tests drive.
#pragma once

#include "acquisition/foundation/finding.hpp"
#include "acquisition/foundation/progress.hpp"
#include "acquisition/hits/hits.hpp"
#include "updating/localisation/signature.hpp"
#include "updating/session/added_effect.hpp"
#include "updating/session/session.hpp"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tapfit::tui {

/// What can be written for others to read.
enum class Output { Report, Uff, Deck };

/// What became of saving.
struct Saving {
  bool overtaken = false;  ///< another window saved first; nothing was written
  std::string failure;     ///< what went wrong, if anything
};

/// As updating::Session; every call may take long and is made on the worker's
/// thread only, but for those without Progress, which are quick.
class Workbench {
 public:
  Workbench() = default;
  Workbench(const Workbench&) = delete;
  Workbench& operator=(const Workbench&) = delete;
  virtual ~Workbench() = default;

  virtual const acquisition::TestBundle& bundle() = 0;
  virtual bool has_model() = 0;
  virtual const structure::Deck& deck(const Progress&) = 0;
  virtual const std::vector<acquisition::Recording>& recordings(
      const Progress&) = 0;
  /// Runs that cannot be used, as far as recordings() and hits() have shown.
  virtual std::vector<acquisition::LeftOut> left_out() = 0;
  virtual const acquisition::HitSet& hits(const Progress&) = 0;
  /// What is wrong with the test, told before any model; errors first.
  virtual std::vector<Finding> findings(const Progress&) = 0;
  virtual const signal::FrfSet& frfs(const Progress&) = 0;
  virtual const modal::ModeSet& modes(const Progress&) = 0;
  virtual const updating::Comparison& comparison(const Progress&) = 0;
  virtual const updating::Comparison& base_comparison(const Progress&) = 0;
  virtual const updating::Diagnosis& diagnosis(const Progress&) = 0;
  /// The same with what becomes of it when what was assumed is changed.
  virtual const updating::Diagnosis& robust_diagnosis(const Progress&) = 0;
  /// As of an earlier run of the program, with the first of the effects.
  virtual std::optional<updating::Diagnosis> known_diagnosis(
      std::size_t effects, const Progress&) = 0;
  virtual updating::Signature signature(int node, const Progress&) = 0;
  virtual updating::EffectEvidence evidence(
      const updating::EffectRef& effect,
      const std::vector<updating::EffectRef>& added,
      const Progress&) = 0;
  virtual std::vector<updating::GridShare> localisation_map(
      const Progress&) = 0;
  virtual std::vector<updating::UpdateRecord> update_records(
      const Progress&) = 0;
  virtual std::vector<updating::Rung> ladder(const Progress&) = 0;
  virtual std::vector<updating::Estimate> model_parameters(const Progress&) = 0;

  virtual void overrule_hit(std::size_t run, std::size_t hit) = 0;
  /// What is to hold about the modes from now on; where it fails, all stays.
  virtual void choose_modes(const updating::ModeChoices&, const Progress&) = 0;
  virtual updating::ModeChoices mode_choices() = 0;
  virtual bool undo_modes(const Progress&) = 0;
  virtual bool redo_modes(const Progress&) = 0;
  virtual updating::EffectRef parse_effect(const std::string& text) = 0;
  virtual void add_together(const std::vector<updating::EffectRef>&,
                            const Progress&) = 0;
  virtual void toggle(std::size_t effect, const Progress&) = 0;
  virtual bool undo(const Progress&) = 0;
  virtual bool redo(const Progress&) = 0;
  virtual std::vector<updating::AddedEffect> effects() = 0;

  /// Writes a file, of a deck in several files those that change; never over
  /// an input of the test.
  /// @param replace over a file that is there
  /// @return what was written, and what of it is to be known
  virtual std::string write(Output what,
                            const std::filesystem::path& to,
                            bool replace,
                            const Progress&) = 0;
  /// How hits had been judged by hand when it was opened.
  virtual updating::HitActs hit_acts() = 0;
  /// Takes over what another window did to the test and saved, in place of
  /// what was done here: that was in it. How hits are judged by hand then;
  /// none where nothing is new.
  /// @throws InputError for a saved session that cannot be read
  virtual std::optional<updating::HitActs> catch_up(const Progress&) = 0;
  /// Writes down what was done so far, with how hits were judged by hand.
  virtual Saving save(const updating::HitActs& acts, const Progress&) = 0;
};

}  // namespace tapfit::tui
