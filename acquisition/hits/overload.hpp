// Whether a channel was overdriven.
#pragma once

#include <Eigen/Core>

namespace tapfit::acquisition {

/// Whether a channel was overdriven in a block: it reaches 99.9 % of the
/// declared full scale, or its top is flat in a way that no smooth peak is.
/// Either of two things shows that. One top alone, a run of n >= 3 samples
/// within a tolerance d of the extreme, with the signal more than 49 d below it
/// half a run further on both sides: a parabola falls 4 d there, two peaks that
/// merge (t^4) 16 d, two that have just parted, as of a dented blow, 49 d. No
/// polynomial of degree 4 falls farther: it is Chebyshev's. d covers noise
/// after the clipping (6 standard deviations), a quantisation step and 1e-5 of
/// the swing.
///
/// Or all tops together, where noise covers each: below a ceiling samples lie
/// as scattered as the noise u, and few just underneath. The tops of smooth
/// peaks, where x = top - a |t|^k, have 2^(1/k) - 1 as many samples between 7
/// and 14 u as above, 4^(1/k) - 1 as many between 7 and 28 u, and scatter by
/// 2 u; the flattest to be met are two peaks that merge, k = 4. The extreme
/// must be away from where the signal rests, and the block swing ten times as
/// far as is looked at.
///
/// So clipping is found in 99 % of decays that would go beyond the ceiling by a
/// fifth to thrice, as long as the ceiling is 300 u away; at 100 to 300 u, in
/// four of five. Two peaks parted by a dip of 1 to 3 u are called clipped in
/// one of ten. Fewer than eleven samples on the ceiling (a blow's short pulse)
/// are found only as one top, two never.
///
/// @param block the channel's samples in the block, offset and all
/// @param full_scale of the channel, > 0, in the block's unit
/// @param noise standard deviation of sample-to-sample noise
[[nodiscard]] bool is_overloaded(const Eigen::Ref<const Eigen::VectorXd>& block,
                                 double full_scale,
                                 double noise);

}  // namespace tapfit::acquisition
