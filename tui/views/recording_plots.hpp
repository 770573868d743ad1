// The Recording screen's plots: channels against time with hits and windows,
// and the average of the hits so far.
#pragma once

#include "tui/screen/screen.hpp"
#include "tui/views/recording_state.hpp"

namespace tapfit::tui {

/// The hammer and as many sensors as there is room for, below each other.
void draw_channels(Screen& screen,
                   const Rect& rect,
                   const RecordingInput& input,
                   const RecordingState& state,
                   std::size_t selected);

/// |H| of the first sensor shown from the hits so far, and how many they are.
void draw_average(Screen& screen,
                  const Rect& rect,
                  const RecordingInput& input,
                  const RecordingState& state);

}  // namespace tapfit::tui
