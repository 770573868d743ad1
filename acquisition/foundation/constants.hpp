// Numbers that every folder's equations are written with.
#pragma once

#include <numbers>

namespace tapfit {

inline constexpr double two_pi = 2.0 * std::numbers::pi;

}  // namespace tapfit
