// Screen 7: what was found, before and after.
#pragma once

#include "tui/views/page.hpp"

namespace tapfit::tui {

struct ReportInput {
  const updating::Comparison& base;
  const updating::Comparison& current;
  const std::vector<updating::Rung>& ladder;
  const std::vector<updating::Estimate>& parameters;
  /// Those that were made, by how many effects were in the model then.
  std::map<std::size_t, std::shared_ptr<const updating::Diagnosis>> diagnoses;
  std::vector<std::string> warnings;
};

/// The whole report as a screen as tall as it takes; the page scrolls it.
[[nodiscard]] Screen report_sheet(const ReportInput& input,
                                  int width,
                                  bool ascii);

/// `first_row` rows down, in the canvas.
[[nodiscard]] Screen report_view(const ReportInput& input,
                                 int first_row,
                                 const Canvas& canvas);

class ReportPage final : public Page {
 public:
  std::string title() const override { return "Report"; }
  bool wants_model() const override { return true; }
  std::vector<Need> essential() const override {
    return {{Stage::BaseComparison}, {Stage::Comparison}, {Stage::Ladder}};
  }
  Screen draw(const Snapshot& known, const Canvas& canvas) const override;
  bool press(const Snapshot& known, Key key, Command& command) override;
  bool press_without_model(Key key, Command& command) override;
  std::vector<KeyHelp> keys() const override;
  std::vector<KeyHelp> keys_without_model() const override;
  std::string help() const override;

 private:
  int first_row_ = 0;
};

}  // namespace tapfit::tui
