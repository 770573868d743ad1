// Screen 5: which physical effect is missing, where, how large, how sure.
#pragma once

#include "tui/views/candidate_table.hpp"
#include "tui/views/diagnose_panels.hpp"
#include "tui/views/page.hpp"

namespace tapfit::tui {

[[nodiscard]] Screen diagnose_view(const DiagnoseInput& input,
                                   const DiagnoseState& state,
                                   const Canvas& canvas);

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
  /// The cursor stays on its candidate. Where a list does not have the one that
  /// the user went to, it is on none, and comes back as soon as one has it.
  void follow(const Snapshot& before, const Snapshot& now) override;
  /// What was tagged has been added.
  void untag() { state_.tagged.clear(); }
  bool leave_view() override;
  ListState* list() override { return &state_.list; }
  PlotRange* range() override { return &state_.range; }
  std::vector<KeyHelp> keys(const Snapshot& known) const override;
  std::string help() const override;

 private:
  /// What the cursor is on, or was before a list came without it; none where
  /// that is nothing that anybody chose.
  std::optional<updating::EffectRef> stood_on(const Snapshot& known);
  /// The key is for the candidate that is not listed now.
  bool acts_on_nothing(const updating::Diagnosis& d, Key key) const;
  bool press_firmness(const updating::Diagnosis& d, Key key);
  bool press_details(const updating::Diagnosis& d, const Table& table, Key key);
  bool press_plot(const Snapshot& known, Key key, Command& command);
  /// The chosen one has a signature, and FRFs with and without it.
  bool has_two_plots(const Snapshot& known) const;
  void press_tag(const updating::Diagnosis& d,
                 const Table& table,
                 Command& command);
  void add_chosen(const updating::Diagnosis& d,
                  const Table& table,
                  Command& command) const;

  DiagnoseState state_;
  /// What the user went to, until they go elsewhere.
  std::optional<updating::EffectRef> chosen_;
};

}  // namespace tapfit::tui
