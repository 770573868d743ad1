// Screen 4: the model over the measurement, and where it fails.
#pragma once

#include "tui/plot_range.hpp"
#include "tui/views/page.hpp"

namespace tapfit::tui {

struct CompareInput {
  const updating::Comparison& comparison;
  const signal::FrfSet& frfs;
  const Wireframe* wire = nullptr;
};

struct CompareState {
  ListState list;   ///< FRFs
  PlotRange range;  ///< [Hz]
  Pose pose;
  bool log = true;
  bool structure = false;  ///< error per point instead of the pairs
};

[[nodiscard]] Screen compare_view(const CompareInput& input,
                                  const CompareState& state,
                                  const Canvas& canvas);

/// "error 38.8 % (floor 3.1 %: noise 0.9 %, mesh 2.9 %)".
[[nodiscard]] std::string error_sentence(const updating::Comparison& c);

class ComparePage final : public Page {
 public:
  std::string title() const override { return "Compare"; }
  bool wants_model() const override { return true; }
  std::vector<Need> essential() const override {
    return {{Stage::Frfs}, {Stage::Comparison}};
  }
  std::vector<Need> welcome(const Snapshot&) const override {
    return {{Stage::Model}};
  }
  Screen draw(const Snapshot& known, const Canvas& canvas) const override;
  bool press(const Snapshot& known, Key key, Command& command) override;
  ListState* list() override { return &state_.list; }
  PlotRange* range() override { return &state_.range; }
  std::vector<KeyHelp> keys() const override;
  std::string help() const override;

 private:
  CompareState state_;
};

}  // namespace tapfit::tui
