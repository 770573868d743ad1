// The MAC of measurement and model, as all screens show it.
#pragma once

#include "tui/screen/key.hpp"
#include "tui/widgets/heat_map.hpp"

#include <Eigen/Core>

#include <cstddef>
#include <string>

namespace tapfit::tui {

/// How many of the model's modes come before the first that is no motion of a
/// rigid body: they pair with nothing and push the others off the screen.
/// @param hz of the model's modes, ascending
[[nodiscard]] int rigid_modes(const Eigen::VectorXd& hz);

/// Columns by the model's frequencies, those of rigid bodies not for show; rows
/// have no names yet.
/// @param mac n_measured x n_model
[[nodiscard]] HeatMap mac_map(const Eigen::MatrixXd& mac,
                              const Eigen::VectorXd& hz);

/// Behind the map's title: " (6 rigid-body modes left out)", or nothing.
[[nodiscard]] std::string rigid_words(const Eigen::VectorXd& hz);

/// The column one step beside, by h l and the arrows.
/// @return false for other keys
bool step_column(std::size_t& column, const Eigen::VectorXd& hz, Key key);

}  // namespace tapfit::tui
