// Screen 7: what was found, before and after.
#pragma once

#include "tui/views/page.hpp"

namespace tapfit::tui {

struct ReportInput {
  const updating::Comparison& base;
  const updating::Comparison& current;
  const std::vector<updating::Rung>& ladder;
  const std::vector<updating::Estimate>& parameters;
  /// Of the base model and of the current one, by how many effects are in it.
  std::map<std::size_t, std::shared_ptr<const updating::Diagnosis>> diagnoses;
  std::vector<std::string> warnings;
  const acquisition::TestBundle* bundle = nullptr;
  const structure::Deck* deck = nullptr;  ///< to compare what was identified
};

struct ReportState {
  int first_row = 0;
  int mac_column = 0;  ///< of the model's modes the first in the MACs
};

/// The whole report as a screen as tall as it takes, whatever the canvas's
/// height; the page scrolls it.
[[nodiscard]] Screen report_sheet(const ReportInput& input,
                                  Canvas canvas,
                                  int mac_column = 0);

/// `first_row` rows down, in the canvas.
[[nodiscard]] Screen report_view(const ReportInput& input,
                                 const ReportState& state,
                                 const Canvas& canvas);

class ReportPage final : public Page {
 public:
  std::string title() const override { return "Report"; }
  bool wants_model() const override { return true; }
  std::vector<Need> essential() const override {
    return {{Stage::BaseComparison}, {Stage::Comparison}, {Stage::Ladder}};
  }
  /// The deck, to compare with.
  std::vector<Need> welcome(const Snapshot&) const override {
    return {{Stage::Model}};
  }
  Screen draw(const Snapshot& known, const Canvas& canvas) const override;
  bool press(const Snapshot& known, Key key, Command& command) override;
  bool press_without_model(Key key, Command& command) override;
  std::vector<KeyHelp> keys() const override;
  std::vector<KeyHelp> keys_without_model() const override;
  std::string help() const override;

 private:
  ReportState state_;
};

}  // namespace tapfit::tui
