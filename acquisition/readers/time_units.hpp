// What recorders count times in besides seconds.
#pragma once

#include <optional>
#include <string_view>

namespace tapfit::acquisition {

/// Of "s", "ms", "us" (with either letter mu) and "ns", in whatever way they
/// are written out; empty for what is no unit of time.
[[nodiscard]] std::optional<double> seconds_in(std::string_view unit);

}  // namespace tapfit::acquisition
