// What identification can be told.
#pragma once

#include "modal/poles/pole_edit.hpp"

#include <array>
#include <optional>
#include <vector>

namespace tapfit::modal {

struct IdentifyOptions {
  int max_order = 100;  ///< pairs of poles; cut to what the lines carry
  double frequency_tolerance = 0.01;  ///< relative, between orders
  double damping_tolerance = 0.05;    ///< relative
  double vector_tolerance = 0.02;     ///< 1 - MAC of participation vectors

  // Hard checks: a pole that fails one is no mode.
  double least_damping_ratio = 1e-6;
  double max_damping_ratio = 0.2;
  double least_mpc = 0.2;       ///< from three FRFs on
  double largest_mpd_deg = 60;  ///< from three FRFs on

  std::optional<std::array<double, 2>> band_hz;  ///< of the lines; else all
  std::vector<PoleEdit> edits;                   ///< by hand, in this order

  bool operator==(const IdentifyOptions&) const = default;
};

}  // namespace tapfit::modal
