// tapfit model: what a finite element deck holds, and its modes.
#pragma once

#include "tui/options/command.hpp"

#include <Eigen/Core>
#include <nlohmann/json_fwd.hpp>

namespace tapfit::tui {

/// The deck in numbers.
struct ModelSummary {
  std::size_t grids = 0;
  std::size_t elements = 0;
  std::size_t dofs = 0;  ///< free ones
  double mass_kg = 0.0;
  Eigen::VectorXd frequency_hz;
  std::vector<std::string> warnings;
};

/// {"grids", "elements", "dofs", "mass_kg", "frequencies_hz", "warnings"}
[[nodiscard]] nlohmann::ordered_json model_json(const ModelSummary& summary);
[[nodiscard]] std::string model_text(const ModelSummary& summary);

/// Reads and solves the deck (or the deck of a bundle).
/// @throws InputError, Stopped
[[nodiscard]] std::string model_command(const CommandOptions& options,
                                        const Progress& progress);

}  // namespace tapfit::tui
