// Points for channels whose file names none.
#pragma once

#include "acquisition/instruments/time_record.hpp"

#include <vector>

namespace tapfit::acquisition {

/// The record's own points as they are; the others get nodes of their own,
/// from the first number that none has. Records whose names are alike but for
/// X, Y or Z at their end (a triaxial sensor's) share one; what ends with no
/// axis points along +Z.
///
/// @return a point for each record
[[nodiscard]] std::vector<Dof> points_for(
    const std::vector<const TimeRecord*>& records);

}  // namespace tapfit::acquisition
