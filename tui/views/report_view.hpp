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
  /// Without a model the modes are what there is to report.
  std::vector<Need> essential() const override {
    if (!model_) return {{Stage::Modes}};
    return {{Stage::BaseComparison}, {Stage::Comparison}, {Stage::Ladder}};
  }
  /// The deck, to compare with.
  std::vector<Need> welcome(const Snapshot& known) const override {
    if (!known.has_model) return {};
    return {{Stage::Model}};
  }
  void follow(const Snapshot&, const Snapshot& now) override {
    model_ = now.has_model;
  }
  Screen draw(const Snapshot& known, const Canvas& canvas) const override;
  bool press(const Snapshot& known, Key key, Command& command) override;
  std::vector<KeyHelp> keys(const Snapshot& known) const override;
  std::string help() const override;

 private:
  /// Moves over the columns of the MACs. @pre with a model
  bool press_mac(const Snapshot& known, Key key);

  ReportState state_;
  bool model_ = true;  ///< the bundle has one
};

}  // namespace tapfit::tui
