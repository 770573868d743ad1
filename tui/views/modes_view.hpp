// Screen 3: modes, the diagram they were picked from, and their shapes.
#pragma once

#include "tui/views/page.hpp"
#include "tui/widgets/plot_range.hpp"

#include <optional>
#include <utility>

namespace tapfit::tui {

struct ModesInput {
  const modal::ModeSet& modes;
  const signal::FrfSet* frfs = nullptr;              ///< behind the diagram
  const Wireframe* wire = nullptr;                   ///< empty: bars
  const updating::Comparison* comparison = nullptr;  ///< for MAC with the model
  std::string shifts{};  ///< what moves the poles between set-ups; or empty
  /// Behind the diagram: lines x singular values; empty: the mean |H|.
  const Eigen::MatrixXd* cmif = nullptr;
};

struct ModesState {
  ListState list;
  PlotRange range;  ///< [Hz], of the diagram
  Pose pose;
  bool mac = false;            ///< MAC instead of shape and diagram
  std::size_t mac_column = 0;  ///< the model's mode that is marked there
  bool moving = false;         ///< the shape swings
  bool turning = false;
  bool model = true;  ///< the model's shape below the measured one
  /// The model's mode to compare with, where it was asked for.
  std::optional<std::size_t> model_mode;
  double phase = 1.0;  ///< factor on the shape, -1 .. 1
  int frame = 0;
};

[[nodiscard]] Screen modes_view(const ModesInput& input,
                                const ModesState& state,
                                const Canvas& canvas);

/// Frequency, damping, MPC.
[[nodiscard]] Table mode_table(const modal::ModeSet& modes);

/// The model's shape at the deck's grids, scaled so that it fits the measured
/// one best at the measured degrees of freedom (least squares).
///
/// @param model index of the model's mode
/// @return 3 x n_grids; empty where the model has no such mode or shape
[[nodiscard]] Eigen::Matrix3Xd model_shape(const modal::ModeSet& modes,
                                           std::size_t measured,
                                           const updating::Comparison& c,
                                           std::size_t model);

class ModesPage final : public Page {
 public:
  std::string title() const override { return "Modes"; }
  std::vector<Need> essential() const override {
    return {{Stage::Frfs}, {Stage::Modes}};
  }
  std::vector<Need> welcome(const Snapshot& known) const override;
  Screen draw(const Snapshot& known, const Canvas& canvas) const override;
  bool press(const Snapshot& known, Key key, Command& command) override;
  bool leave_view() override { return std::exchange(state_.mac, false); }
  ListState* list() override { return &state_.list; }
  PlotRange* range() override { return &state_.range; }
  /// Shows a measured mode over a mode of the model.
  void select(std::size_t measured, std::size_t model);
  bool animate(const Snapshot& known) override;
  void follow(const Snapshot&, const Snapshot& now) override {
    given_ = now.bundle && now.bundle->modes;
  }
  std::vector<KeyHelp> keys(const Snapshot& known) const override;
  std::string help() const override;

 private:
  ModesState state_;
  bool given_ = false;  ///< the test consists of modes: there are no poles
};

}  // namespace tapfit::tui
