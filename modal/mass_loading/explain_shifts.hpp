// Why poles differ between set-ups, without a model of the structure.
//
// A sensor of mass m at a point where mode r has the value phi_r (unit modal
// mass) lowers its frequency by m phi_r^2 / 2 of it, so that over set-ups k
//
//   ln w_rk = a_r - sum_q m_q g_qrk + c_k + e_rk,   g = phi^2 / 2
//
// with a_r of the mode, c_k what moves all modes of a set-up by the same
// fraction (temperature, mostly), and noise e. Whether the masses explain more
// than chance would is an F test, in which only the scatter about the fit
// counts, not how small the poles' own standard deviations are. It is made with
// c_k where c_k is significant itself.
//
// The masses are then those at which the frequencies freed of them
// (modal/mass_loading/unloaded_modes.hpp) agree best. Weights: the poles'
// variance, what the shapes' errors make of it, twice the square of the shift
// for modes not found (also of one sign for all poles), and a scatter tau^2
// that brings chi^2 to its degrees of freedom (R. C. Paule, J. Mandel, J. Res.
// NBS 87, 1982, p. 377-385); large residuals are weighted down (P. J. Huber,
// Ann. Math. Stat. 35, 1964).
#pragma once

#include "modal/mass_loading/shift_table.hpp"
#include "modal/mode_set/pole_shifts.hpp"

#include <optional>

namespace tapfit::modal {

/// Tells the cause of the shifts.
///
/// @return empty when there are too few set-ups and modes to tell anything
[[nodiscard]] std::optional<PoleShifts> explain_shifts(const ShiftData& data);

}  // namespace tapfit::modal
