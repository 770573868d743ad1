// Screen 2: measured frequency response functions.
#pragma once

#include "tui/views/frf_checks_view.hpp"
#include "tui/views/frf_state.hpp"
#include "tui/views/page.hpp"
#include "tui/widgets/plot_range.hpp"

#include <optional>
#include <utility>

namespace tapfit::tui {

/// @param checks empty while they are not known
[[nodiscard]] Screen frf_view(const signal::FrfSet& frfs,
                              const FrfState& state,
                              const Canvas& canvas,
                              const signal::FrfChecks* checks = nullptr);

class FrfPage final : public Page {
 public:
  explicit FrfPage(FrfState start) : state_(std::move(start)) {}
  std::string title() const override { return "FRF"; }
  std::vector<Need> essential() const override { return {{Stage::Frfs}}; }
  std::vector<Need> welcome(const Snapshot&) const override {
    return {{Stage::FrfChecks}};
  }
  Screen draw(const Snapshot& known, const Canvas& canvas) const override;
  bool press(const Snapshot& known, Key key, Command& command) override;
  bool leave_view() override;
  ListState* list() override {
    return state_.checks ? &state_.check_list : &state_.list;
  }
  PlotRange* range() override { return &state_.range; }
  /// Shows that FRF, with the cursor there.
  void select(std::size_t frf, std::optional<double> hz = {});
  std::vector<KeyHelp> keys(const Snapshot& known) const override;
  std::string help() const override;

 private:
  bool press_view(const Snapshot& known, Key key);
  bool press_panel(Key key);
  bool press_band(const signal::FrfSet& frfs, const signal::Frf& frf, Key key);

  FrfState state_;
};

}  // namespace tapfit::tui
