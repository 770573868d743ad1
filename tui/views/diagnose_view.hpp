// Screen 5: which physical effect is missing, where, how large, how sure.
#pragma once

#include "tui/views/candidate_table.hpp"
#include "tui/views/page.hpp"
#include "tui/widgets/plot_range.hpp"
#include "updating/localisation/signature.hpp"

#include <optional>
#include <utility>

namespace tapfit::tui {

/// What is shown: the diagnosis of the model, what it has tried so far, or that
/// of the model before.
enum class Standing { Final, Preliminary, Outdated };

struct DiagnoseInput {
  const acquisition::TestBundle& bundle;
  const updating::Diagnosis& diagnosis;
  const std::map<int, std::shared_ptr<const updating::Signature>>& signatures;
  const Wireframe* wire = nullptr;
  /// How well each grid alone explains what is missing, once it is known.
  const std::vector<updating::GridShare>* map = nullptr;
  Standing standing = Standing::Final;
  const structure::Deck* deck = nullptr;  ///< for where elements are
};

struct DiagnoseState {
  ListState list;  ///< candidates
  /// To be added together; also such as are not in the list (any more).
  std::vector<updating::EffectRef> tagged;
  PlotRange range;  ///< [Hz], of the signature
  Pose pose;
  bool map = false;       ///< all grids instead of the candidate's place
  bool all_laws = false;  ///< mass, spring and dashpot, not the best alone
  /// All in words, from that line on, in place of table and plots.
  std::optional<int> details = {};
  /// How firm the verdict is, likewise.
  std::optional<int> firmness = {};
};

[[nodiscard]] Screen diagnose_view(const DiagnoseInput& input,
                                   const DiagnoseState& state,
                                   const Canvas& canvas);

/// Grids that the place means: its own, those of its channels' sensors, or its
/// elements' corners where there is a deck.
[[nodiscard]] std::vector<int> grids_of(const acquisition::TestBundle& bundle,
                                        const updating::Where& where,
                                        const structure::Deck* deck = nullptr);

/// The grid that the candidate's missing stiffness is drawn of; none where it
/// acts on several, and for a mistake of the set-up, which acts on none.
[[nodiscard]] std::optional<int> signature_grid(
    const acquisition::TestBundle& bundle,
    const updating::Candidate& candidate);

class DiagnosePage final : public Page {
 public:
  std::string title() const override { return "Diagnose"; }
  bool wants_model() const override { return true; }
  /// What the diagnosis makes on its way is asked for first, so that the other
  /// screens have it while the diagnosis runs.
  std::vector<Need> essential() const override {
    return {{Stage::Frfs},
            {Stage::Modes},
            {Stage::BaseComparison},
            {Stage::Comparison},
            {Stage::Ladder},
            {Stage::Diagnosis}};
  }
  /// After a change the last list stays until there is something new, and what
  /// is tried first is listed until all is.
  bool can_wait_for(const Need& need, const Snapshot& known) const override;
  std::vector<Need> welcome(const Snapshot& known) const override;
  Screen draw(const Snapshot& known, const Canvas& canvas) const override;
  bool press(const Snapshot& known, Key key, Command& command) override;
  /// The cursor stays on its candidate, or goes to the first where that is no
  /// more.
  void follow(const Snapshot& before, const Snapshot& now) override;
  /// What was tagged has been added.
  void untag() { state_.tagged.clear(); }
  bool leave_view() override;
  ListState* list() override { return &state_.list; }
  PlotRange* range() override { return &state_.range; }
  std::vector<KeyHelp> keys() const override;
  std::string help() const override;

 private:
  bool press_firmness(const updating::Diagnosis& d, Key key);
  bool press_details(const updating::Diagnosis& d, const Table& table, Key key);
  void press_tag(const updating::Diagnosis& d,
                 const Table& table,
                 Command& command);
  void add_chosen(const updating::Diagnosis& d,
                  const Table& table,
                  Command& command) const;

  DiagnoseState state_;
};

}  // namespace tapfit::tui
