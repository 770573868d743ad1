// The mistakes of this room, each in the file of its name, and how they show.
// None moves a pole but those of the supports and of the deck's numbers.
#pragma once

#include "updating/effects/effect.hpp"

namespace tapfit::effects {

/// A wrong sensitivity: one factor at every frequency.
[[nodiscard]] const Effect& channel_gain();
/// A channel that is late or early: the phase turns in proportion to frequency.
[[nodiscard]] const Effect& channel_delay();
/// A channel with the wrong sign: half a turn of phase at every frequency.
[[nodiscard]] const Effect& channel_polarity();
/// Two channels swapped: each sensor's shape is the other's.
[[nodiscard]] const Effect& channel_swap();
/// A sensor or blow at another grid than written down: its FRFs are another
/// point's.
[[nodiscard]] const Effect& point_mislabelled();
/// A sensor or blow along another axis than written down: its FRFs are another
/// direction's.
[[nodiscard]] const Effect& direction_wrong();
/// A channel in another unit than written down: a known factor at every
/// frequency, or once integrated.
[[nodiscard]] const Effect& unit_factor();
/// A support of the model that the structure did not have, or the reverse: the
/// first modes are others, down to the rigid ones.
[[nodiscard]] const Effect& support_mismatch();
/// A number of the deck's cards written down wrongly: modes of another order and
/// other shapes, which no change of size makes good.
[[nodiscard]] const Effect& card_swap();

}  // namespace tapfit::effects
