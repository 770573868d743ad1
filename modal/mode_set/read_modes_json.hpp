// Modes out of JSON, as `tapfit modes --json` prints them:
//
//   {"modes": [{"frequency_hz": {"value": 7.96, "sd": 0.01},
//               "damping_ratio": {"value": 0.01},
//               "shape": {"12Z+": [re, im]}, "shape_sd": {"12Z+": 0.01}}],
//    "unit_modal_mass": true}
//
// By hand plain numbers do as well ("frequency_hz": 7.96, "12Z+": 0.3), and all
// but the frequency may be left out.
#pragma once

#include "modal/mode_set/mode_set.hpp"

#include <string>

namespace tapfit::modal {

/// @param name the source's name, for messages
/// @return by frequency
/// @throws InputError for what is no JSON of modes, a point without a value in
///   one of the shapes or with two, a file without modes
[[nodiscard]] ModeSet read_modes_json(const std::string& text,
                                      const std::string& name);

}  // namespace tapfit::modal
