// Screen 3: modes, the diagram they were picked from, and their shapes.
#pragma once

#include "tui/plot_range.hpp"
#include "tui/views/page.hpp"

#include <optional>

namespace tapfit::tui {

struct ModesInput {
  const modal::ModeSet& modes;
  const signal::FrfSet* frfs = nullptr;              ///< behind the diagram
  const Wireframe* wire = nullptr;                   ///< empty: bars
  const updating::Comparison* comparison = nullptr;  ///< for MAC with the model
  std::string shifts{};  ///< what moves the poles between set-ups; or empty
};

struct ModesState {
  ListState list;
  PlotRange range;  ///< [Hz], of the diagram
  Pose pose;
  bool mac = false;     ///< MAC instead of shape and diagram
  bool moving = false;  ///< the shape swings
  double phase = 1.0;   ///< factor on the shape, -1 .. 1
  int frame = 0;
};

[[nodiscard]] Screen modes_view(const ModesInput& input,
                                const ModesState& state,
                                const Canvas& canvas);

/// Displacements of a mode at its grids, real part after the shape was turned
/// to be as real as it gets; summed over the directions measured there.
[[nodiscard]] std::map<int, Eigen::Vector3d> stems(const modal::ModeSet& modes,
                                                   std::size_t mode);

class ModesPage final : public Page {
 public:
  std::string title() const override { return "Modes"; }
  std::vector<Need> essential() const override {
    return {{Stage::Frfs}, {Stage::Modes}};
  }
  std::vector<Need> welcome(const Snapshot& known) const override;
  Screen draw(const Snapshot& known, const Canvas& canvas) const override;
  bool press(const Snapshot& known, Key key, Command& command) override;
  ListState* list() override { return &state_.list; }
  PlotRange* range() override { return &state_.range; }
  bool animate(const Snapshot& known) override;
  std::vector<KeyHelp> keys() const override;
  std::string help() const override;

 private:
  ModesState state_;
};

}  // namespace tapfit::tui
