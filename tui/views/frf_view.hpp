// Screen 2: measured frequency response functions.
#pragma once

#include "tui/plot_range.hpp"
#include "tui/views/page.hpp"

namespace tapfit::tui {

struct FrfState {
  ListState list;
  PlotRange range;  ///< [Hz]
  bool log = true;
  bool band = true;  ///< the confidence band
  enum class Strip { Coherence, Phase, None } strip = Strip::Phase;
};

[[nodiscard]] Screen frf_view(const signal::FrfSet& frfs,
                              const FrfState& state,
                              const Canvas& canvas);

class FrfPage final : public Page {
 public:
  std::string title() const override { return "FRF"; }
  std::vector<Need> essential() const override { return {{Stage::Frfs}}; }
  Screen draw(const Snapshot& known, const Canvas& canvas) const override;
  bool press(const Snapshot& known, Key key, Command& command) override;
  ListState* list() override { return &state_.list; }
  void select(std::size_t frf) { state_.list = {frf, ""}; }
  std::vector<KeyHelp> keys() const override;
  std::string help() const override;

 private:
  FrfState state_;
};

}  // namespace tapfit::tui
