#include "updating/fit/overall_progress.hpp"

#include <algorithm>
#include <memory>

namespace tapfit::updating {

Progress part_of(const Progress& whole, double from, double to) {
  Progress part{{}, whole.stop};
  if (!whole.report) return part;
  part.report = [report = whole.report, from, to](std::string_view stage,
                                                  double fraction) {
    report(stage, from + (to - from) * std::clamp(fraction, 0.0, 1.0));
  };
  return part;
}

Progress numbered(const Progress& whole, const std::string& what, int number) {
  Progress with_number{whole.report, whole.stop};
  if (!whole.report || number == 1) return with_number;
  with_number.report = [report = whole.report,
                        words = " (" + what + " " + std::to_string(number) +
                                ")"](std::string_view stage, double fraction) {
    report(std::string(stage) + words, fraction);
  };
  return with_number;
}

Progress monotonic(const Progress& whole) {
  Progress rising{{}, whole.stop};
  if (!whole.report) return rising;
  // Copies of it are handed down, and all of them count.
  rising.report = [report = whole.report, reached = std::make_shared<double>()](
                      std::string_view stage, double fraction) {
    *reached = std::max(*reached, fraction);
    report(stage, *reached);
  };
  return rising;
}

}  // namespace tapfit::updating
